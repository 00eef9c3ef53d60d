#pragma once
// How a scene answers to touch.

namespace fulcrum {

enum class ContactResponse {
  penalty,       // springs against a tool with mass
  voxel,         // the same with depths from occupied voxels: the classic method, to compare with
  quasi_static,  // springs against a tool without: "static" in a scenario
  constraint     // the tool stays out, as near to the hand as it can
};

// Whether the tool has no mass under it.
inline bool massless(ContactResponse response) {
  return response == ContactResponse::quasi_static || response == ContactResponse::constraint;
}

struct ContactDesc {
  ContactResponse response = ContactResponse::constraint;
  double stiffness = 20000;      // N/m, per contact region; a constraint has none
  double dissipation = 20;       // s/m, Hunt-Crossley: force k d (1 + dissipation * approach speed)
  double friction = 0;           // Coulomb's coefficient, of a constraint; 0: none is built
  double region_radius = 0.012;  // m, touching points nearer than this with like normals are one region
};

}  // namespace fulcrum
