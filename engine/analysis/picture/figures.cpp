#include "engine/analysis/picture/figures.h"

#include <algorithm>
#include <numeric>

#include "engine/analysis/picture/colour.h"

namespace fulcrum::analysis::picture {
namespace {

double light_of(const Image& image) {
  double sum = 0;
  for (const std::array<float, 3>& pixel : image.pixels)
    sum += luminance({decoded(pixel[0]), decoded(pixel[1]), decoded(pixel[2])});
  return sum;
}

// By nearest rank.
double percentile_99(std::vector<double> values) {
  const std::size_t rank = (values.size() * 99 + 99) / 100 - 1;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rank), values.end());
  return values[rank];
}

}  // namespace

LevelFigures compared(const Image& reference, const Image& test, std::vector<double>& map) {
  map = flip(reference, test);
  LevelFigures figures;
  figures.flip_mean = std::accumulate(map.begin(), map.end(), 0.0) / static_cast<double>(map.size());
  figures.flip_p99 = percentile_99(map);
  const double light = light_of(reference);
  figures.luminance_error = light > 0 ? light_of(test) / light - 1 : 0;
  return figures;
}

Image coloured(const std::vector<double>& map, std::size_t width) {
  static constexpr std::array<std::array<float, 3>, 5> kRamp = {{{0, 0, 0},
                                                                 {0.32F, 0.07F, 0.48F},
                                                                 {0.76F, 0.22F, 0.45F},
                                                                 {0.98F, 0.58F, 0.38F},
                                                                 {0.99F, 0.98F, 0.78F}}};
  Image image{width, map.size() / width, {}};
  for (const double value : map) {
    const double place = std::clamp(value, 0.0, 1.0) * (kRamp.size() - 1);
    const std::size_t from = std::min(static_cast<std::size_t>(place), kRamp.size() - 2);
    const auto share = static_cast<float>(place - static_cast<double>(from));
    std::array<float, 3> colour{};
    for (std::size_t i = 0; i < 3; ++i)
      colour[i] = kRamp[from][i] + share * (kRamp[from + 1][i] - kRamp[from][i]);
    image.pixels.push_back(colour);
  }
  return image;
}

}  // namespace fulcrum::analysis::picture
