#pragma once
// How a scene answers to touch.

namespace fulcrum {

enum class ContactResponse { penalty };

struct ContactDesc {
  ContactResponse response = ContactResponse::penalty;
  double stiffness = 20000;      // N/m, per contact region
  double dissipation = 20;       // s/m, Hunt-Crossley: force k d (1 + dissipation * approach speed)
  double region_radius = 0.012;  // m, touching points nearer than this with like normals are one region
};

}  // namespace fulcrum
