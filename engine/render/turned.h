#pragma once
// Turned parts, in code: profiles about an axis, for what is drawn without a model file.

#include <span>

#include "engine/render/visual_desc.h"

namespace fulcrum::render {

// A point of a profile.
struct Turned {
  float radius = 0.0F;  // m
  float along = 0.0F;   // m, on the axis from its foot
};

// Appends the profile turned about the line from `foot` (m) along `axis` (need not be unit). It runs along
// the axis; where it bends by more than 40 degrees there is an edge. Closed if it begins and ends at radius
// 0.
void add_turned(Mesh& mesh, const glm::vec3& foot, const glm::vec3& axis, std::span<const Turned> profile);

// A bar between two points (m), tapered, its ends a little bevelled. Nothing where the points coincide.
void add_bar(Mesh& mesh, const glm::vec3& from, const glm::vec3& to, float radius_from, float radius_to);

void add_ball(Mesh& mesh, const glm::vec3& centre, float radius);

}  // namespace fulcrum::render
