#include "tools/content/piping/valve.h"

#include <array>
#include <vector>

#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"
#include "tools/content/mesh/fasteners.h"
#include "tools/content/mesh/loft.h"
#include "tools/content/mesh/tube.h"
#include "tools/content/piping/pipe_line.h"

namespace fulcrum::content {
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

constexpr double half_length = 44 * mm;  // between the valve's flange faces, halved
constexpr double bonnet_seat = 29 * mm;  // along the stem
constexpr double bonnet_radius = 24 * mm;
constexpr double bonnet_plate = 6 * mm;
constexpr double wheel_height = 84 * mm;
constexpr double wheel_radius = 30 * mm;
constexpr double rim_radius = 3.6 * mm;
constexpr int spokes = 5;

Solid body(const FlangeSize& size) {
  const double rim = size.radius;
  const double t = size.thickness + raised_face;
  const double c = 0.8 * mm;
  std::vector<RadiusHeight> half{
      {size.face_radius, half_length},
      {size.face_radius, half_length - raised_face},
      {rim - c, half_length - raised_face},
      {rim, half_length - raised_face - c},
      {rim, half_length - t + c},
      {rim - c, half_length - t},
      {17.2 * mm, half_length - t},
      {16.4 * mm, half_length - t - 1.5 * mm},
      {16.2 * mm, 25 * mm},
      {18.0 * mm, 20 * mm},
      {21.5 * mm, 14 * mm},
      {23.6 * mm, 7 * mm},
  };
  std::vector<RadiusHeight> profile = half;
  profile.push_back({24.2 * mm, 0.0});
  for (auto at = half.rbegin(); at != half.rend(); ++at) profile.push_back({at->r, -at->z});
  return lathe(profile, size.columns);
}

// From inside the body to the plate that the bonnet is bolted to.
Solid chest() {
  const double c = 0.6 * mm;
  const std::array<RadiusHeight, 6> profile{{{15 * mm, 0.0},
                                             {15 * mm, bonnet_seat - bonnet_plate - 1 * mm},
                                             {16 * mm, bonnet_seat - bonnet_plate},
                                             {bonnet_radius, bonnet_seat - bonnet_plate},
                                             {bonnet_radius, bonnet_seat - c},
                                             {bonnet_radius - c, bonnet_seat}}};
  return lathe(profile, 32);
}

Solid bonnet() {
  const double base = bonnet_seat + 2 * mm;
  const double c = 0.6 * mm;
  const std::array<RadiusHeight, 10> profile{{{bonnet_radius - c, base},
                                              {bonnet_radius, base + c},
                                              {bonnet_radius, base + bonnet_plate - c},
                                              {bonnet_radius - c, base + bonnet_plate},
                                              {14.0 * mm, base + bonnet_plate},
                                              {13.0 * mm, base + bonnet_plate + 1.2 * mm},
                                              {12.0 * mm, base + 14 * mm},
                                              {9.5 * mm, base + 19 * mm},
                                              {9.0 * mm, base + 28 * mm},
                                              {8.4 * mm, base + 28.6 * mm}}};
  return lathe(profile, 32);
}

Solid wheel_rim() {
  std::vector<RadiusHeight> profile;
  constexpr int around = 12;
  for (int k = 0; k < around; ++k) {
    const double a = 2.0 * pi * k / around;
    profile.push_back({wheel_radius + rim_radius * math::cos(a), rim_radius * math::sin(a)});
  }
  return lathe_ring(profile, 40);
}

void add_wheel(Plant* plant, const std::string& name, const Isometry3d& X_WH) {
  plant->add("hand_wheel/" + name + "/rim", Finish::red_paint, X_WH, wheel_rim());
  const std::array<RadiusHeight, 5> hub{
      {{8 * mm, -6 * mm}, {8.6 * mm, -5.4 * mm}, {8.6 * mm, 3 * mm}, {7.6 * mm, 4 * mm}, {6 * mm, 4 * mm}}};
  plant->add("hand_wheel/" + name + "/hub", Finish::red_paint, X_WH, lathe(hub, 24));
  for (int k = 0; k < spokes; ++k) {
    const Isometry3d X = X_WH * turn_by(2.0 * pi * k / spokes, Vector3d::UnitZ());
    // Dished: the spokes climb from the hub to the rim.
    const std::vector<Vector3d> corners{X * Vector3d(5 * mm, 0, -1.5 * mm),
                                        X * Vector3d(12 * mm, 0, -2.5 * mm),
                                        X * Vector3d(wheel_radius, 0, 0)};
    plant->add("hand_wheel/" + name + "/spoke/" + std::to_string(k + 1), Finish::red_paint,
               tube(stations({corners, 12 * mm}), 2.6 * mm, 10, TubeEnd::flat, TubeEnd::flat));
  }
  plant->add("hand_wheel/" + name + "/nut", Finish::zinc, X_WH * Translation3d(0, 0, 4 * mm), nut(m6, 12));
}

void add_bonnet_bolts(Plant* plant, const std::string& name, const Isometry3d& X_WS) {
  const double underside = bonnet_seat - bonnet_plate;
  const double top = bonnet_seat + 2 * mm + bonnet_plate;
  for (int k = 0; k < bolts_per_flange; ++k) {
    const double a = bolt_angle(k);
    const Isometry3d X = X_WS * Translation3d(18.4 * mm * math::cos(a), 18.4 * mm * math::sin(a), 0.0);
    const std::string suffix = "/" + name + "/bonnet/" + std::to_string(k + 1);
    // Studs, screwed into the chest's plate.
    plant->add("stud" + suffix, Finish::zinc, X * Translation3d(0, 0, underside + 1 * mm),
               bolt({5 * mm, 0.8 * mm, 6 * mm, 0.9 * mm, 5 * mm, 6 * mm, 2 * mm},
                    top - underside + m6.nut_height + 1.4 * mm, 1.7 * mm, 12));
    plant->add("nut" + suffix, Finish::zinc, X * Translation3d(0, 0, top), nut(m6, 12));
  }
}

}  // namespace

void add_valve(Plant* plant, const std::string& name, const Isometry3d& X_WV, const FlangeSize& size) {
  plant->add_round("valve/" + name + "/body", Finish::water_paint, X_WV, body(size), size.columns,
                   size.radius);
  for (const int side : {-1, 1}) {
    const Isometry3d X_WJ = X_WV * Translation3d(0, 0, side * (half_length + 0.5 * gasket_thickness));
    const std::string joint = name + (side < 0 ? "/v" : "/w");
    plant->add("gasket/" + joint, Finish::gasket, X_WJ * Translation3d(0, 0, -0.5 * gasket_thickness),
               gasket(size));
    plant->add_round("flange/" + joint, Finish::bare_steel, flange_pose(X_WJ, -side), weld_neck_flange(size),
                     size.columns, size.radius);
    add_bolts(plant, joint, X_WJ, size);
  }

  const Isometry3d X_WS = X_WV * turn_by(0.5 * pi, Vector3d::UnitY());
  plant->add_round("valve/" + name + "/chest", Finish::water_paint, X_WS, chest(), 32, bonnet_radius, 0.3);
  const std::array<RadiusHeight, 2> seal{{{21 * mm, bonnet_seat}, {21 * mm, bonnet_seat + 2 * mm}}};
  plant->add("gasket/" + name + "/bonnet", Finish::gasket, X_WS, lathe(seal, 32));
  plant->add_round("valve/" + name + "/bonnet", Finish::water_paint, X_WS, bonnet(), 32, bonnet_radius, 0.2);
  add_bonnet_bolts(plant, name, X_WS);
  const double gland = bonnet_seat + 2 * mm + 28.6 * mm;
  plant->add("valve/" + name + "/gland_nut", Finish::brass, X_WS * Translation3d(0, 0, gland), nut(m8, 24));
  const std::array<RadiusHeight, 3> stem{
      {{4 * mm, gland}, {4 * mm, wheel_height + 9 * mm}, {3 * mm, wheel_height + 10.5 * mm}}};
  plant->add_round("valve/" + name + "/stem", Finish::bare_steel, X_WS, lathe(stem, 16), 16, 4 * mm);
  add_wheel(plant, name, X_WS * Translation3d(0, 0, wheel_height));
}

}  // namespace fulcrum::content
