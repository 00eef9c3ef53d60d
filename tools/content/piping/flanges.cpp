#include "tools/content/piping/flanges.h"

#include <vector>

#include "tools/content/mesh/loft.h"

namespace fulcrum::content {
namespace {

constexpr double chamfer = 0.8 * mm;

// The disc's outline from its back edge to the middle of the raised face.
void add_rim(std::vector<RadiusHeight>* profile, const FlangeSize& size) {
  const double back = -raised_face - size.thickness;
  profile->push_back({size.radius - chamfer, back});
  profile->push_back({size.radius, back + chamfer});
  profile->push_back({size.radius, -raised_face - chamfer});
  profile->push_back({size.radius - chamfer, -raised_face});
  profile->push_back({size.face_radius, -raised_face});
  profile->push_back({size.face_radius - 0.4 * raised_face, 0.0});
}

}  // namespace

Solid weld_neck_flange(const FlangeSize& size) {
  const double back = -raised_face - size.thickness;
  const double bead = size.pipe_radius + 0.7 * mm;
  const double fillet = 1.2 * mm;
  std::vector<RadiusHeight> profile{
      {size.pipe_radius - 0.5 * mm, back - size.neck_length - 1.2 * mm},
      {bead, back - size.neck_length},
      {size.pipe_radius + 0.3 * mm, back - size.neck_length + 1.3 * mm},
      {size.pipe_radius + 0.3 * mm, back - 0.65 * size.neck_length},
      {size.neck_radius - 0.3 * fillet, back - 0.9 * fillet},
      {size.neck_radius + 0.6 * fillet, back},
  };
  add_rim(&profile, size);
  return lathe(profile, size.columns);
}

Solid blind_flange(const FlangeSize& size) {
  std::vector<RadiusHeight> profile;
  add_rim(&profile, size);
  return lathe(profile, size.columns);
}

Solid gasket(const FlangeSize& size) {
  const double r = size.face_radius + 1.0 * mm;
  const std::vector<RadiusHeight> profile{{r, 0.0}, {r, gasket_thickness}};
  return lathe(profile, size.columns);
}

double bolt_angle(int k) {
  return 2.0 * pi * (k + 0.5) / bolts_per_flange;
}

}  // namespace fulcrum::content
