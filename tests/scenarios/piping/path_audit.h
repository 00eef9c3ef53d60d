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

  // The tool's next accepted pose. From the last one it came straight, turning evenly the shorter way round.
  void move(const Pose& X_WT);

  double deepest() const { return deepest_; }  // m, of a shell point, exact
  std::size_t passages() const {
    return passages_;
  }  // points that came out on another side than they went in
  const std::string& first_passage() const { return first_passage_; }
  std::size_t crossings() const { return crossings_; }  // of a triangle, by any point

private:
  struct Point {
    double radius = 0;  // m, |p_T|
    double room = 0;    // m, it can travel so far before it can meet a triangle
    bool inside = false;
    Vec3 entry_normal = Vec3::UnitY();
    double deepest = 0;  // m, a bound of its depth since it went in
  };
  void walk(std::size_t i, const Twist& along, double travel);
  void check(std::size_t i, const Vec3& p0_W, const Vec3& p_W);  // straight from p0_W to p_W
  void leave(std::size_t i, const Vec3& p_W, const Vec3& exit_normal);

  TriangleDistance exact_;
  const Solid& scene_;
  const Pointshell& shell_;
  std::vector<Point> points_;
  Pose X_WT_;  // the last one
  bool started_ = false;
  double deepest_ = 0;
  std::size_t passages_ = 0, crossings_ = 0;
  std::string first_passage_;
};

}  // namespace fulcrum::test
