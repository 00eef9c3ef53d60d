#pragma once
// Student's t distribution: how far a mean of few values may lie from the truth.

namespace fulcrum::analysis::compare {

// t with P(T < t) = p, for a whole number of degrees of freedom, at least 1. p: above 0 and below 1.
double t_quantile(double p, int degrees);

}  // namespace fulcrum::analysis::compare
