#pragma once
// How deep the tool and the scene went into each other in a run: both surfaces, exactly, at the ticks where
// it was worst.
//
// The pose of every tick is kept. Between two ticks that were measured the depth is at most half of their
// depths and of the way that the tool's farthest point went, together; where the tool was clear of the scene
// its clearance counts as a depth below nothing. The tick in the middle of the way that could hide most is
// measured next, until no tick can be deeper than what was found, or a stated amount of work is done.

#include <cstdint>
#include <vector>

#include "haptics/bake/overlap_depth.h"
#include "haptics/world/tick_record.h"

namespace fulcrum::app {

struct Penetration {
  double depth = 0;         // m, the deepest that was found
  double within = 0;        // m, no tick was deeper than depth + within
  double at = 0;            // s, simulated time
  Vec3 p_W = Vec3::Zero();  // (3) m, the deepest point
};

class PenetrationMeter {
public:
  explicit PenetrationMeter(double tick_s) : tick_s_(tick_s) {}

  void note(const TickRecord& record);

  // field: of scene_W, or none.
  Penetration deepest(const Solid& scene_W, const Solid& tool_T, const DistanceField* field) const;

private:
  struct Sample {
    std::int64_t tick;
    Pose X_WT;
    double field_depth;    // m, what the tick itself saw
    double turned, moved;  // rad and m, since the run began: sums over the ticks
  };
  void thin();

  double tick_s_;
  std::vector<Sample> samples_;
  std::int64_t every_ticks_ = 1;  // more than one once a long run was thinned
  Sample last_{};
};

}  // namespace fulcrum::app
