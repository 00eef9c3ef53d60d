#include "tools/content/piping/piping.h"

#include "haptics/math/functions.h"
#include "tools/content/piping/gauge.h"
#include "tools/content/piping/plant_frame.h"
#include "tools/content/piping/route.h"
#include "tools/content/piping/valve.h"

namespace fulcrum::content {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double edge = 250 * mm;  // of the plant, left, right, above and below

Vector3d at(double x, double y, double z) {
  return {x * mm, y * mm, z * mm};
}

// The two upright pipes of the slot, one bending away to the left below it, one to the right above.
void add_slot_lines(std::vector<PipeLine>* lines) {
  constexpr double x = Layout::slot_pipe_x;
  constexpr double z = Layout::slot_z;
  lines->push_back({1,
                    Finish::water_paint,
                    flange_34,
                    {{-x, edge, z}, {-x, -130 * mm, z}, {-edge, -130 * mm, z}},
                    {{0, 185 * mm}, {1, -150 * mm}}});
  lines->push_back({2,
                    Finish::gas_paint,
                    flange_34,
                    {{x, -edge, z}, {x, 130 * mm, z}, {edge, 130 * mm, z}},
                    {{0, -190 * mm}, {1, 165 * mm}}});
}

// The DN 15 line ends in the blind flange that carries the nut. The nut is on the upper front bolt.
PipeLine target_line() {
  const double off_axis = flange_dn15.bolt_radius * math::sin(bolt_angle(0));
  const double y = Layout::nut_y - off_axis;
  const double z = Layout::nut_z - off_axis;
  const double blind = flange_dn15.thickness + raised_face + m12.washer_height;
  const double face = Layout::nut_seat_x - blind - gasket_thickness;
  return {4,
          Finish::water_paint,
          flange_21,
          {{-175 * mm, edge, z}, {-175 * mm, y, z}, {face, y, z}},
          {{0, 200 * mm}},
          LineEnd::blind,
          flange_dn15};
}

}  // namespace

std::vector<PipeLine> pipe_lines() {
  std::vector<PipeLine> lines;
  add_slot_lines(&lines);
  lines.push_back({3,
                   Finish::water_paint,
                   flange_27,
                   {at(-205, 250, 110), at(-205, -62, 110), at(150, -62, 110), at(150, -250, 110)},
                   {{0, 110 * mm}, {2, -170 * mm}}});
  lines.push_back(target_line());
  lines.push_back({5,
                   Finish::gas_paint,
                   flange_42,
                   {at(-250, 95, -5), at(110, 95, -5), at(110, -250, -5)},
                   {{0, -212 * mm}}});
  lines.push_back({6,
                   Finish::galvanised,
                   flange_27,
                   {at(-100, 250, -130), at(-100, -140, -130), at(250, -140, -130)},
                   {{0, 90 * mm}}});
  lines.push_back({7,
                   Finish::gas_paint,
                   flange_21,
                   {at(-250, 140, -95), at(60, 140, -95), at(60, 0, -95), at(250, 0, -95)},
                   {{0, -40 * mm}}});
  lines.push_back({8,
                   Finish::galvanised,
                   flange_16,
                   {at(200, 250, -70), at(200, 60, -70), at(200, 60, 120), at(200, -250, 120)},
                   {{2, -60 * mm}}});
  lines.push_back({9,
                   Finish::galvanised,
                   flange_16,
                   {at(-250, 20, -100), at(-130, 20, -100), at(-130, -250, -100)},
                   {{0, -205 * mm}}});
  lines.push_back({10,
                   Finish::gas_paint,
                   flange_27,
                   {at(-110, 250, 55), at(-110, 30, 55), at(-250, 30, 55)},
                   {{0, 180 * mm}}});
  lines.push_back({11,
                   Finish::galvanised,
                   flange_34,
                   {at(-250, -205, -20), at(40, -205, -20), at(40, -205, -112)},
                   {{0, -160 * mm}},
                   LineEnd::blind,
                   flange_34});
  lines.push_back({12,
                   Finish::water_paint,
                   flange_27,
                   {at(250, -5, 65), at(95, -5, 65), at(95, -250, 65)},
                   {{1, -135 * mm}}});
  lines.push_back({13,
                   Finish::water_paint,
                   flange_21,
                   {at(250, 55, -130), at(150, 55, -130), at(150, 250, -130)},
                   {{1, 165 * mm}}});
  lines.push_back({14,
                   Finish::galvanised,
                   flange_16,
                   {at(-250, -80, 15), at(-90, -80, 15), at(-90, -250, 15)},
                   {{0, -215 * mm}}});
  return lines;
}

Model make_piping() {
  Plant plant;
  const std::vector<PipeLine> lines = pipe_lines();
  for (const PipeLine& line : lines) add_pipe_line(&plant, line);

  // The valve's stem looks at the viewer.
  Isometry3d X_WV = Isometry3d::Identity();
  X_WV.linear().col(0) = Vector3d::UnitZ();
  X_WV.linear().col(1) = Vector3d::UnitY();
  X_WV.linear().col(2) = -Vector3d::UnitX();
  X_WV.translation() = at(166, -5, 65);
  add_valve(&plant, "12", X_WV, flange_27);

  Isometry3d X_WG = Isometry3d::Identity();
  X_WG.linear().col(0) = Vector3d::UnitZ();
  X_WG.linear().col(1) = Vector3d::UnitX();
  X_WG.linear().col(2) = Vector3d::UnitY();
  X_WG.translation() = at(-156, 30, 55);
  add_gauge(&plant, "10", X_WG, flange_27.pipe_radius);

  add_plant_frame(&plant, lines);
  return plant.take();
}

bool is_slot_pipe(const std::string& part_name) {
  return part_name == "pipe/01" || part_name == "pipe/02";
}

bool is_target_bolt(const std::string& part_name) {
  for (const char* kind : {"bolt", "nut", "washer"})
    if (part_name.starts_with(std::string(kind) + "/04/b/1")) return true;
  return false;
}

}  // namespace fulcrum::content
