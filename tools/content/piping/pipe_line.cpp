#include "tools/content/piping/pipe_line.h"

#include <utility>

#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"
#include "tools/content/mesh/steel.h"
#include "tools/content/mesh/tube.h"

namespace fulcrum::content {
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

std::string joint_name(const PipeLine& line, std::size_t index) {
  return two_digits(line.number) + "/" + static_cast<char>('a' + index);
}

Isometry3d joint_pose(const PipeLine& line, const Joint& joint) {
  const Vector3d& from = line.corners[joint.run];
  const Vector3d direction = (line.corners[joint.run + 1] - from).normalized();
  Eigen::Index axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  const double along = (joint.at - from[axis]) / direction[axis];
  return frame_along(from + along * direction, direction);
}

void add_joint(Plant* plant, const std::string& name, const Isometry3d& X_WJ, const FlangeSize& size,
               bool blind) {
  plant->add_round("flange/" + name + "/1", Finish::bare_steel, flange_pose(X_WJ, 1), weld_neck_flange(size),
                   size.columns, size.radius);
  plant->add_round(blind ? "blind_flange/" + name : "flange/" + name + "/2", Finish::bare_steel,
                   flange_pose(X_WJ, -1), blind ? blind_flange(size) : weld_neck_flange(size), size.columns,
                   size.radius, 0.37);
  plant->add("gasket/" + name, Finish::gasket, X_WJ * Translation3d(0.0, 0.0, -0.5 * gasket_thickness),
             gasket(size));
  add_bolts(plant, name, X_WJ, size);
}

}  // namespace

Isometry3d flange_pose(const Isometry3d& X_WJ, int towards) {
  const Isometry3d facing(turn_by(towards > 0 ? 0.0 : pi, Vector3d::UnitX()));
  return X_WJ * facing * Translation3d(0.0, 0.0, -0.5 * gasket_thickness);
}

void add_bolts(Plant* plant, const std::string& name, const Isometry3d& X_WJ, const FlangeSize& size) {
  const Thread& thread = size.thread;
  const int columns = thread.diameter > 10 * mm ? 24 : 12;
  const double seat = 0.5 * gasket_thickness + raised_face + size.thickness;
  const double nut_z = seat + thread.washer_height;
  const double length = seat + nut_z + thread.nut_height + stub(thread);
  for (int k = 0; k < bolts_per_flange; ++k) {
    const double angle = bolt_angle(k);
    const Vector3d place(size.bolt_radius * math::cos(angle), size.bolt_radius * math::sin(angle), 0.0);
    // Nobody lines up the flats of heads and nuts.
    const auto turned = [&](double z, double turn) -> Isometry3d {
      return X_WJ * Translation3d(place + z * Vector3d::UnitZ()) * turn_by(turn * degree, Vector3d::UnitZ());
    };
    const std::string suffix = "/" + name + "/" + std::to_string(k + 1);
    plant->add("bolt" + suffix, Finish::zinc, turned(-seat, 17.0 * k),
               bolt(thread, length, stub(thread), columns));
    plant->add("nut" + suffix, Finish::zinc, turned(nut_z, 23.0 * k + 11.0), nut(thread, columns));
    plant->add("washer" + suffix, Finish::galvanised, turned(seat, 0.0), washer(thread, 16));
  }
}

void add_pipe_line(Plant* plant, const PipeLine& line) {
  const double radius = line.size.pipe_radius;
  const bool blind = line.end == LineEnd::blind;
  const std::vector<Station> centreline = stations({line.corners, 3.0 * radius, 9.0 * degree, 0.6 * mm});
  Solid pipe =
      tube(centreline, radius, line.size.columns, TubeEnd::cut, blind ? TubeEnd::flat : TubeEnd::cut);
  const std::string name = "pipe/" + two_digits(line.number);
  if (line.finish == Finish::galvanised) {
    plant->add(name, line.finish, std::move(pipe));
  } else {
    // Paint is worn the most where the pipe bends first.
    const double to_bend = (line.corners[1] - line.corners[0]).norm();
    plant->add_round(name, line.finish, Isometry3d::Identity(), std::move(pipe), line.size.columns, radius,
                     worn_at - to_bend / (4.0 * pi * radius));
  }
  std::size_t index = 0;
  for (const Joint& joint : line.joints) {
    add_joint(plant, joint_name(line, index), joint_pose(line, joint), line.size, false);
    ++index;
  }
  if (!blind) return;
  const Vector3d& end = line.corners.back();
  const Vector3d direction = (end - line.corners[line.corners.size() - 2]).normalized();
  const Isometry3d X_WJ = frame_along(end + 0.5 * gasket_thickness * direction, direction);
  add_joint(plant, joint_name(line, index), X_WJ, line.end_size, true);
}

}  // namespace fulcrum::content
