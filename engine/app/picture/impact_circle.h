#pragma once
// The circle of confusion, drawn about the tool: where else an impact would have turned the hand about the
// same axis,
//     { r e_r : e_r perpendicular to tau }      J. Sreng et al., "Spatialized haptic rendering", 2009
// about the manipulation point. With the axis alone all of these feel alike; the frequency tells r.

#include <optional>
#include <string>

#include "engine/render/visual_desc.h"
#include "engine/scenario/followed.h"
#include "haptics/effects/effects.h"
#include "haptics/world/tick_record.h"

namespace fulcrum::app {

// Why there is no circle to draw: no impact vibrates on this device. It is known before anything is baked.
std::optional<Error> refuse_impact_circle(const std::string& scenario, const EffectDescs& effects,
                                          const DeviceDesc& device);

// Of the newest impact that was felt, in T as it was then.
struct StruckPlace {
  double time = 0;               // s
  Vec3 centre_T = Vec3::Zero();  // (3) m, the manipulation point
  Vec3 axis_T = Vec3::Zero();    // (3) unit; zero where it turned about none, and there is no circle
  double radius = 0;             // m
  std::optional<Vec3> p_T;       // (3) m, where it fell; none where a harder one fell in the same tick
};

// p_TH: (3) m, the manipulation point, where the tool has it. Nothing where no vibration began in that tick.
std::optional<StruckPlace> struck_place(const TickRecord& record, const Vec3& p_TH, double time);

// Appends the circle's pieces and the dot where the impact fell. They follow kFollowsImpactCircle and those
// after it.
void add_impact_circle(render::VisualDesc& desc);

// Of the piece that follows `body`. Thinner and thinner from kSeen on, and then nowhere.
glm::mat4 impact_circle_pose(std::size_t body, const std::optional<StruckPlace>& struck, const Pose& X_WT,
                             double time);

inline constexpr double kSeen = 3;  // s

}  // namespace fulcrum::app
