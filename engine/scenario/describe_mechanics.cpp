#include "engine/scenario/describe.h"

namespace fulcrum::scenario {

namespace {

void describe_contact(KeyVisitor& visitor, ContactDesc& contact) {
  visitor.choice_of({"response", "", "how contact forces are found"}, contact.response);
  visitor.number({"stiffness", "N/m", "of each contact region"}, contact.stiffness, above_to(0, 1e7));
  visitor.numbers({"levels", "N/m", "of stiffness, that a person can choose of while running"},
                  contact.levels, above_to(0, 1e7), 12);
  visitor.number({"dissipation", "s/m", "Hunt-Crossley damping"}, contact.dissipation, from_to(0, 1000));
  visitor.number({"friction", "", "Coulomb's coefficient"}, contact.friction, from_to(0, 10));
  visitor.number({"torsional_friction", "m",
                  "against spinning where a contact is: the torque over the force that presses it"},
                 contact.torsional_friction, from_to(0, 1));
  visitor.number({"rolling_friction", "m", "against rolling: the torque over the force that presses"},
                 contact.rolling_friction, from_to(0, 1));
  visitor.number(
      {"region_radius", "m", "touching points nearer than this, with like normals, are one region"},
      contact.region_radius, above_to(0, 1));
}

void describe_coupling(KeyVisitor& visitor, CouplingGains& coupling) {
  visitor.optional_number(
      {"stiffness", "N/m", "of the spring between hand and tool; without it, what suits the device"},
      coupling.stiffness, above_to(0, 1e5));
  visitor.optional_number(
      {"angular_stiffness", "N m/rad",
       "of the spring between hand and tool in rotation; without it, what suits the device"},
      coupling.angular_stiffness, above_to(0, 1e3));
  visitor.number({"damping_ratio", "", "of critical damping"}, coupling.damping_ratio, from_to(0, 10));
  visitor.optional_number(
      {"max_force", "N", "at which the spring saturates; without it, just below the device's limit"},
      coupling.max_force, above_to(0, 1000));
  visitor.optional_number(
      {"max_torque", "N m",
       "at which the spring saturates in rotation; without it, just below the device's limit"},
      coupling.max_torque, above_to(0, 100));
}

void describe_velocity_estimator(KeyVisitor& visitor, VelocityEstimatorDesc& velocity) {
  const Form difference{"difference", "one tick's difference: no delay but half a tick, and all of the noise",
                        [](KeyVisitor&) {}};
  const Form low_pass{
      "low_pass", "the difference through a first-order low-pass", [&](KeyVisitor& each) {
        each.number({"cutoff_Hz", "", "of the low-pass"}, velocity.cutoff_Hz, above_to(0, 10000));
      }};
  const Form adaptive{"adaptive_window",
                      "the longest window over which the motion is a straight line within the noise",
                      [&](KeyVisitor& each) {
                        std::int64_t window = velocity.window;
                        each.integer({"window", "ticks", "most ticks looked back"}, window, 1, 1000);
                        velocity.window = static_cast<int>(window);
                        each.number({"noise", "m", "in the world; largest deviation that counts as noise"},
                                    velocity.noise, above_to(0, 0.1));
                        each.number({"noise_rad", "", "in the world; largest turn that counts as noise"},
                                    velocity.noise_rad, above_to(0, 1));
                      }};
  auto kind = static_cast<std::size_t>(velocity.kind);
  visitor.forms({"velocity_estimator", "", "how velocity is made of sampled positions"},
                {"name", "", "which estimator; the other keys are its own"}, kind,
                std::array{difference, low_pass, adaptive});
  velocity.kind = static_cast<VelocityEstimatorKind>(kind);
}

void describe_device(KeyVisitor& visitor, DeviceEntry& device) {
  MappingDesc& mapping = device.mapping;
  visitor.word(
      {"model", "",
       "of the simulated device: content/devices/MODEL.yaml, or the scenario's own devices/MODEL.yaml", true},
      device.model);
  visitor.word(
      {"beside", "",
       "of what vibrates or senses besides: content/devices/BESIDE.yaml, whose channels or strip take "
       "the place of the model's"},
      device.beside);
  visitor.number({"position_scale", "", "scene movement for device movement"}, mapping.position_scale,
                 above_to(0, 1000));
  visitor.number({"force_scale", "", "device force for scene force"}, mapping.force_scale, above_to(0, 1000));
  visitor.mapping({"base", "", "of the device in the scene"}, [&](KeyVisitor& inner) {
    describe_pose(inner, mapping.X_WD, "of the device's origin in the world",
                  "of the device's axes [w, x, y, z]");
  });
  visitor.choice_of(
      {"allocation", "", "what motors do with more than they can: exact, algorithm1 or pseudoinverse"},
      device.allocation.method);
  visitor.number(
      {"moment_weight", "", "what missing moment counts beside missing force, by exact allocation"},
      device.allocation.moment_weight, above_to(0, 1e6));
  std::int64_t button = mapping.clutch_button;
  visitor.integer({"clutch_button", "", "while it is down the handle moves without the tool; -1: none"},
                  button, -1, 31);
  mapping.clutch_button = static_cast<int>(button);
  visitor.number(
      {"drift", "",
       "while the tool is free the scene creeps by up to this part of the handle's way, so that the "
       "hand comes back to the workspace's middle; 0: it does not"},
      mapping.drift, from_to(0, MappingDesc::kMostDrift));
  visitor.boolean({"drawn", "", "its arms are seen in the scene, and the loads of their motors as bars"},
                  device.drawn);
  visitor.rule("drawn", !device.drawn || mapping.position_scale == 1,
               "needs a position_scale of 1: arms are drawn in their own size");
  visitor.rule("drawn", !device.drawn || mapping.drift == 0,
               "needs a drift of 0: drawn arms stand where they are, and cannot creep with the tool");
  visitor.optional_number({"floor", "m", "height in the world of what the drawn arms stand on"}, device.floor,
                          from_to(-100, 100));
}

}  // namespace

void describe_tool(KeyVisitor& visitor, ToolEntry& tool) {
  visitor.optional_number({"density", "kg/m^3", "the mass follows from the model's volume"}, tool.density,
                          above_to(0, 25000));
  visitor.optional_number({"mass", "kg", "instead of density; with neither it is 0.2 kg"}, tool.mass,
                          above_to(0, 100));
  visitor.rule("mass", !(tool.density && tool.mass),
               "and 'tool.density' exclude each other; keep one of them");
  visitor.mapping(
      {"grasp", "", "the model in the handle, when nothing touches it"},
      [&](KeyVisitor& inner) {
        describe_pose(inner, tool.X_HM, "in the handle's frame", "in the handle's frame [w, x, y, z]");
      });
  visitor.mapping({"start", "", "the model in the world, at the beginning", true}, [&](KeyVisitor& inner) {
    describe_pose(inner, tool.X_WM_start, "in the world", "in the world [w, x, y, z]");
  });
  visitor.vector({"touch_point", "m", "in the model's frame; what has to reach the checkpoints"},
                 tool.touch_point, kPosition);
  visitor.text({"touch_name", "",
                "what the tool has at the touch_point, such as 'the tip': the picture calls it so; without "
                "it 'the touch point'"},
               tool.touch_name);
  visitor.boolean({"weight", "", "gravity acts on the tool, and the hand feels it"}, tool.weight);
}

void describe_resolution(KeyVisitor& visitor, FieldDesc& field) {
  visitor.number(
      {"error", "m", "wanted of contacts on 95 % of the surface; chooses the voxel where none is given"},
      field.error_m, above_to(0, 1));
  visitor.optional_number({"voxel", "m", "edge of a cell; at least three across the thinnest wall"},
                          field.voxel_m, above_to(0, 1));
  visitor.optional_number(
      {"band", "m", "how far from the surface the field is stored in full; without it two voxels"},
      field.band_m, above_to(0, 10));
  visitor.rule("band", !field.voxel_m || !field.band_m || *field.band_m >= 2 * *field.voxel_m,
               "must be at least two voxels");
}

void describe_mechanics(KeyVisitor& visitor, Scenario& scenario) {
  visitor.mapping({"field", "", "the distance field that the scene's models are baked to"},
                  [&](KeyVisitor& inner) {
                    describe_resolution(inner, scenario.field);
                    inner.choice_of({"format", "", "how its values are stored; int16 takes half the memory"},
                                    scenario.field.format);
                  });
  visitor.mapping({"shell", "", "the points that the tool's model is baked to"}, [&](KeyVisitor& inner) {
    inner.number({"spacing", "m", "between neighbours"}, scenario.shell.spacing_m, above_to(0, 1));
    inner.number(
        {"deviation", "m", "how far the surface may stand out from between its points, against a flat wall"},
        scenario.shell.deviation, above_to(0, 1));
  });
  visitor.mapping({"contact", "", "how the scene answers to touch"}, [&](KeyVisitor& inner) {
    describe_contact(inner, scenario.contact);
    inner.number({"edges", "m",
                  "between points on the scene's sharp edges, which then stay out of the tool, "
                  "under the response constraint on points; 0: none"},
                 scenario.edges, from_to(0, 1));
    inner.choice_of({"surface", "",
                     "what the response constraint measures contact on: the triangles of tool and scene as "
                     "they are, or the tool's points in the distance field, for less of a tick"},
                    scenario.surface);
  });
  visitor.choice_of({"integrator", "", "how the tool moves through a tick"}, scenario.integrator);
  visitor.mapping({"coupling", "", "the virtual coupling between hand and tool"},
                  [&](KeyVisitor& inner) { describe_coupling(inner, scenario.coupling); });
  describe_velocity_estimator(visitor, scenario.velocity_estimator);
  visitor.mapping({"device", "", "the device, and how its workspace lies in the scene", true},
                  [&](KeyVisitor& inner) {
                    describe_device(inner, scenario.device);
                    describe_effects_of_device(inner, scenario);
                  });
}

}  // namespace fulcrum::scenario
