#include "tools/content/teeth/explorer.h"

#include "haptics/math/functions.h"
#include "tools/content/mesh/profile.h"
#include "tools/content/mesh/round_bar.h"

namespace fulcrum::content {
namespace {

constexpr int columns = 28;

// The axis, walked from the tip: straight up, over the hook, down a little, and out along shank and handle.
constexpr Stretch stretches[] = {
    {4.5 * mm, 0.0}, {8.6 * mm, 98 * degree}, {4.5 * mm, 0.0}, {7.5 * mm, -44 * degree}, {128 * mm, 0.0},
};
constexpr double handle_begins = 45 * mm;  // along the axis, from the tip

// The radius along the axis: a fine point, the taper of the working end, the shank, a collar, the handle.
const Profile& radius() {
  static const Profile profile({{0, explorer_tip_radius},
                                {1 * mm, 0.27 * mm},
                                {8 * mm, 0.5 * mm},
                                {18 * mm, 0.85 * mm},
                                {30 * mm, 1.25 * mm},
                                {38 * mm, 1.55 * mm},
                                {handle_begins, 3.1 * mm},
                                {handle_begins + 3 * mm, 3.5 * mm},
                                {handle_begins + 24 * mm, 3.0 * mm},
                                {handle_begins + 45 * mm, 3.6 * mm},
                                {handle_begins + 95 * mm, 3.6 * mm},
                                {handle_begins + 104 * mm, 3.2 * mm}});
  return profile;
}

// Rings cut into the grip, and a few more near the handle's end.
double cut(double along) {
  const double grip = along - handle_begins;
  const bool at_grip = grip > 5 * mm && grip < 29 * mm;
  const bool at_end = grip > 84 * mm && grip < 93 * mm;
  if (!at_grip && !at_end) return 0.0;
  const double wave = 0.5 - 0.5 * math::cos(2.0 * pi * (grip - 5 * mm) / (1.5 * mm));
  return 0.35 * mm * wave * wave;
}

double step(double along) {
  if (along < 14 * mm) return 0.35 * mm;
  const double grip = along - handle_begins;
  const bool ringed = (grip > 4 * mm && grip < 30 * mm) || (grip > 83 * mm && grip < 94 * mm);
  return ringed ? 0.19 * mm : 0.7 * mm;
}

}  // namespace

Model make_explorer() {
  Model model{.name = "explorer",
              .materials = {{.name = "surgical steel",
                             .base_colour = {0.56, 0.56, 0.57},
                             .metallic = 1.0,
                             .roughness = 0.26}},
              .parts = {}};
  const auto cut_radius = [](double along) { return radius()(along) - cut(along); };
  model.parts.push_back({.name = "explorer",
                         .material = 0,
                         .solid = round_bar(stretches, 0.0, cut_radius, step, columns),
                         .crease = 50 * degree});
  return model;
}

}  // namespace fulcrum::content
