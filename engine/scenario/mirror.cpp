#include "engine/scenario/mirror.h"

#include <algorithm>
#include <utility>

#include "engine/scenario/words.h"
#include "haptics/math/mirror.h"

namespace fulcrum::scenario {
namespace {

// Each of these names all members of what it mirrors: who adds one decides here what becomes of it, or the
// file does not compile.

void mirror(glm::vec3& p) {
  negate(p.x);
}

void mirror(ToolEntry& tool) {
  auto& [density, mass, X_HM, X_WM_start, touch_point, touch_name, weight] = tool;
  fulcrum::mirror(X_HM);
  fulcrum::mirror(X_WM_start);
  fulcrum::mirror(touch_point);
}

void mirror(DeviceEntry& device) {
  auto& [model, own, beside, desc, mapping, allocation, drawn, floor] = device;
  auto& [X_WD, position_scale, force_scale, engages_at_start, clutch_button, drift] = mapping;
  fulcrum::mirror(X_WD);
}

void mirror(Checkpoint& checkpoint) {
  auto& [name, position, radius, mirrored_name, needs, hint, dwell, follow, insert, turn, force, facing,
         optional, after, written] = checkpoint;
  if (!mirrored_name.empty()) std::swap(name, mirrored_name);
  fulcrum::mirror(position);
  for (Vec3& corner : follow) fulcrum::mirror(corner);
  if (insert) fulcrum::mirror(insert->direction_W);
  // A turn against the clock is one with the clock in a mirror.
  if (turn) fulcrum::mirror_axis(turn->axis_W);
  if (facing) {
    Pose turned{facing->q_WT, Vec3::Zero()};
    fulcrum::mirror(turned);
    facing->q_WT = turned.q;
  }
}

// Who names an earlier one means it by its name in the same image.
void mirror_all(std::vector<Checkpoint>& checkpoints) {
  for (Checkpoint& checkpoint : checkpoints) {
    const auto before = std::ranges::find(checkpoints, checkpoint.after, &Checkpoint::name);
    if (before != checkpoints.end() && !before->mirrored_name.empty())
      checkpoint.after = before->mirrored_name;
  }
  for (Checkpoint& checkpoint : checkpoints) mirror(checkpoint);
}

void mirror(HandEntry& hand) {
  auto& [name, path, desc, waypoints] = hand;
  for (Waypoint& waypoint : waypoints) {
    auto& [X_WT, travel, dwell, hold, press, stop, through] = waypoint;
    fulcrum::mirror(X_WT);
  }
}

void mirror(GuideDesc& guide) {
  auto& [from_W, to_W, speed, wait, rest, radius] = guide;
  fulcrum::mirror(from_W);
  fulcrum::mirror(to_W);
}

void mirror(View& view) {
  auto& [name, camera, cut] = view;
  auto& [eye, target, vertical_fov_rad, layers, eyes, lean, up, aspect] = camera;
  mirror(eye);
  mirror(target);
  lean.x = -lean.x;
  mirror(up);
}

void mirror(render::KeyLight& light) {
  auto& [kind, position, direction, colour, intensity, cone_rad, diameter, casts_shadow] = light;
  mirror(position);
  mirror(direction);
}

}  // namespace

std::string why_not_mirrored(const Scenario& scenario) {
  if (scenario.holding_point)
    return "the places of 'holding_point' are those of the device's own stick, which has no mirror image";
  const DeviceDesc& device = scenario.device.desc;
  if (device.kinematics == Kinematics::arms && device.mechanism.arms.size() > 1)
    return "the arms of the device " + in_quotes(device.name) +
           " hold the tool at two places of their own, which have no mirror image";
  return {};
}

void mirror(Scenario& scenario) {
  auto& [title, about, difficulty, time_limit, seed, tick_rate_Hz, left_handed, why_right_handed, models,
         materials, tool, field, shell, contact, surface, edges, integrator, coupling, velocity_estimator,
         device, effects, impact, impact_material, impact_materials, holding_point, checkpoints, dwell,
         hard_touch, order, avoid, score, variant, hands, guide, sound, views, light, ambient, surroundings,
         background, folder, overrides, texts] = scenario;
  mirror(tool);
  mirror(device);
  fulcrum::mirror(effects);
  mirror_all(checkpoints);
  for (Avoided& ball : avoid) fulcrum::mirror(ball.position);
  for (HandEntry& hand : hands) mirror(hand);
  if (guide) mirror(*guide);
  for (View& view : views) mirror(view);
  if (light) mirror(*light);
  ambient.mirrored = !ambient.mirrored;
}

void mirror(Model& model) {
  for (ModelPart& part : model.parts) {
    auto& [name, positions, normals, colours, uv, indices, material, marked_role, marked_material] = part;
    for (Vec3& p : positions) fulcrum::mirror(p);
    for (Vec3& n : normals) fulcrum::mirror(n);
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) std::swap(indices[i + 1], indices[i + 2]);
  }
  for (ModelLight& light : model.lights) {
    auto& [name, kind, colour, intensity, range, inner_cone, outer_cone, position_M, direction_M, marked_role,
           marked_material] = light;
    fulcrum::mirror(position_M);
    fulcrum::mirror(direction_M);
  }
}

}  // namespace fulcrum::scenario
