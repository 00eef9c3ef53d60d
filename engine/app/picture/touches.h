#pragma once
// Where the scene touches the tool in a tick, and how hard at each place: for pictures. A tick's record has
// the whole wrench of contact and not its places, so these are looked for again at the pose that it left, and
// the wrench is shared among them: normal forces f_i >= 0 that come nearest to it,
//     min | sum_i f_i [nhat_i; (p_i - p_WT) x nhat_i / r] - [f; tau / r] |^2
// (C. L. Lawson, R. J. Hanson, "Solving Least Squares Problems", 1974, chapter 23). r is long, ten times the
// tool's radius: the force is to be what was felt, and the torque, which has the coupling's damping in it,
// tells where. What is left over is friction. Nothing of it is in a tick: a scene pays for it only while it
// is shown.

#include <optional>
#include <vector>

#include "haptics/contact/feature_pairs.h"
#include "haptics/contact/query.h"
#include "haptics/contact/regions.h"
#include "haptics/scene/plain_scene.h"
#include "haptics/world/tick_record.h"

namespace fulcrum::app {

// A region of touch.
struct Touch {
  Vec3 p_W = Vec3::Zero();     // (3) m, its centre of pressure
  Vec3 nhat_W = Vec3::Zero();  // (3) unit, out of the scene
  double force = 0;            // N, along it
};

class TouchFinder {
public:
  explicit TouchFinder(const PlainScene& scene);

  // The hardest first; none where the scene does not push.
  std::vector<Touch> find(const TickRecord& record);

private:
  void look(const Pose& X_WT);

  double arm_;                            // m, r
  double margin_;                         // m, farther from the scene nothing touches
  std::optional<FeaturePairs> features_;  // where contact is measured on triangles; else:
  std::optional<ContactQuery> query_;
  std::optional<ContactQuery> edges_;  // of the scene, against the tool
  RegionTracker regions_;
  ContactSet contacts_;
};

}  // namespace fulcrum::app
