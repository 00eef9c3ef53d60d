#pragma once
// How smooth a movement was: the spectral arc length of its speed. S. Balasubramanian, A. Melendez-Calderon,
// A. Roby-Brami, E. Burdet, "On the analysis of movement smoothness", J. NeuroEngineering and Rehabilitation
// 12:112, 2015, with the figures of their program: 10 Hz, a threshold of 0.05, sixteenfold padding.

#include <optional>
#include <span>

namespace fulcrum::session {

// speed: (n) m/s, at equal intervals. Below zero, and the nearer to zero the smoother; a single bell-shaped
// reach has about -1.6. It does not depend on how fast or how far the movement went. None: nothing moved, or
// there are fewer than 20 samples, or they are too sparse for 10 Hz.
std::optional<double> spectral_arc_length(std::span<const double> speed, double interval);

}  // namespace fulcrum::session
