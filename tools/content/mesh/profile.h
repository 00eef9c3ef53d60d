#pragma once

#include <vector>

namespace fulcrum::content {

struct Knot {
  double at = 0.0;
  double value = 0.0;
};

// A curve through knots that does not swing beyond them: cubic pieces with slopes limited after F. Fritsch
// and R. Carlson, "Monotone piecewise cubic interpolation", 1980. Level before the first knot and after the
// last.
class Profile {
public:
  Profile() : Profile(std::vector<Knot>(1)) {}
  Profile(std::vector<Knot> knots);  // NOLINT: a list of knots is a profile
  double operator()(double at) const;

private:
  std::vector<Knot> knots_;
  std::vector<double> slopes_;
};

}  // namespace fulcrum::content
