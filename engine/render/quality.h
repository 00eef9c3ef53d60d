#pragma once
// How much work a picture may cost, and choosing that from measured frame times.

#include <array>
#include <cstddef>

namespace fulcrum::render {

struct Quality {
  int samples = 4;                // per pixel: 1 or 4
  int shadow_size = 2048;         // pixels on a side of the shadow map; 0: no shadows
  float resolution_scale = 1.0F;  // 0.25..1: the scene is drawn smaller and enlarged; text stays sharp
  float coarseness = 0.25F;       // pixels that coarser triangles may be off by; 0: there are none
  bool occlusion = true;          // near things hide light from all around from each other
  bool soft_shadows = true;       // their edges are as wide as the light's size makes them
  int scattering = 16;            // samples per pixel of light that spreads below surfaces; 0: it does not
  bool reflections = true;        // metal mirrors what stands near it

  bool operator==(const Quality&) const = default;
};

// From the best to the cheapest. What is given up first is the sharpness of edges, then of the whole: by its
// shadow one sees how far something is away from what it is about to touch, so that goes last.
inline constexpr std::array<Quality, 5> kQualityLevels = {{
    {4, 2048, 1.0F, 0.25F, true, true, 16, true},
    {1, 2048, 1.0F, 0.5F, true, true, 8, true},
    {1, 1024, 0.5F, 0.5F, true, false, 0, false},
    {1, 1024, 0.42F, 0.5F, true, false, 0, false},
    {1, 512, 0.35F, 1.0F, false, false, 0, false},
}};

// Picks one of those levels so that a frame takes less than its budget. It begins with the cheapest and goes
// up for as long as that holds: whoever waits sees something at once. A level that proves too slow is left
// again, and tried anew after a pause that doubles. A step down that gains little is taken back: where
// vertices or the processor are what takes long, fewer pixels only blur. Only for windows: a picture that
// goes to a file must not depend on how busy the machine is.
class AutoQuality {
public:
  // `budget_s`: what a frame may take.
  explicit AutoQuality(double budget_s = 1.0 / 30.0) : budget_s_(budget_s) {}

  // Tells it the time one frame took (s, without waiting for the screen); true when quality() has changed.
  bool add(double frame_s);
  // quality() cannot be had, such as where graphics memory is short: it is the next cheaper now, and no
  // better one is chosen any more. False: there is none cheaper.
  bool refuse();

  const Quality& quality() const { return kQualityLevels[level_]; }

private:
  static constexpr std::size_t kWindow = 8;     // frames that a decision looks at, at the most
  static constexpr std::size_t kUncounted = 3;  // drivers compile shaders while drawing the first ones
  static constexpr std::size_t kLowest = kQualityLevels.size() - 1;
  enum class Step { none, up, down };

  bool has_seen_enough() const;
  double take_median();
  // What to do about the last step, now that frames take so long: false: it has been taken back.
  bool keeps_step(double median);
  void go_to(std::size_t level, Step step, double median);

  double budget_s_;
  std::size_t level_ = kLowest;
  std::size_t best_possible_ = 0;        // better ones were refused
  std::size_t best_allowed_ = 0;         // better ones proved too slow
  std::size_t worst_allowed_ = kLowest;  // cheaper ones gained little
  double learnt_s_ = 0.0;                // what a frame took when that was found
  double pause_s_ = 20.0;                // after which these are forgotten
  double since_s_ = 0.0;                 // that they have been known
  Step judged_ = Step::none;             // the step that the next decision looks at
  std::size_t came_from_ = 0;            // the level before it
  double before_s_ = 0.0;                // the median there
  double beyond_s_ = 0.0;  // what a frame took where the climb beyond the budget began; 0: there was none
  std::size_t skip_ = kUncounted;
  std::array<double, kWindow> times_{};
  std::size_t count_ = 0;
  double seen_s_ = 0.0;  // that they took together
};

}  // namespace fulcrum::render
