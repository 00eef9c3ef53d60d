#pragma once
// An axis of a plot: from values to places along it, and where its tick marks go.

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fulcrum::report {

enum class Scale { linear, logarithmic };

struct AxisDesc {
  std::string title;
  std::string unit;  // shown in brackets after the title; empty: none
  Scale scale = Scale::linear;
  std::optional<double> low, high;   // what is not given follows from the values
  std::vector<std::string> names{};  // of the places 0, 1, 2, ...: words instead of numbers; linear alone
};

struct Tick {
  double value = 0;
  std::string label;  // empty: a minor mark
};

class Axis {
public:
  // values: everything that is to be seen on it. Those that it cannot show (not finite; not positive on a
  // logarithmic axis) count for nothing.
  Axis(const AxisDesc& desc, std::span<const double> values);

  double low() const { return low_; }
  double high() const { return high_; }
  bool shows(double value) const;  // finite, and positive on a logarithmic axis
  // 0 at low, 1 at high; beyond them for values beyond. The value must be one that the axis shows.
  double place(double value) const;
  // In order. Linear: steps of 1, 2 or 5 times a power of ten. Logarithmic: powers of ten with labels and
  // their multiples without; over two powers and less the multiples 2 and 5 have labels too.
  std::vector<Tick> ticks() const;

private:
  std::vector<Tick> linear_ticks() const;
  std::vector<Tick> logarithmic_ticks() const;

  Scale scale_;
  std::vector<std::string> names_;
  double low_ = 0, high_ = 1;
};

// A number beside an axis or in a table: 0.02, 1500, 10⁻⁶, 2·10⁷.
std::string short_number(double value, int digits = 6);

}  // namespace fulcrum::report
