#pragma once
// What is to be heard of a run, from its ticks' records: blows, and how the tool slides.
//
// Where impacts are detected for an effect, a blow is such an impact. Elsewhere nothing in the tick is built
// for sound, and a blow is read from what every record has: the tool touches after it had not for kApart, and
// the hand approaches. Its place is then where the tool lies deepest (deepest_point.h), and its speed that of
// the hand over the kOver before, against the scene's normal there. The place of sliding is found in the same
// way, every kApart of touch.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "engine/audio/deepest_point.h"
#include "engine/audio/scene_sound.h"
#include "haptics/world/tick_record.h"

namespace fulcrum::audio {

struct Blow {
  Vec3 p_W = Vec3::Zero();  // (3) m
  double speed = 0;         // m/s, > 0
  double radius = 0;        // m, from the handle
  std::int32_t object = 0;  // of the scene
};

struct Slide {
  Vec3 p_W = Vec3::Zero();  // (3) m
  double speed = 0;         // m/s, of the tool along what it touches
  double force = 0;         // N, of contact
};

struct Heard {
  std::optional<Blow> blow{};
  std::optional<Slide> slide{};  // none: nothing touches, or the run is stopped
};

class TickListener {
public:
  static constexpr double kApart = 0.05;  // s without touch, after which touch is a blow again
  static constexpr double kOver = 5e-3;   // s, over which the hand's speed is taken: encoders come in steps
  static constexpr double kLeast = 0.01;  // m/s, of approach; slower is no blow

  explicit TickListener(const SceneSound& desc);

  // Records in order; some may be missing.
  Heard next(const TickRecord& record);

private:
  struct Place {
    std::int64_t tick = 0;
    Pose X_WH;
  };
  static constexpr std::size_t kPlaces = 128;  // kOver at the fastest loop a scenario may ask for

  void look(const TickRecord& record);
  std::optional<Blow> struck(const TickRecord& record) const;
  std::int32_t object_at(const Vec3& p_W) const { return objects_ ? objects_->nearest(p_W) : 0; }
  const Place& place_before(std::int64_t tick) const;
  void remember(const TickRecord& record);

  double tick_s_;
  std::shared_ptr<const ObjectMap> objects_;
  DeepestPointFinder finder_;
  std::int64_t apart_ticks_, over_ticks_;
  std::int64_t touched_at_;            // tick of the last touch
  std::optional<DeepestPoint> touch_;  // as it was found last, while there is one
  std::int64_t looked_at_ = 0;         // tick
  std::array<Place, kPlaces> places_{};
  std::size_t count_ = 0;  // of all that were remembered
};

}  // namespace fulcrum::audio
