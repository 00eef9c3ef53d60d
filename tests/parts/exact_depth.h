#pragma once
// How deep two closed meshes lie in each other, on the triangles themselves: the judge of contact. It shares
// no code with what it judges.

#include <memory>

#include "haptics/geometry/triangle_mesh.h"
#include "haptics/math/pose.h"

namespace fulcrum::parts {

class ExactDepth {
public:
  // spacing: m, of the samples on edges and faces; what lies between them may be missed by half of that.
  ExactDepth(const TriangleMesh& tool_T, const TriangleMesh& scene_W, double spacing);
  ~ExactDepth();

  // m: of vertices, edges and faces of either, the deepest in the other's inside: its distance to the other's
  // surface. 0: none is in it.
  double at(const Pose& X_WT) const;

private:
  struct Body;
  std::unique_ptr<Body> tool_, scene_;
};

}  // namespace fulcrum::parts
