#pragma once
// Keeps the first figure that is out of its range.

#include <cmath>
#include <optional>
#include <string>

#include "haptics/math/number_text.h"
#include "haptics/math/pose.h"
#include "haptics/math/result.h"

namespace fulcrum {

class FigureCheck {
public:
  // No quantity of a scene is larger, in SI units: a figure that is was mistaken, and its square might
  // overflow.
  static constexpr double kLargest = 1e12;
  static constexpr double kLongestTime = 1e3;  // s, of what happens within a tick or a touch
  static constexpr double kFastest_Hz = 1e6;

  void above(const std::string& name, double value, double low = 0) {
    require(value > low && value <= kLargest, name, value, "above " + number_text(low));
  }
  void at_least(const std::string& name, double value, double low = 0) {
    require(value >= low && value <= kLargest, name, value, number_text(low) + " or more");
  }
  void from_to(const std::string& name, double value, double low, double high) {
    require(value >= low && value <= high, name, value,
            "from " + number_text(low) + " to " + number_text(high));
  }
  void above_to(const std::string& name, double value, double low, double high) {
    require(value > low && value <= high, name, value,
            "above " + number_text(low) + " and at most " + number_text(high));
  }
  void finite(const std::string& name, double value) {
    require(std::abs(value) <= kLargest, name, value, "finite");
  }

  void finite(const std::string& name, const Vec3& v) {
    each(
        name, v, [this](const std::string& n, double x) { finite(n, x); });
  }
  void above(const std::string& name, const Vec3& v) {
    each(
        name, v, [this](const std::string& n, double x) { above(n, x); });
  }
  void at_least(const std::string& name, const Vec3& v) {
    each(
        name, v, [this](const std::string& n, double x) { at_least(n, x); });
  }
  void symmetric(const std::string& name, const Mat3& I) {
    for (Eigen::Index row = 0; row < 3; ++row) finite(name, Vec3(I.row(row)));
    const double size = I.norm();
    from_to("the asymmetry of " + name, (I - I.transpose()).norm(), 0, kUnit * size);
  }
  void direction(const std::string& name, const Vec3& v) {
    finite(name, v);
    above("the length of " + name, v.norm());
  }
  void unit(const std::string& name, const Vec3& v) {
    finite(name, v);
    from_to("the length of " + name, v.norm(), 1 - kUnit, 1 + kUnit);
  }
  void rotation(const std::string& name, const Quat& q) {
    finite(name + ".w", q.w());
    finite(name, Vec3(q.vec()));
    from_to("the length of " + name, q.norm(), 1 - kUnit, 1 + kUnit);
  }
  void pose(const std::string& name, const Pose& X) {
    rotation(name + ".orientation", X.q);
    finite(name + ".position", X.p);
  }

  const std::optional<Error>& error() const { return error_; }

private:
  static constexpr double kUnit = 1e-6;

  void require(bool holds, const std::string& name, double value, const std::string& range) {
    if (holds || error_) return;
    error_ = Error{name + " is " + number_text(value) + "; it must be " + range + "."};
  }
  template <class Check>
  void each(const std::string& name, const Vec3& v, const Check& check) {
    const char* const axes[] = {".x", ".y", ".z"};
    for (Eigen::Index i = 0; i < 3; ++i) check(name + axes[i], v[i]);
  }

  std::optional<Error> error_;
};

}  // namespace fulcrum
