#include "engine/session/smoothness.h"

#include <bit>
#include <cmath>
#include <complex>
#include <cstddef>
#include <unsupported/Eigen/FFT>
#include <vector>

namespace fulcrum::session {
namespace {

constexpr double kHighest_Hz = 10;
constexpr double kThreshold = 0.05;  // of the spectrum at rest
constexpr std::size_t kPadding = 16;
constexpr std::size_t kFewest = 20;

}  // namespace

std::optional<double> spectral_arc_length(std::span<const double> speed, double interval) {
  if (speed.size() < kFewest || !(interval > 0) || interval > 0.5 / kHighest_Hz) return std::nullopt;
  std::vector<double> padded(std::bit_ceil(speed.size()) * kPadding, 0.0);
  for (std::size_t i = 0; i < speed.size(); ++i) {
    if (!std::isfinite(speed[i])) return std::nullopt;
    padded[i] = speed[i];
  }
  std::vector<std::complex<double>> spectrum;
  Eigen::FFT<double> transform;
  transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  transform.fwd(spectrum, padded);

  const double step_Hz = 1 / (interval * static_cast<double>(padded.size()));
  std::vector<double> magnitude;
  std::size_t end = 0;  // beyond the last one above the threshold
  for (std::size_t i = 0; i < spectrum.size() && static_cast<double>(i) * step_Hz <= kHighest_Hz; ++i) {
    magnitude.push_back(std::abs(spectrum[i]) / std::abs(spectrum[0]));
    if (magnitude.back() >= kThreshold) end = i + 1;
  }
  // A spectrum without a mean has no number here: the comparison above fails then, as for one that is zero.
  if (end < 2) return std::nullopt;
  const double step = 1 / static_cast<double>(end - 1);
  double length = 0;
  for (std::size_t i = 1; i < end; ++i) length += std::hypot(step, magnitude[i] - magnitude[i - 1]);
  return -length;
}

}  // namespace fulcrum::session
