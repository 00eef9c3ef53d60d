#pragma once
// A peg between two walls: the canonical bad torque. Two corners jam and press with torque / lever each, and
// the hand feels no force.

#include <vector>

#include "haptics/math/rotation.h"
#include "tests/haptics/scenes.h"

namespace fulcrum::test {

struct PegDesc {
  double slot = 10.1e-3, width = 10e-3, length = 30e-3;  // m
  ContactResponse response = ContactResponse::constraint;
  double stiffness = 40000;  // N/m, of each corner under springs
};

// The walls stand along y and x is across; a third one closes the slot at z = 20 mm.
inline SceneDesc peg_scene(const PegDesc& peg) {
  const double w = peg.width / 2, l = peg.length / 2;
  const TriangleMesh walls[] = {box_mesh({-0.04, -0.03, -0.018}, {-peg.slot / 2, 0.03, 0.018}),
                                box_mesh({peg.slot / 2, -0.03, -0.018}, {0.04, 0.03, 0.018}),
                                box_mesh({-0.04, -0.03, 0.02}, {0.04, 0.03, 0.04})};
  SceneDesc desc = floor_scene({{w, l, 0}, {-w, l, 0}, {w, -l, 0}, {-w, -l, 0}, {0, 0, 0.015}}, 0.0);
  desc.scene_field = field_of(joined(walls), 1e-3, 6e-3);
  desc.contact.response = peg.response;
  desc.contact.stiffness = peg.stiffness;
  desc.contact.region_radius = 2e-3;
  desc.integrator = Integrator::implicit_euler;
  desc.device.handle_weight = 0;
  desc.torque_substitution.emplace();
  return desc;
}

// The handle turned about z, and moved.
inline Pose turned(double angle, const Vec3& p = Vec3::Zero()) {
  return {quaternion_exp(Vec3(0, 0, angle)), p};
}

}  // namespace fulcrum::test
