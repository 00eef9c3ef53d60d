#pragma once
// Coulomb friction at the points that push a tool without mass: of all tangential forces within the cones of
// the given normal forces, those that leave the points slipping as little as they can, in the coupling's
// metric. The normal forces follow from the friction in turn: D. M. Kaufman, S. Sueda, D. L. James, D. K.
// Pai, "Staggered projections for frictional contact in multibody systems", ACM Trans. Graphics 27(5), 2008.
// A point has no extent: by itself it resists being spun on the spot, or rolled, only where the scene names
// torsional or rolling friction.

#include <span>
#include <string>

#include "haptics/contact/contact_desc.h"
#include "haptics/math/linear.h"

namespace fulcrum {

struct RubbingPoint {
  Vec3 nhat_W = Vec3::Zero();    // (3) unit, out of the scene
  Vec3 r_W = Vec3::Zero();       // (3) m, from T
  Vec3 slip_W = Vec3::Zero();    // (3) m, how far it has moved in this tick before the step
  double normal_force = 0;       // N
  Vec3 force_W = Vec3::Zero();   // (3) N on the tool, tangential: a guess, and then the answer
  Vec3 torque_W = Vec3::Zero();  // (3) N m on the tool, likewise
  double mobility = 0;  // m/N, of the answer: how far at most it gives way to a force along its surface
};

// metric: (6) of the coupling. step: (6) m and rad in W about T, the tool's motion under the points' forces
// as they are guessed; it becomes that under the answer. turned_W: (3) rad, how far the tool has turned in
// this tick before the step. Answers what the points give together, (6) N and N m about T.
Vec6 rub(const Vec6& metric, const ContactDesc& contact, Vec6& step, const Vec3& turned_W,
         std::span<RubbingPoint> points) noexcept;

// For parts(): what there is of it; empty without.
std::string friction_note(const ContactDesc& contact);

}  // namespace fulcrum
