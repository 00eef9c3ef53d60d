#pragma once
// How deep the tool went into the scene: its vertices against the scene's triangles, exactly, at stored
// poses.

#include <memory>
#include <optional>
#include <vector>

#include "haptics/bake/solid.h"
#include "haptics/bake/triangle_distance.h"
#include "haptics/geometry/distance_field.h"
#include "haptics/world/tick_record.h"

namespace fulcrum::app {

class PenetrationMeter {
public:
  PenetrationMeter(double tick_s);

  // Keeps the pose every 10 ms, and of each 10 ms the one that is deepest by the field.
  void note(const TickRecord& record);

  // The largest depth of a vertex of tool_T over the poses kept, m; 0 when none was inside. A vertex that is
  // outside by the field's proven bound is not measured.
  double deepest(const Solid& scene_W, const Solid& tool_T, const DistanceField& field) const;

private:
  std::int64_t every_ticks_;
  std::vector<Pose> poses_;
  std::optional<Pose> worst_;
  double worst_depth_ = 0;
};

}  // namespace fulcrum::app
