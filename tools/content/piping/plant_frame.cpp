#include "tools/content/piping/plant_frame.h"

#include "tools/content/mesh/loft.h"
#include "tools/content/piping/supports.h"

namespace fulcrum::content {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr Channel post{30 * mm, 22 * mm, 4 * mm};
constexpr Channel bar{40 * mm, 26 * mm, 4 * mm};
constexpr Channel arm{32 * mm, 20 * mm, 4 * mm};

constexpr double post_face_z = -178 * mm;
constexpr double bar_face_z = post_face_z + bar.depth;
constexpr double post_x = 235 * mm;
constexpr double half_height = 250 * mm;

const Vector3d right = Vector3d::UnitX();
const Vector3d up = Vector3d::UnitY();
const Vector3d front = Vector3d::UnitZ();

// A bar from a point along a direction, its web facing outwards.
Isometry3d bar_pose(const Vector3d& from, const Vector3d& along, const Vector3d& facing) {
  Isometry3d X = Isometry3d::Identity();
  X.linear().col(0) = facing.cross(along);
  X.linear().col(1) = facing;
  X.linear().col(2) = along;
  X.translation() = from;
  return X;
}

void add_post(Plant* plant, const std::string& side, double x) {
  const Vector3d foot(x, -half_height, post_face_z);
  plant->add("frame/post/" + side, Finish::frame_paint, bar_pose(foot, up, front),
             channel_bar(post, 2.0 * half_height));
  Isometry3d X = Isometry3d::Identity();
  X.translation() = foot + Vector3d(0.0, 3 * mm, -0.5 * post.depth);
  plant->add("frame/foot/" + side, Finish::frame_paint, X, chamfered_box({26 * mm, 4 * mm, 22 * mm}, 1 * mm));
}

void add_cross_bar(Plant* plant, const std::string& name, double y) {
  constexpr double length = 2.0 * (post_x + 0.5 * post.width);
  plant->add("frame/cross_bar/" + name, Finish::frame_paint,
             bar_pose({-0.5 * length, y, bar_face_z}, right, front), channel_bar(bar, length));
}

void add_arm(Plant* plant, const std::string& name, const Vector3d& from, double to_z,
             const Vector3d& facing) {
  plant->add("frame/arm/" + name, Finish::frame_paint, bar_pose(from, front, facing),
             channel_bar(arm, to_z - from.z()));
}

// Holds a line at a place on one of its runs, on a face square to from_bar.
class Clamper {
public:
  Clamper(Plant* plant, std::span<const PipeLine> lines) : plant_(*plant), lines_(lines) {}

  void hold(int line_number, std::size_t run, double at, const Vector3d& from_bar, double face, double web) {
    const PipeLine& line = lines_[static_cast<std::size_t>(line_number - 1)];
    const Vector3d& from = line.corners[run];
    const Vector3d axis = (line.corners[run + 1] - from).normalized();
    Eigen::Index along = 0;
    axis.cwiseAbs().maxCoeff(&along);
    const Vector3d p = from + (at - from[along]) / axis[along] * axis;
    ++held_;
    add_clamp(&plant_, {two_digits(line_number) + "/" + std::to_string(held_), p, axis, from_bar,
                        line.size.pipe_radius, p.dot(from_bar) - face, web});
  }

private:
  Plant& plant_;
  std::span<const PipeLine> lines_;
  int held_ = 0;
};

}  // namespace

void add_plant_frame(Plant* plant, std::span<const PipeLine> lines) {
  add_post(plant, "left", -post_x);
  add_post(plant, "right", post_x);
  add_cross_bar(plant, "top", 215 * mm);
  add_cross_bar(plant, "middle", 0.0);
  add_cross_bar(plant, "low", -140 * mm);
  add_cross_bar(plant, "bottom", -222 * mm);

  constexpr double under_line_1 = -150 * mm;
  constexpr double under_line_2 = 110 * mm;
  constexpr double left_of_line_3 = -222 * mm;
  constexpr double right_of_line_8 = 212 * mm;
  add_arm(plant, "left/low", {-228 * mm, under_line_1, bar_face_z}, 78 * mm, up);
  add_arm(plant, "right/high", {228 * mm, under_line_2, post_face_z}, 78 * mm, up);
  add_arm(plant, "left/high", {left_of_line_3, 215 * mm, bar_face_z}, 138 * mm, right);
  add_arm(plant, "right/low", {right_of_line_8, -222 * mm, bar_face_z}, 142 * mm, -right);

  Clamper clamper(plant, lines);
  clamper.hold(1, 1, -228 * mm, up, under_line_1, arm.thickness);
  clamper.hold(2, 1, 228 * mm, up, under_line_2, arm.thickness);
  clamper.hold(3, 0, 215 * mm, right, left_of_line_3, arm.thickness);
  clamper.hold(6, 0, 0.0, front, bar_face_z, bar.thickness);
  clamper.hold(6, 0, 215 * mm, front, bar_face_z, bar.thickness);
  clamper.hold(6, 1, 205 * mm, front, bar_face_z, bar.thickness);
  clamper.hold(7, 2, 140 * mm, front, bar_face_z, bar.thickness);
  clamper.hold(8, 2, -222 * mm, -right, -right_of_line_8, arm.thickness);
  clamper.hold(9, 1, -222 * mm, front, bar_face_z, bar.thickness);
  clamper.hold(13, 1, 215 * mm, front, bar_face_z, bar.thickness);
}

}  // namespace fulcrum::content
