#pragma once
// A stick, held somewhere along it, that meets a ball from above: what a device's mass is felt on. Built in
// code, so that every figure of it is known.

#include <memory>

#include "haptics/world/scene_desc.h"

namespace fulcrum::analysis::uniformity {

inline constexpr double kStickLength = 0.2;    // m, from C, the handle's origin, along +x of H
inline constexpr double kStickRadius = 4e-3;   // m
inline constexpr double kBallRadius = 0.04;    // m; its top is W's origin
inline constexpr double kPointSpacing = 5e-3;  // m along the stick: each place that is touched has one

struct StickBodies {
  std::shared_ptr<const Pointshell> stick;  // in H
  std::shared_ptr<const DistanceField> ball;
};
StickBodies stick_bodies();

struct StickTouch {
  double place = 0;        // m along the stick from C, that lies over the ball's top
  double held = 0;         // m, where the hand holds it
  double stiffness = 300;  // N/m, of the ball
};

// Direct rendering, world's axes the device's. The stick just touches where the handle is at D's origin; its
// mass and weight play no part.
SceneDesc stick_scene(const StickBodies& bodies, const DeviceDesc& device, const StickTouch& touch,
                      const InertiaCompensationDesc& compensation);

}  // namespace fulcrum::analysis::uniformity
