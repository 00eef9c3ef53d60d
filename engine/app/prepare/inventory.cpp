#include "engine/app/prepare/inventory.h"

#include <algorithm>

#include "drivers/registry.h"
#include "engine/app/prepare/colocation_choice.h"
#include "engine/app/prepare/scene_sound.h"
#include "haptics/math/number_text.h"

namespace fulcrum::app {
namespace {

template <class Add>  // (name, why)
void leave_out_of_holding(const SceneDesc& scene, const Add& add) {
  const std::string device = "the device '" + scene.device.name + "' ";
  if (!scene.holding_point) {
    add("holding point", "the scenario does not name it");
  } else {
    if (!scene.device.strip) add("strip", device + "has none: the holding point is where it is set");
    if (!scene.device.structure) add("lever-arm limit", "how stiff " + device + "is, is not known");
    if (coupled(scene.contact.response) && !moves_grip(scene.contact.response))
      add("coupling at the holding point",
          "under the scenario's response the coupling holds the tool at its "
          "centre of mass");
  }
}

void leave_out_of_haptics(const World& world, const Prepared& prepared, std::vector<InventoryItem>& out) {
  const SceneDesc& scene = world.desc();
  const auto add = [&out](const std::string& name, const std::string& why) {
    out.push_back({name, "haptics", 0, 0, why});
  };
  const VelocityEstimatorKind kind = scene.velocity.kind;
  if (kind != VelocityEstimatorKind::difference) add("estimator difference", "the scenario names another");
  if (kind != VelocityEstimatorKind::low_pass) add("estimator low_pass", "the scenario names another");
  if (kind != VelocityEstimatorKind::adaptive_window)
    add("estimator adaptive_window", "the scenario names another");
  const ContactResponse response = scene.contact.response;
  if (response != ContactResponse::penalty) add("response penalty", "the scenario names another");
  if (response != ContactResponse::quasi_static) add("response static", "the scenario names another");
  if (response != ContactResponse::constraint)
    add("response constraint", "the scenario names another: no constraint solver is built");
  const bool in_place_of_direct = !coupled(prepared.scenario.contact.response) && coupled(response);
  if (in_place_of_direct)
    add("response direct", "the device '" + scene.device.name +
                               "' cannot push the hand back: the tool stays out by itself, and a coupling as "
                               "stiff as the contact pulls it");
  else if (response != ContactResponse::direct)
    add("response direct", "the scenario names another");
  if (!coupled(response)) add("coupling", "under the response direct the tool is where the hand wants it");
  if (response != ContactResponse::voxel) add("response voxel", "the scenario names another");
  if (coupled(response) && !has_friction(scene.contact)) add("friction", "contact.friction is 0");
  if (response == ContactResponse::constraint) {
    if (!scene.tool_shell) {
      add("field", "contact.surface is triangles, and nothing asks for impacts");
      add("pointshell", "contact.surface is triangles, and nothing asks for impacts");
    }
    if (scene.tool_features)
      add("query", "contact.surface is triangles: the response looks no points up");
    else
      add("features", prepared.scenario.surface == scenario::ContactSurface::points
                          ? "contact.surface is points"
                          : "in place of the response direct contact is on points");
    if (scene.tool_features)
      add("edges", "contact.surface is triangles, which have their own");
    else if (!scene.scene_edges)
      add("edges", "contact.edges is 0");
  }
  if (massless(response)) add("integrator", "the tool has no mass under the scenario's response");
  if (!scene.device.renders_torque) add("torque motors", "the device '" + scene.device.name + "' has none");
  if (!scene.device.renders_force) add("force motors", "the device '" + scene.device.name + "' has none");
  if (!detects_impacts(scene)) add("impacts", "nothing in the scene asks for them");
  for (const LeftOut& part : left_out_effects(scene, scene)) add(part.name, part.why);
  leave_out_of_holding(scene, add);
  if (in_place_of_direct && !prepared.scenario.contact.levels.empty())
    add("stiffness levels", "a constraint has no stiffness to choose");
  else if (scene.contact.levels.empty())
    add("stiffness levels", "contact.levels is not named");
  if (scene.mapping.clutch_button < 0) add("clutch", "no clutch_button is named");
  if (prepared.scenario.device.mapping.drift == 0)
    add("workspace drift", "device.drift is 0");
  else if (scene.mapping.drift == 0)
    add("workspace drift",
        "the device '" + scene.device.name + "' has no workspace to keep to the middle of");
  if (!scene.tool.weight) add("tool weight", "tool.weight is off");
  if (prepared.haptic.task.checkpoints.empty()) add("task judge", "the scenario has no checkpoints");
  if (!prepared.haptic.task.hard_touch) add("hard touches", "no hard_touch is named");
  if (!has_ways(prepared.haptic.task)) add("ways", "no checkpoint has a line or a bore");
  if (prepared.haptic.task.avoid.empty()) add("trespasses", "no place is to be avoided");
}

// What plays the channels on a card, where something in the scene drives them.
void add_sound(const SceneDesc& scene, const std::string& device, Inventory& to) {
  const std::string on = device.substr(device.find('+') + 1);
  if (!channel_use(scene, scene)) {
    to.left_out.push_back({"sound", "device", 0, 0, "nothing in the scene drives the channels of " + on});
    return;
  }
  std::string what;
  for (const ChannelDesc& channel : scene.device.vibrotactile->channels)
    what += (what.empty() ? "" : ", ") + channel.name;
  to.built.push_back(
      {"sound", "device", 0, 0, what + " on " + on + ": a ring of ticks, and a thread that plays them"});
}

std::string why_no_arms(const Prepared& prepared, const SceneDesc& scene) {
  if (!prepared.scenario.device.drawn) return "the scenario does not ask for it";
  return "the device '" + scene.device.name + "' has none";
}

}  // namespace

Inventory inventory(const World& world, const Prepared& prepared, const render::RenderPlan* plan,
                    const InventoryOptions& options) {
  Inventory result;
  for (const BuiltPart& part : world.parts())
    result.built.push_back({part.name, "haptics", part.bytes, 0, part.what});
  leave_out_of_haptics(world, prepared, result.left_out);
  if (plays_sound(options.device)) add_sound(world.desc(), options.device, result);
  if (plan == nullptr) {
    result.left_out.push_back({"renderer", "picture", 0, 0, "nothing is drawn"});
    return result;
  }
  if (scenario::draws_arms(prepared.scenario, world.desc()))
    result.built.push_back(
        {"device's arms", "picture", 0, 0, "as its table has them, where the handle holds them"});
  else
    result.left_out.push_back({"device's arms", "picture", 0, 0, why_no_arms(prepared, world.desc())});
  if (options.circle)
    result.built.push_back({"circle of confusion", "picture", 0, 0, "about the tool, after an impact"});
  else
    result.left_out.push_back({"circle of confusion", "picture", 0, 0, "only `run --circle` asks for it"});
  const auto drawn = [&result](bool built, const char* name, const char* what, const char* why) {
    (built ? result.built : result.left_out).push_back({name, "picture", 0, 0, built ? what : why});
  };
  drawn(world.desc().holding_point.has_value(), "axes at the holding point", "red, green and blue arrows",
        "the scenario names no holding_point");
  drawn(scenario::draws_levels(world.desc()), "levels beside the finger", "a bar to either side",
        "no finger sweeps on a device that vibrates");
  drawn(prepared.scenario.guide.has_value(), "guide", "a ball that goes to and fro",
        "the scenario does not name it");
  drawn(options.panels, "panels", "text and marks over the scene, with an image of their font",
        "--overlay none leaves them out");
  for (const render::BuildItem& item : plan->built)
    result.built.push_back({item.name, item.kind, item.bytes, 0, item.note});
  for (const render::BuildItem& item : plan->left_out)
    result.left_out.push_back({item.name, item.kind, 0, 0, item.note});
  return result;
}

void add_scene_sound(const Prepared& prepared, const SceneDesc& scene, bool heard, Inventory& to) {
  constexpr const char* kName = "scene sound";
  const std::optional<audio::SceneSound> sound = scene_sound(prepared, scene);
  if (!sound) {
    to.left_out.push_back({kName, "sound", 0, 0, "the scenario does not name it"});
    return;
  }
  if (!heard) {
    to.left_out.push_back({kName, "sound", 0, 0, "nobody listens: a window plays it, --wav writes it"});
    return;
  }
  std::string what = "blows as ";
  std::vector<std::string> names;
  for (const ImpactMaterial& material : sound->materials) {
    std::string name = material.name + " " + number_text(sound->pitch * material.frequency_Hz) + " Hz";
    if (std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
  }
  for (std::size_t i = 0; i < names.size(); ++i) what += (i == 0 ? "" : ", ") + names[i];
  what += sound->slide > 0 && sound->gain > 0 ? "; sliding; chimes of the task" : "; chimes of the task";
  to.built.push_back({kName, "sound", 0, 0, what});
}

void add_headset(const HeadsetOptions& options, const std::string& device, Inventory& to) {
  if (!options.asked) {
    to.left_out.push_back({"headset", "picture", 0, 0, "--xr asks for it"});
    return;
  }
  to.built.push_back(
      {"headset", "picture", 0, 0, "by OpenXR in fulcrum-xr: a session, its pictures, hands, a panel"});
  if (tracks_hands(device))
    to.built.push_back(
        {"hand tracking", "picture", 0, 0,
         "by XR_EXT_hand_tracking: a tracker of 26 joints for each hand, of which four are read"});
  else
    to.left_out.push_back({"hand tracking", "picture", 0, 0, "--device tracked_hand asks for it"});
  const ColocationChoice choice = choose_colocation(options, device);
  if (const auto kept = kept_colocation(options, device); !kept)
    to.left_out.push_back({"co-location", "picture", 0, 0, kept.error().sentence});
  else if (!choice.built.empty())
    to.built.push_back({"co-location", "picture", 0, 0, choice.built});
  else
    to.left_out.push_back({"co-location", "picture", 0, 0, choice.why_not});
}

}  // namespace fulcrum::app
