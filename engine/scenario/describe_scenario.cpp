#include <algorithm>
#include <string>

#include "engine/scenario/describe.h"

namespace fulcrum::scenario {

namespace {

void describe_models(KeyVisitor& visitor, std::vector<ModelEntry>& models) {
  visitor.named(
      {"models", "", "the model files, each under a name of its own", true}, 1,
      [&](std::string_view name, KeyVisitor& each) {
        ModelEntry& model = models.emplace_back();
        model.name = name;
        each.file({"file", "", "a glTF file in the scenario's folder; Y up", true}, model.file);
        each.choice_of({"role", "", "scene: touched; tool: held in the hand; decor: seen only", true},
                       model.role);
        each.boolean(
            {"marked", "",
             "of the file's objects those alone that are marked with this role, by a custom property "
             "'fulcrum_role', and with this material, by 'fulcrum_material'"},
            model.marked);
        each.file({"drawn", "",
                   "of what is touched or held: a glTF file that is drawn in its place, coarser or finer"},
                  model.drawn);
        each.rule("drawn", model.drawn.name.empty() || model.role != ModelRole::decor,
                  "is for what is touched or held: of decor 'file' itself is drawn");
        each.choice_of({"unit", "", "of the file's numbers: m, cm, mm, um, in or ft; glTF is in m"},
                       model.unit);
        each.each_axis({"scale", "", "of the model about its file's origin, along the file's axes"},
                       model.scale, above_to(0, 1e6));
        describe_pose(each, model.X_MF, "of the file's origin: in the world, or of a tool in its own frame",
                      "of the file's axes there [w, x, y, z]");
        each.word(
            {"cut_of", "", "of decor: the model that it shows cut open, in its place in views with 'cut'"},
            model.cut_of);
        each.rule("cut_of", model.cut_of.empty() || model.role == ModelRole::decor,
                  "is for a model with 'role: decor'");
        each.word(
            {"material", "",
             "of a scene: what a blow on it sounds like, content/materials/MATERIAL.yaml; without it that "
             "of the effect that vibrates at impacts"},
            model.material);
        each.rule("material", model.material.empty() || model.role == ModelRole::scene,
                  "is for a model with 'role: scene'");
        each.boolean(
            {"lettering", "", "of decor: it is to be read; where the scene is mirrored it is not drawn"},
            model.lettering);
        each.rule("lettering", !model.lettering || model.role == ModelRole::decor,
                  "is for a model with 'role: decor'");
      });
  const auto count = [&](ModelRole role) { return std::ranges::count(models, role, &ModelEntry::role); };
  visitor.rule("models", count(ModelRole::tool) == 1, "must have exactly one model with 'role: tool'");
  for (const ModelEntry& model : models) {
    const auto whole = std::ranges::find(models, model.cut_of, &ModelEntry::name);
    visitor.rule("models", model.cut_of.empty() || (whole != models.end() && whole->role == ModelRole::scene),
                 "has a 'cut_of' that is not the name of a model with 'role: scene'");
  }
  visitor.rule("models", count(ModelRole::scene) >= 1,
               "must have a model with 'role: scene', something to touch");
}

constexpr double kFarthestScatter = 0.1;  // m: more of it is a slip of the unit

void describe_materials(KeyVisitor& visitor, std::vector<MaterialOverride>& materials) {
  visitor.named(
      {"materials", "", "replaces what the models say about the material of that name"}, 0,
      [&](std::string_view name, KeyVisitor& each) {
        MaterialOverride& material = materials.emplace_back();
        material.name = name;
        material.where = each.where();
        each.optional_colour({"base_colour", "", "of a metal: its reflectance"}, material.base_colour);
        each.optional_number({"metallic", "", "0 dielectric to 1 metal"}, material.metallic, kFraction);
        each.optional_number({"roughness", "", "0 mirror to 1 matt"}, material.roughness, kFraction);
        each.each_axis({"scatter_distance", "m",
                        "how far red, green and blue light spread below the surface: half of it comes out "
                        "again within 1.55 of these distances"},
                       material.scatter_distance, from_to(0, kFarthestScatter));
      });
}

// s, of a waypoint's dwell after its stop: longer than a tick of the slowest loop.
constexpr double kLeastGoOn = 0.1;

void describe_yielding(KeyVisitor& visitor, YieldingDesc& yields) {
  visitor.number({"reaction", "s", "from a cue to the hand's first motion by it"}, yields.reaction,
                 from_to(0, 2));
  visitor.number({"gain", "rad/s", "how fast it turns back at a full cue"}, yields.gain, above_to(0, 20));
  visitor.number({"spread", "", "of reaction and gain from seed to seed: log-normal, those two the medians"},
                 yields.spread, from_to(0, 1));
  visitor.number({"full_vibration", "N", "the amplitude that is a full cue"}, yields.full_vibration,
                 above_to(0, 100));
  visitor.number({"least_vibration", "N", "the amplitude below which nothing is felt"},
                 yields.least_vibration, above_to(0, 100));
  visitor.number({"felt_error_rad", "", "rms, of the way back under vibration alone"}, yields.felt_error_rad,
                 from_to(0, 1.5));
  visitor.number({"seen_error_rad", "", "rms, of the way back where the ghost is seen"},
                 yields.seen_error_rad, from_to(0, 1.5));
  visitor.number({"recovery", "s", "time constant of going on with what it meant to do"}, yields.recovery,
                 above_to(0, 100));
}

void describe_hands(KeyVisitor& visitor, std::vector<HandEntry>& hands) {
  visitor.named(
      {"hands", "", "simulated hands for runs without a person, by name"}, 0,
      [&](std::string_view name, KeyVisitor& each) {
        HandEntry& entry = hands.emplace_back();
        entry.name = name;
        HandDesc& hand = entry.desc;
        each.file({"path", "", "a file of waypoints in the scenario's folder", true}, entry.path);
        each.number({"stiffness", "N/m", "of the hand about its path"}, hand.stiffness, above_to(0, 1e5));
        each.number({"damping", "N s/m", "of the hand about its path"}, hand.damping, from_to(0, 1e4));
        each.number({"mass", "kg", "of the hand that moves with the handle, where it holds it"}, hand.mass,
                    from_to(0, 10));
        each.number({"angular_stiffness", "N m/rad", "of the hand about its path, in rotation"},
                    hand.angular_stiffness, above_to(0, 1e3));
        each.number({"angular_damping", "N m s/rad", "of the hand about its path, in rotation"},
                    hand.angular_damping, from_to(0, 1e2));
        each.number({"tremor", "m", "rms on each axis"}, hand.tremor, from_to(0, 0.05));
        each.number({"tremor_rad", "", "rms on each axis"}, hand.tremor_rad, from_to(0, 0.5));
        each.number({"tremor_low_Hz", "", "lower edge of the tremor's band"}, hand.tremor_low_Hz,
                    above_to(0, 100));
        each.number({"tremor_high_Hz", "", "upper edge of the tremor's band"}, hand.tremor_high_Hz,
                    above_to(0, 100));
        each.rule("tremor_high_Hz", hand.tremor_high_Hz > hand.tremor_low_Hz,
                  "must be above 'tremor_low_Hz'");
        each.mapping(
            {"yields", "", "the hand turns back where it is told of torque: a model of no person"},
            [&](KeyVisitor& inner) { describe_yielding(inner, hand.yields.emplace()); });
      });
}

}  // namespace

void describe_scenario(KeyVisitor& visitor, Scenario& scenario) {
  visitor.version({"fulcrum", "", "version of the file's format", true}, kFormatVersion);
  visitor.text({"title", "", "as lists and windows show it", true}, scenario.title);
  visitor.text({"about", "", "one line for `fulcrum list`", true}, scenario.about);
  visitor.choice_of({"difficulty", "", "for whom it is: easy, medium or hard; without it nobody is told"},
                    scenario.difficulty);
  visitor.number({"time_limit", "s", "of simulated time; a run that takes longer ends not completed", true},
                 scenario.time_limit, above_to(0, 86400));
  visitor.integer({"seed", "", "of everything random in a run"}, scenario.seed, 0,
                  std::numeric_limits<std::int64_t>::max());
  visitor.number({"tick_rate_Hz", "", "of the haptic loop"}, scenario.tick_rate_Hz,
                 from_to(kSlowestTicks_Hz, kFastestTicks_Hz));
  visitor.boolean({"left_handed", "", "the scene is mirrored, for a tool in the left hand"},
                  scenario.left_handed);
  describe_models(visitor, scenario.models);
  describe_materials(visitor, scenario.materials);
  visitor.mapping({"tool", "", "the tool in the hand; poses are of its model's own frame", true},
                  [&](KeyVisitor& inner) { describe_tool(inner, scenario.tool); });
  describe_mechanics(visitor, scenario);
  describe_effects(visitor, scenario);
  describe_task(visitor, scenario);
  describe_hands(visitor, scenario.hands);
  check_expert(visitor, scenario);
  describe_look(visitor, scenario);
  describe_sound(visitor, scenario);
}

void describe_hand_path(KeyVisitor& visitor, std::vector<Waypoint>& waypoints) {
  visitor.version({"fulcrum", "", "version of the file's format", true}, kFormatVersion);
  visitor.list(
      {"waypoints", "", "where the hand wants the tool's model, in order", true}, 1, [&](KeyVisitor& each) {
        Waypoint& waypoint = waypoints.emplace_back();
        describe_pose(each, waypoint.X_WT, "of the tool's model in the world",
                      "of the tool's model in the world [w, x, y, z]");
        each.number({"travel", "s", "from the waypoint before; the first has none"}, waypoint.travel,
                    above_to(0, 3600));
        each.number({"dwell", "s", "how long the hand rests here"}, waypoint.dwell, from_to(0, 3600));
        each.boolean(
            {"through", "",
             "the hand goes through without a rest; not of the first and the last, which it rests at"},
            waypoint.through);
        each.rule("through", !waypoint.through || waypoint.dwell <= 0, "is for a waypoint without 'dwell'");
        each.optional_number(
            {"hold", "m",
             "where the hand holds the stick from here on, along it from the handle's origin; "
             "on the way there it slides. Without it as at the waypoint before, and at the "
             "handle's origin to begin with"},
            waypoint.hold, from_to(-1, 1));
        each.optional_number(
            {"press", "N",
             "on the stick's strip. Without it as at the waypoint before, and 2 N to begin with"},
            waypoint.press, from_to(0, 100));
        each.optional_number({"stop", "s",
                              "the hand stops the force on arrival, and takes it up again so long after; "
                              "without it it does not"},
                             waypoint.stop, above_to(0, 3600));
        each.rule("stop", !waypoint.stop || *waypoint.stop + kLeastGoOn <= waypoint.dwell,
                  "must end 0.1 s before 'dwell' does, so that the hand takes the force up again");
      });
}

}  // namespace fulcrum::scenario
