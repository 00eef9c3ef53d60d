#pragma once
// How much work a picture may cost, and choosing that from measured frame times.

#include <array>
#include <cstddef>

namespace fulcrum::render {

struct Quality {
  int samples = 4;                // per pixel: 1 or 4
  int shadow_size = 2048;         // pixels on a side of the shadow map; 0: no shadows
  float resolution_scale = 1.0F;  // 0.25..1: the scene is drawn smaller and enlarged; text stays sharp
  bool occlusion = true;          // near things hide light from all around from each other

  bool operator==(const Quality&) const = default;
};

// From the best to the cheapest; each is about half the work of the one before.
inline constexpr std::array<Quality, 5> kQualityLevels = {{
    {4, 2048, 1.0F, true},
    {1, 2048, 1.0F, true},
    {1, 1024, 0.75F, true},
    {1, 1024, 0.5F, true},
    {1, 0, 0.5F, false},
}};

// Picks one of those levels so that a frame takes less than its budget. A step down that gains little is
// taken back and not tried again: where vertices or the processor are what takes long, fewer pixels only
// blur. Only for windows: a picture that goes to a file must not depend on how busy the machine is.
class AutoQuality {
public:
  // Starts at the best level. `budget_s`: what a frame may take.
  explicit AutoQuality(double budget_s = 1.0 / 30.0) : budget_s_(budget_s) {}

  // Tells it the time one frame took (s, without waiting for the screen); true when quality() has changed.
  bool add(double frame_s);

  const Quality& quality() const { return kQualityLevels[level_]; }

private:
  static constexpr std::size_t kWindow = 15;  // frames that a decision looks at, at the most

  bool has_seen_enough() const;
  void go_to(std::size_t level);

  double budget_s_;
  std::size_t level_ = 0;
  std::size_t best_allowed_ = 0;                           // a level that proved too slow is not tried again
  std::size_t worst_allowed_ = kQualityLevels.size() - 1;  // nor one that gained little
  std::size_t came_from_ = 0;                              // the level before the last step down
  double before_s_ = 0;                                    // the median there; 0: no step down to judge
  std::size_t skip_ = 3;  // frames not counted: drivers compile shaders while drawing the first ones
  std::array<double, kWindow> times_{};
  std::size_t count_ = 0;
  double seen_s_ = 0;  // that they took together
};

}  // namespace fulcrum::render
