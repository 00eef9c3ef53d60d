#include "tools/content/piping/supports.h"

#include "haptics/math/functions.h"
#include "tools/content/mesh/loft.h"
#include "tools/content/mesh/tube.h"
#include "tools/content/mesh/fasteners.h"

namespace fulcrum::content {
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

constexpr int corner_steps = 4;

// Along a channel's section from the toe of one flange to the toe of the other, `inset` from its outside.
Section half_outline(const Channel& channel, double inset, double corner_radius, double z) {
  const double a = 0.5 * channel.width - inset;
  const double r = corner_radius;
  Section points{{-a, -channel.depth, z}};
  for (const double side : {-1.0, 1.0}) {
    const double start = side < 0.0 ? pi : 0.5 * pi;
    for (int i = 0; i <= corner_steps; ++i) {
      const double angle = start - 0.5 * pi * i / corner_steps;
      points.emplace_back(side * (a - r) + r * math::cos(angle), -inset - r + r * math::sin(angle), z);
    }
  }
  points.emplace_back(a, -channel.depth, z);
  return points;
}

Section channel_section(const Channel& channel, double z) {
  Section section = half_outline(channel, 0.0, 3.0 * mm, z);
  const Section inside = half_outline(channel, channel.thickness, 2.0 * mm, z);
  section.insert(section.end(), inside.rbegin(), inside.rend());
  return section;
}

}  // namespace

Solid channel_bar(const Channel& channel, double length) {
  const std::vector<Section> sections{channel_section(channel, 0.0), channel_section(channel, length)};
  return loft(sections, Cap::strip);
}

void add_clamp(Plant* plant, const Clamp& clamp) {
  const double rod = 0.5 * m6.diameter;
  const double leg = clamp.pipe_radius + rod;
  const Vector3d across = clamp.axis.cross(clamp.from_bar);
  const double below = clamp.distance + clamp.web + m6.washer_height + m6.nut_height + stub(m6);
  const auto place = [&](double side, double up) -> Vector3d {
    return clamp.p + side * leg * across + up * clamp.from_bar;
  };
  const std::vector<Vector3d> corners{place(-1.0, -below), place(-1.0, leg), place(1.0, leg),
                                      place(1.0, -below)};
  plant->add("u_bolt/" + clamp.name, Finish::galvanised,
             tube(stations({corners, leg, 15.0 * degree}), rod, 12, TubeEnd::stud, TubeEnd::stud));

  for (const int side : {-1, 1}) {
    const std::string suffix = "/" + clamp.name + (side < 0 ? "/left" : "/right");
    const Isometry3d behind = frame_along(place(side, -clamp.distance - clamp.web), -clamp.from_bar);
    plant->add("clamp_washer" + suffix, Finish::galvanised, behind, washer(m6, 16));
    plant->add("clamp_nut" + suffix, Finish::zinc, behind * Translation3d(0.0, 0.0, m6.washer_height),
               nut(m6, 12));
  }

  // The saddle is broader than the pipe is near its foot, and the pipe sinks into its top.
  const double top = -0.45 * clamp.pipe_radius;
  const double half_height = 0.5 * (clamp.distance + top);
  Isometry3d X = Isometry3d::Identity();
  X.linear().col(0) = clamp.axis;
  X.linear().col(1) = across * -1.0;
  X.linear().col(2) = clamp.axis.cross(-across);
  X.translation() = clamp.p + (top - half_height) * clamp.from_bar;
  const double half_across = 0.95 * clamp.pipe_radius;
  plant->add("saddle/" + clamp.name, Finish::frame_paint, X,
             chamfered_box({9.0 * mm, half_across, half_height}, 0.8 * mm));
}

}  // namespace fulcrum::content
