#pragma once
// How a scene answers to touch.

#include <vector>

#include "haptics/math/names_of.h"

namespace fulcrum {

enum class ContactResponse {
  penalty,       // springs against a tool with mass
  voxel,         // the same with depths from occupied voxels: the classic method, to compare with
  quasi_static,  // springs against a tool without
  constraint,    // the tool stays out, as near to the hand as it can
  direct         // springs against a tool that is where the hand wants it: no coupling
};
template <>
inline constexpr std::array<std::string_view, 5> names_of<ContactResponse>{"penalty", "voxel", "static",
                                                                           "constraint", "direct"};

// Whether the tool has no mass under it.
inline bool massless(ContactResponse response) {
  return response != ContactResponse::penalty && response != ContactResponse::voxel;
}

// Whether a coupling is between the hand and the tool.
inline bool coupled(ContactResponse response) {
  return response != ContactResponse::direct;
}

// Whether the coupling's spring is where the hand holds the tool, where a scene says so; else it is at T.
inline bool moves_grip(ContactResponse response) {
  return response == ContactResponse::penalty || response == ContactResponse::voxel;
}

struct ContactDesc {
  ContactResponse response = ContactResponse::constraint;
  double stiffness = 20000;      // N/m, per contact region; a constraint has none
  std::vector<double> levels{};  // (n) N/m, that a person may choose of; none: it stays what it is
  double dissipation = 20;       // s/m, Hunt-Crossley: force k d (1 + dissipation * approach speed)
  // Coulomb's coefficient; and m, the torque about the normal, and of rolling, over the force that presses.
  double friction = 0, torsional_friction = 0, rolling_friction = 0;
  double region_radius = 0.012;  // m, touching points nearer than this with like normals are one region
};

inline bool has_friction(const ContactDesc& contact) {
  return contact.friction > 0 || contact.torsional_friction > 0 || contact.rolling_friction > 0;
}

}  // namespace fulcrum
