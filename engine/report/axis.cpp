#include "engine/report/axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/math/number_text.h"

namespace fulcrum::report {
namespace {

constexpr int kWantedTicks = 6;
constexpr double kRounding = 1e-9;  // of a step: a mark this little beyond the end is at the end

// 1, 2 or 5 times a power of ten, at least `least`.
double round_step(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least) + kRounding));
  for (const double times : {1.0, 2.0, 5.0})
    if (times * power >= least * (1 - kRounding)) return times * power;
  return 10 * power;
}

std::string superscript(int exponent) {
  static constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "⁻" : "";
  for (const char c : std::to_string(std::abs(exponent))) text += digits[c - '0'];
  return text;
}

}  // namespace

std::string short_number(double value, int digits) {
  if (std::isnan(value)) return "—";
  if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
  const std::string sign = value < 0 ? "−" : "";
  const double size = std::abs(value);
  if (size == 0) return "0";
  const int exponent = static_cast<int>(std::floor(std::log10(size) + kRounding));
  if (exponent >= -3 && exponent < 6) {
    // No exponent for 1500 with two digits either.
    const double unit = std::pow(10.0, exponent + 1 - digits);
    return sign + number_text(std::round(size / unit) * unit, std::max(digits, exponent + 1));
  }
  const std::string mantissa = number_text(size / std::pow(10.0, exponent), digits);
  return sign + (mantissa == "1" ? "" : mantissa + "·") + "10" + superscript(exponent);
}

Axis::Axis(const AxisDesc& desc, std::span<const double> values) : scale_(desc.scale), names_(desc.names) {
  if (!names_.empty()) {  // half a place of room on either side
    low_ = -0.5;
    high_ = static_cast<double>(names_.size()) - 0.5;
    return;
  }
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const double value : values) {
    if (!shows(value)) continue;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  if (!(least <= most)) least = most = 1;
  least = std::min(least, desc.low.value_or(least));
  most = std::max(most, desc.high.value_or(most));
  if (scale_ == Scale::linear) {
    const double span = most > least ? most - least : std::max(std::abs(most), 1.0);
    const double step = round_step(span / kWantedTicks);
    low_ = desc.low.value_or(std::floor(least / step + kRounding) * step);
    high_ = desc.high.value_or(std::ceil(most / step - kRounding) * step);
    if (!(high_ > low_)) high_ = low_ + step;
  } else {
    // The nearest 1, 2 or 5 times a power of ten on either side.
    low_ = desc.low.value_or(1 / round_step(1 / least));
    high_ = desc.high.value_or(round_step(most));
    if (!(high_ > low_)) high_ = 10 * low_;
  }
}

bool Axis::shows(double value) const {
  return std::isfinite(value) && (scale_ == Scale::linear || value > 0);
}

double Axis::place(double value) const {
  return scale_ == Scale::linear ? (value - low_) / (high_ - low_)
                                 : std::log(value / low_) / std::log(high_ / low_);
}

std::vector<Tick> Axis::ticks() const {
  if (!names_.empty()) {
    std::vector<Tick> ticks;
    for (const std::string& name : names_) ticks.push_back({static_cast<double>(ticks.size()), name});
    return ticks;
  }
  return scale_ == Scale::linear ? linear_ticks() : logarithmic_ticks();
}

std::vector<Tick> Axis::linear_ticks() const {
  const double step = round_step((high_ - low_) / kWantedTicks);
  std::vector<Tick> ticks;
  const auto last = static_cast<long>(std::floor(high_ / step + kRounding));
  for (auto i = static_cast<long>(std::ceil(low_ / step - kRounding)); i <= last; ++i) {
    const double value = static_cast<double>(i) * step;
    ticks.push_back({value, short_number(value)});
  }
  return ticks;
}

std::vector<Tick> Axis::logarithmic_ticks() const {
  const double powers = std::log10(high_ / low_);
  // Over many powers only every second, third ... has a mark.
  const int stride = std::max(1, static_cast<int>(std::ceil(powers / (2 * kWantedTicks))));
  std::vector<Tick> ticks;
  const int first = static_cast<int>(std::floor(std::log10(low_) + kRounding));
  const int last = static_cast<int>(std::ceil(std::log10(high_) - kRounding));
  for (int exponent = first; exponent <= last; ++exponent) {
    for (int times = 1; times < 10; ++times) {
      // Powers of ten up to 22 are exact: divided by, 3e-5 is the double nearest to it.
      const double power = std::pow(10.0, std::abs(exponent));
      const double value = exponent < 0 ? times / power : times * power;
      if (value < low_ * (1 - kRounding) || value > high_ * (1 + kRounding)) continue;
      if (times > 1 && stride > 1) continue;
      const bool labelled =
          times == 1 ? exponent % stride == 0 : powers < 2.5 && (times == 2 || times == 5 || powers < 0.7);
      ticks.push_back({value, labelled ? short_number(value) : ""});
    }
  }
  return ticks;
}

}  // namespace fulcrum::report
