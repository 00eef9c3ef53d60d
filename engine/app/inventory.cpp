#include "engine/app/inventory.h"

#include "haptics/math/number_text.h"

namespace fulcrum::app {
namespace {

template <class Add>  // (name, why)
void leave_out_of_torque_substitution(const SceneDesc& scene, const Add& add) {
  const std::string device = "the device '" + scene.device.name + "' ";
  if (!scene.torque_substitution) return add("torque substitution", "the scenario does not name it");
  if (scene.device.renders_torque) return add("torque substitution", device + "renders torque");
  if (!scene.device.renders_force) add("vibration", device + "has no motors");
  if (!scene.device.senses_rotation) add("ghost", device + "senses no rotation");
  if (!scene.torque_substitution->limit_stiffness)
    add("stiffness limit", "torque_substitution.limit_stiffness is off");
  else if (!coupled(scene.contact.response))
    add("stiffness limit", "the response direct has no coupling");
  else if (scene.contact.response == ContactResponse::constraint)
    add("stiffness limit", "under the response constraint the tool stays out whatever the torque");
}

template <class Add>
void leave_out_of_impact_vibration(const SceneDesc& scene, const Add& add) {
  const DeviceDesc& device = scene.device;
  if (!scene.impact_vibration) return add("impact vibration", "the scenario does not name it");
  if (!vibrates_at_impacts(scene))
    return add("impact vibration", "the device '" + device.name + "' has no motors");
  if (!device.renders_torque)
    add("vibration about an axis", "the device '" + device.name + "' renders no torque: " +
                                       (scene.impact_vibration->render == ImpactRender::torque
                                            ? "only impacts along the lever are felt, as a force"
                                            : "impacts are felt as a force"));
  if (!device.renders_force)
    add("vibration along a normal", "the device '" + device.name + "' renders no force");
  // Beside the hand a sinusoid is highest, and a beam's modes are the same everywhere.
  const double highest = highest_vibration(device.bandwidth_Hz, scene.tick_s);
  for (const ImpactMaterial& material : scene.impact_vibration->materials) {
    const VibrationModes modes =
        vibration_modes(scene.impact_vibration->distance, material.frequency_Hz, 0, 1);
    for (std::size_t n = 0; n < modes.count; ++n) {
      if (modes.modes[n].frequency_Hz <= highest) continue;
      add("a mode of " + material.name, number_text(modes.modes[n].frequency_Hz) +
                                            " Hz, and device and tick rate render up to " +
                                            number_text(highest) + " Hz");
    }
  }
}

template <class Add>
void leave_out_of_braking_pulse(const SceneDesc& scene, const Add& add) {
  if (!scene.braking_pulse) return add("braking pulse", "the scenario does not name it");
  if (!brakes_at_impacts(scene))
    return add("braking pulse", "the device '" + scene.device.name + "' has no motors");
  if (!scene.device.renders_torque)
    add("moment of the pulse", "the device '" + scene.device.name + "' renders no torque");
}

template <class Add>
void leave_out_of_vibrotactile_motion(const SceneDesc& scene, const Add& add) {
  if (!scene.vibrotactile_motion) return add("vibrotactile motion", "the scenario does not name it");
  const std::string device = "the device '" + scene.device.name + "' ";
  const DeviceDesc& d = scene.device;
  if (!moves_vibration(scene)) {
    if (!d.vibrotactile) return add("vibrotactile motion", device + "has no channels");
    return add("vibrotactile motion", "it is a fallback, and " + device + "has motors");
  }
  if (scene.vibrotactile_motion->use == VibrotactileUse::fallback) return;
  if (!d.vibrotactile) add("vibration of the sweep", device + "has no channels");
  if (scene.vibrotactile_motion->lateral_force == 0)
    add("lateral force", "vibrotactile_motion.lateral_force is 0");
  else if (!d.renders_force)
    add("lateral force", device + "has no motors");
}

template <class Add>
void leave_out_of_holding(const World& world, const Add& add) {
  const SceneDesc& scene = world.desc();
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
  if (!scene.inertia_compensation) return add("inertia compensation", "the scenario does not name it");
  if (!compensates_inertia(scene)) return add("inertia compensation", device + "does not push");
  if (!scene.device.renders_torque) add("inertia compensation by arm", device + "renders no torque");
  if (!world.compensation()->filter())
    add("acceleration filter", "the scenario's method needs none and is not switchable");
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
  if (response == ContactResponse::constraint && scene.contact.friction == 0)
    add("friction", "contact.friction is 0");
  if (response == ContactResponse::constraint && !scene.scene_edges) add("edges", "contact.edges is 0");
  if (massless(response)) add("integrator", "the tool has no mass under the scenario's response");
  if (!scene.device.renders_torque) add("torque motors", "the device '" + scene.device.name + "' has none");
  if (!scene.device.renders_force) add("force motors", "the device '" + scene.device.name + "' has none");
  leave_out_of_torque_substitution(scene, add);
  if (!detects_impacts(scene)) add("impacts", "nothing in the scene asks for them");
  leave_out_of_impact_vibration(scene, add);
  leave_out_of_braking_pulse(scene, add);
  leave_out_of_vibrotactile_motion(scene, add);
  leave_out_of_holding(world, add);
  if (in_place_of_direct && !prepared.scenario.contact.levels.empty())
    add("stiffness levels", "a constraint has no stiffness to choose");
  else if (scene.contact.levels.empty())
    add("stiffness levels", "contact.levels is not named");
  if (scene.mapping.clutch_button < 0) add("clutch", "no clutch_button is named");
  if (!scene.tool.weight) add("tool weight", "tool.weight is off");
  if (prepared.haptic.task.checkpoints.empty()) add("task judge", "the scenario has no checkpoints");
  if (!prepared.haptic.task.hard_touch) add("hard touches", "no hard_touch is named");
}

std::string why_no_arms(const Prepared& prepared, const SceneDesc& scene) {
  if (!prepared.scenario.device.drawn) return "the scenario does not ask for it";
  return "the device '" + scene.device.name + "' has none";
}

}  // namespace

Inventory inventory(const World& world, const Prepared& prepared, const render::RenderPlan* plan,
                    bool circle) {
  Inventory result;
  for (const BuiltPart& part : world.parts())
    result.built.push_back({part.name, "haptics", part.bytes, 0, part.what});
  leave_out_of_haptics(world, prepared, result.left_out);
  if (plan == nullptr) {
    result.left_out.push_back({"renderer", "picture", 0, 0, "nothing is drawn"});
    return result;
  }
  if (scenario::draws_arms(prepared.scenario, world.desc()))
    result.built.push_back(
        {"device's arms", "picture", 0, 0, "as its table has them, where the handle holds them"});
  else
    result.left_out.push_back({"device's arms", "picture", 0, 0, why_no_arms(prepared, world.desc())});
  if (circle)
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
  for (const render::BuildItem& item : plan->built)
    result.built.push_back({item.name, item.kind, item.bytes, 0, item.note});
  for (const render::BuildItem& item : plan->left_out)
    result.left_out.push_back({item.name, item.kind, 0, 0, item.note});
  return result;
}

}  // namespace fulcrum::app
