#pragma once
// Whether any point of the tool went through the scene, told from the triangles alone, not from the field.

#include <cstddef>
#include <string>
#include <vector>

#include "haptics/bake/triangle_distance.h"
#include "haptics/geometry/pointshell.h"
#include "haptics/math/pose.h"

namespace fulcrum::test {

class PathAudit {
public:
  PathAudit(const Solid& scene_W, const Pointshell& shell_T);

  // The tool's next accepted pose. Straight from the last one: a tick turns the tool by a degree at most.
  void move(const Pose& X_WT);

  double deepest() const { return deepest_; }  // m, of a shell point, exact
  std::size_t passages() const {
    return passages_;
  }  // points that came out on another side than they went in
  const std::string& first_passage() const { return first_passage_; }
  std::size_t crossings() const { return crossings_; }  // of a triangle, by any point

private:
  struct Point {
    Vec3 p_W = Vec3::Zero();
    double room = 0;  // m, it can travel so far before it can meet a triangle
    bool inside = false;
    Vec3 entry_normal = Vec3::UnitY();
    double deepest = 0;  // m, a bound of its depth since it went in
  };
  void check(std::size_t i, const Vec3& p_W);
  void leave(std::size_t i, const Vec3& p_W, const Vec3& exit_normal);

  TriangleDistance exact_;
  const Solid& scene_;
  const Pointshell& shell_;
  std::vector<Point> points_;
  bool started_ = false;
  double deepest_ = 0;
  std::size_t passages_ = 0, crossings_ = 0;
  std::string first_passage_;
};

}  // namespace fulcrum::test
