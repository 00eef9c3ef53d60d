#include "engine/scenario/assemble.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "haptics/world/world.h"
#include "tests/scenario/box_glb.h"
#include "tests/scenario/example.h"

namespace fulcrum::scenario::test {
namespace {

// A plate of 200 x 20 x 200 mm below the origin; a peg of 10 x 40 x 10 mm whose origin is at the middle of
// its foot.
class Assemble : public testing::Test {
protected:
  Assemble() {
    folder_.write("scenarios/peg/block.glb", box_glb({-0.1F, -0.02F, -0.1F}, {0.1F, 0.0F, 0.1F}));
    folder_.write("scenarios/peg/peg.glb", box_glb({-0.005F, 0.0F, -0.005F}, {0.005F, 0.04F, 0.005F}));
  }

  Scenario read(const std::vector<std::string>& overrides = {}, const std::string& more = "") {
    auto scenario = load_scenario_text(std::string(kScenario) + more, folder_.peg(), overrides);
    if (!scenario) ADD_FAILURE() << to_text(scenario.faults());
    return scenario ? std::move(*scenario) : Scenario{};
  }

  Folder folder_;
  BakeCache cache_{folder_.root() / "cache"};
};

const std::vector<std::string> kCoarse{"contact.surface=points", "field.voxel=0.004", "field.band=0.012",
                                       "shell.spacing=0.003"};

TEST_F(Assemble, PutsTheToolOnItsCentreOfMass) {
  auto overrides = kCoarse;
  overrides.insert(overrides.end(), {"tool.density=7850", "touch_point=[0, 0.04, 0]", "touch_name=the tip",
                                     "grasp.position=[0, 0.01, 0]"});
  const Scenario scenario = read(overrides);
  const auto models = load_models(scenario);
  ASSERT_TRUE(models) << to_text(models.faults());
  EXPECT_LT((models->p_MT - Vec3(0, 0.02, 0)).norm(), 1e-8);
  ASSERT_EQ(models->notes.size(), 1u);
  EXPECT_EQ(models->notes[0],
            "the tool's centre of mass lies 20 mm from the origin of 'peg.glb'; the tool is moved and turned "
            "about its "
            "centre of mass");

  const auto haptic = assemble_haptic(scenario, *models, cache_);
  ASSERT_TRUE(haptic) << haptic.error().sentence;
  const ToolDesc& tool = haptic->scene.tool;
  const double mass = 7850 * 0.01 * 0.04 * 0.01;
  EXPECT_NEAR(tool.mass, mass, mass * 1e-6);
  EXPECT_NEAR(tool.inertia_T(1, 1), mass / 12 * (2 * 0.01 * 0.01), mass * 1e-10);
  EXPECT_NEAR(tool.inertia_T(0, 0), mass / 12 * (0.01 * 0.01 + 0.04 * 0.04), mass * 1e-9);
  // The model stays where the author put it: start, grasp, touch point and path move with T.
  EXPECT_LT((tool.X_WT_start.p - Vec3(0, 0.12, 0)).norm(), 1e-8);
  EXPECT_LT((tool.X_HT.p - Vec3(0, 0.03, 0)).norm(), 1e-8);
  EXPECT_LT((haptic->task.touch_point - Vec3(0, 0.02, 0)).norm(), 1e-8);
  EXPECT_EQ(haptic->task.touch_name, "the tip");
  ASSERT_EQ(haptic->hands.size(), 1u);
  EXPECT_LT((haptic->hands[0].waypoints[0].X_WT.p - Vec3(0, 0.12, 0)).norm(), 1e-8);
  EXPECT_LT((haptic->hands[0].waypoints[1].X_WT.p - Vec3(0, -0.02, 0)).norm(),
            1e-8);  // turned upside down about x
  EXPECT_LT((haptic->tool_T.bounds().center()).norm(), 1e-8);
  EXPECT_NEAR(haptic->scene.tool_shell->max_radius_m, Vec3(0.005, 0.02, 0.005).norm(), 1e-6);
}

TEST_F(Assemble, LetteringIsNotDrawnWhereItWouldBeMirrorWritten) {
  for (const bool left : {false, true}) {
    std::vector<std::string> overrides = kCoarse;
    overrides.emplace_back(left ? "left_handed=true" : "left_handed=false");
    folder_.write("scenarios/peg/sign.glb", box_glb({0.05F, 0.0F, 0.0F}, {0.06F, 0.01F, 0.01F}));
    const std::string text =
        replaced(kScenario, "models:\n", "models:\n  sign: {file: sign.glb, role: decor, lettering: true}\n");
    const auto scenario = load_scenario_text(text, folder_.peg(), overrides);
    ASSERT_TRUE(scenario) << to_text(scenario.faults());
    const auto models = load_models(*scenario);
    ASSERT_TRUE(models) << to_text(models.faults());
    const auto haptic = assemble_haptic(*scenario, *models, cache_);
    ASSERT_TRUE(haptic) << haptic.error().sentence;
    const auto visual = assemble_visual(*scenario, *models, haptic->scene);
    ASSERT_TRUE(visual) << to_text(visual.faults());
    EXPECT_EQ(std::ranges::count(visual->desc.instances, "sign/box", &render::Instance::name), left ? 0 : 1);
    const auto said = std::ranges::count_if(models->notes, [](const std::string& note) {
      return note == "the model 'sign' is not drawn: it would be mirror-written";
    });
    EXPECT_EQ(said, left ? 1 : 0);
  }
  EXPECT_NE(faults_of(folder_, replaced(kScenario, "role: tool}", "role: tool, lettering: true}"))
                .find("'role: decor'"),
            std::string::npos);
}

TEST_F(Assemble, CarriesTheScenarioIntoTheScene) {
  const Scenario scenario = read(kCoarse);
  const auto models = load_models(scenario);
  ASSERT_TRUE(models) << to_text(models.faults());
  const auto haptic = assemble_haptic(scenario, *models, cache_);
  ASSERT_TRUE(haptic) << haptic.error().sentence;
  EXPECT_EQ(haptic->scene.tick_s, 1e-3);
  EXPECT_EQ(haptic->scene.contact.stiffness, 5000);
  EXPECT_EQ(haptic->scene.device.name, "Test arm");
  EXPECT_EQ(haptic->scene.tool.mass, ToolDesc{}.mass);  // neither mass nor density is given
  EXPECT_EQ(haptic->task.dwell, 3);
  EXPECT_NEAR(haptic->scene.scene_field->distance(Vec3(0, 0.01, 0)), 0.01, 1e-4);
  EXPECT_NEAR(haptic->scene.scene_field->distance(Vec3(0, -0.005, 0)), -0.005, 1e-4);
  EXPECT_EQ(haptic->scene_W.components.size(), 1u);
}

TEST_F(Assemble, MeasuresContactOnTrianglesWhereTheSceneSaysSo) {
  Scenario scenario = read(kCoarse);
  const auto models = load_models(scenario);
  ASSERT_TRUE(models) << to_text(models.faults());
  const auto on_points = assemble_haptic(scenario, *models, cache_);
  ASSERT_TRUE(on_points) << on_points.error().sentence;
  EXPECT_FALSE(on_points->scene.tool_features || on_points->scene.scene_features);
  scenario.surface = ContactSurface::triangles;
  scenario.contact.response = ContactResponse::constraint;
  const auto on_triangles = assemble_haptic(scenario, *models, cache_);
  ASSERT_TRUE(on_triangles) << on_triangles.error().sentence;
  ASSERT_TRUE(on_triangles->scene.tool_features && on_triangles->scene.scene_features);
  EXPECT_EQ(on_triangles->scene.tool_features->faces().size(), on_triangles->tool_T.mesh.triangles.size());
  EXPECT_EQ(on_triangles->scene.scene_features->faces().size(), on_triangles->scene_W.mesh.triangles.size());
  EXPECT_FALSE(on_triangles->scene.tool_shell || on_triangles->scene.scene_field);
  EXPECT_TRUE(World::build(on_triangles->scene));
  // Impacts are told apart in the field, on whatever device asks for them.
  Scenario with_impacts = scenario;
  with_impacts.effects.braking_pulse.emplace();
  const auto struck = assemble_haptic(with_impacts, *models, cache_);
  ASSERT_TRUE(struck) << struck.error().sentence;
  EXPECT_TRUE(struck->scene.tool_features && struck->scene.tool_shell && struck->scene.scene_field);
  // Another response looks points up.
  scenario.contact.response = ContactResponse::quasi_static;
  const auto otherwise = assemble_haptic(scenario, *models, cache_);
  ASSERT_TRUE(otherwise) << otherwise.error().sentence;
  EXPECT_FALSE(otherwise->scene.tool_features);
}

TEST_F(Assemble, TellsAboutTheBakes) {
  const Scenario scenario = read(kCoarse);
  const auto models = load_models(scenario);
  ASSERT_TRUE(models) << to_text(models.faults());
  std::vector<std::string> told;
  double last = 0;
  const auto progress = [&](std::string_view what, double fraction) {
    if (told.empty() || told.back() != what) told.emplace_back(what);
    last = fraction;
  };
  const auto first = assemble_haptic(scenario, *models, cache_, progress);
  ASSERT_TRUE(first) << first.error().sentence;
  EXPECT_EQ(told, (std::vector<std::string>{"pointshell", "distance field"}));
  EXPECT_EQ(last, 1);
  ASSERT_EQ(first->notes.size(), 3u);
  EXPECT_NE(first->notes[1].find("baked in"), std::string::npos) << first->notes[1];
  EXPECT_NE(first->notes[2].find("baked in"), std::string::npos) << first->notes[2];
  const auto second = assemble_haptic(scenario, *models, cache_);
  ASSERT_TRUE(second) << second.error().sentence;
  EXPECT_NE(second->notes[1].find("from the cache"), std::string::npos) << second->notes[1];
  EXPECT_NE(second->notes[2].find("from the cache"), std::string::npos) << second->notes[2];
}

TEST_F(Assemble, TellsWhatWasRepaired) {
  folder_.write("scenarios/peg/block.glb", box_glb({-0.1F, -0.02F, -0.1F}, {0.1F, 0.0F, 0.1F}, true));
  folder_.write("scenarios/peg/peg.glb", box_glb({-0.005F, 0.0F, -0.005F}, {0.005F, 0.04F, 0.005F}, true));
  const Scenario scenario = read(kCoarse);
  const auto models = load_models(scenario);
  ASSERT_TRUE(models) << to_text(models.faults());
  const auto haptic = assemble_haptic(scenario, *models, cache_);
  ASSERT_TRUE(haptic) << haptic.error().sentence;
  ASSERT_EQ(haptic->repaired.size(), 2u);
  constexpr const char* kTurned = "1 triangle was wound against the rest and has been turned, at (";
  EXPECT_NE(haptic->repaired[0].find(std::string("model 'peg': ") + kTurned), std::string::npos)
      << haptic->repaired[0];
  EXPECT_TRUE(haptic->repaired[1].starts_with(std::string("the models that are touched: ") + kTurned))
      << haptic->repaired[1];
  EXPECT_NEAR(haptic->scene.scene_field->distance(Vec3(0, -0.005, 0)), -0.005, 1e-4);
}

// A block of 200 mm that was exported in millimetres as if they were metres, and a peg that was scaled twice.
TEST_F(Assemble, QuestionsTheSizeOfAModel) {
  EXPECT_TRUE(load_models(read(kCoarse))->warnings.empty());
  folder_.write("scenarios/peg/block.glb", box_glb({-100.0F, -20.0F, -100.0F}, {100.0F, 0.0F, 100.0F}));
  folder_.write("scenarios/peg/peg.glb", box_glb({-5e-6F, 0.0F, -5e-6F}, {5e-6F, 4e-5F, 5e-6F}));
  const auto models = load_models(read(kCoarse));
  ASSERT_TRUE(models) << to_text(models.faults());
  ASSERT_EQ(models->warnings.size(), 2u);
  EXPECT_NE(models->warnings[0].sentence.find("model 'block': it is 284 m across; is that meant?"),
            std::string::npos)
      << models->warnings[0].sentence;
  EXPECT_NE(models->warnings[1].sentence.find("model 'peg': it is 42.4 um across"), std::string::npos)
      << models->warnings[1].sentence;
  EXPECT_TRUE(models->warnings[1].sentence.ends_with(".")) << models->warnings[1].sentence;
}

// The block's file has 200 x 40 x 200 mm; half as high, turned by 90 degrees about x and moved it is 0.2 m
// wide and high, and 20 mm thick.
TEST_F(Assemble, PlacesAModelByUnitScaleAndPose) {
  folder_.write("scenarios/peg/block.glb", box_glb({-100.0F, -40.0F, -100.0F}, {100.0F, 0.0F, 100.0F}));
  const std::string text =
      replaced(kScenario, "{file: block.glb,",
               "{file: block.glb, unit: mm, scale: [1, 0.5, 1], position: [0.3, 0.2, 0.1], "
               "orientation: [0.70710678, 0.70710678, 0, 0],");
  const auto scenario = load_scenario_text(text, folder_.peg(), kCoarse);
  ASSERT_TRUE(scenario) << to_text(scenario.faults());
  const auto models = load_models(*scenario);
  ASSERT_TRUE(models) << to_text(models.faults());
  EXPECT_TRUE(models->warnings.empty()) << to_text(models->warnings);
  const auto scene = build_scene_solid(*scenario, *models);
  ASSERT_TRUE(scene) << to_text(scene.faults());
  EXPECT_LT((scene->bounds().min() - Vec3(0.2, 0.1, 0.08)).norm(), 1e-7);
  EXPECT_LT((scene->bounds().max() - Vec3(0.4, 0.3, 0.1)).norm(), 1e-7);
  ASSERT_EQ(scene->components.size(), 1u);
  EXPECT_NEAR(scene->components[0].volume_m3, 0.2 * 0.2 * 0.02, 1e-9);
  EXPECT_TRUE(scene->notes.empty());
  // Normals stand on what they belong to.
  const ModelPart& part = models->models[0].parts[0];
  for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3) {
    const auto corner = [&](std::size_t k) { return part.positions[part.indices[i + k]]; };
    const Vec3 outward = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
    EXPECT_GT(outward.dot(part.normals[part.indices[i]]), 0.999);
  }
}

// A tool's place is that in its own frame: the start, the grasp and the touch point are of the placed model.
TEST_F(Assemble, PlacesAToolInItsOwnFrame) {
  const auto models = load_models(read({"models.peg.position=[0, -0.02, 0]", "models.peg.unit=cm"}));
  ASSERT_TRUE(models) << to_text(models.faults());
  EXPECT_LT((models->p_MT - Vec3(0, -0.0198, 0)).norm(), 1e-8);
  EXPECT_NEAR(models->tool_T.bounds().diagonal().y(), 0.0004, 1e-9);
}

TEST_F(Assemble, RefusesAModelOutOfAllBounds) {
  const auto models = load_models(read({"models.peg.scale=1e6", "models.block.scale=[1, 1, 1e6]"}));
  ASSERT_FALSE(models);
  ASSERT_EQ(models.faults().size(), 1u) << "the peg is 40 km long, the block 200";
  EXPECT_EQ(models.faults()[0].sentence.find("model 'block': it is moved or scaled out of all bounds"), 0u);
}

TEST_F(Assemble, NamesEveryModelThatCannotBeUsed) {
  folder_.write("scenarios/peg/block.glb", "not a model");
  const auto models = load_models(read({"models.peg.file=none.glb"}));
  ASSERT_FALSE(models);
  ASSERT_EQ(models.faults().size(), 2u);
  EXPECT_EQ(models.faults()[0].file, "scenario.yaml");
  EXPECT_EQ(models.faults()[0].line, 6);
  EXPECT_EQ(models.faults()[0].column, 17);
  EXPECT_EQ(models.faults()[1].file, "--set models.peg.file=none.glb");
}

TEST_F(Assemble, DrawsTheToolAboutItsCentreOfMass) {
  const Scenario scenario = read({}, "materials: {steel: {base_colour: [1, 0, 0], roughness: 0.25}}\n");
  const auto models = load_models(scenario);
  ASSERT_TRUE(models) << to_text(models.faults());
  const auto visual = assemble_visual(scenario, *models, {});
  ASSERT_TRUE(visual) << to_text(visual.faults());
  const render::VisualDesc& desc = visual->desc;
  ASSERT_EQ(desc.instances.size(), 2u);
  EXPECT_FALSE(desc.instances[0].movable);
  EXPECT_EQ(desc.instances[0].name, "block/box");
  EXPECT_TRUE(desc.instances[1].movable);
  EXPECT_NEAR(desc.instances[1].X_WM[3].y, 0.12F, 1e-6F);
  for (const glm::vec3& p : desc.meshes[desc.instances[1].mesh].positions)
    EXPECT_NEAR(std::abs(p.y), 0.02F, 1e-6F);
  const render::Material& steel = desc.materials[desc.instances[1].material];
  EXPECT_EQ(steel.base_colour, glm::vec3(1, 0, 0));
  EXPECT_EQ(steel.roughness, 0.25F);
  EXPECT_EQ(steel.metallic, 1.0F);  // as the model says
  ASSERT_EQ(desc.markers.size(), 1u);
  EXPECT_EQ(desc.markers[0].name, "hole");
  EXPECT_EQ(desc.camera.eye, glm::vec3(0, 0.1F, 0.5F));
  EXPECT_EQ(visual->views.size(), 1u);
}

// One number is for all three colours; of zero there is nothing.
TEST_F(Assemble, LightSpreadsBelowAMaterialThatSaysSo) {
  const auto distance_of = [&](const std::string& materials) -> std::optional<glm::vec3> {
    const Scenario scenario = read({}, materials);
    const auto models = load_models(scenario);
    const auto visual = assemble_visual(scenario, *models, {});
    const render::VisualDesc& desc = visual->desc;
    const auto& detail = desc.materials[desc.instances[1].material].detail;
    return detail ? std::optional(detail->scatter_distance) : std::nullopt;
  };
  EXPECT_EQ(distance_of("materials: {steel: {metallic: 0, scatter_distance: [0.001, 0.0005, 0]}}\n"),
            glm::vec3(0.001F, 0.0005F, 0));
  EXPECT_EQ(distance_of("materials: {steel: {metallic: 0, scatter_distance: 0.002}}\n"), glm::vec3(0.002F));
  EXPECT_FALSE(distance_of("materials: {steel: {scatter_distance: 0.002}}\n")) << "it is metal";
  EXPECT_FALSE(distance_of("materials: {steel: {scatter_distance: 0}}\n"));
  EXPECT_FALSE(distance_of(""));
}

TEST_F(Assemble, GuidanceLeadsAlongTheExpertsWay) {
  const auto scenario =
      load_scenario_text(replaced(kScenario, "  sure: ", "  expert: ") + "guidance: {dead_band: 0.003}\n",
                         folder_.peg(), kCoarse);
  ASSERT_TRUE(scenario) << to_text(scenario.faults());
  ASSERT_TRUE(scenario->effects.guidance);
  const auto models = load_models(*scenario);
  ASSERT_TRUE(models) << to_text(models.faults());
  const auto haptic = assemble_haptic(*scenario, *models, cache_);
  ASSERT_TRUE(haptic) << haptic.error().sentence;
  const std::vector<GuidancePose>& way = haptic->scene.guidance->way;
  ASSERT_EQ(way.size(), 2u);
  EXPECT_EQ(way[0].time, 0);
  EXPECT_EQ(way[1].time, 2);
  EXPECT_TRUE(way[0].rests);
  EXPECT_FALSE(way[1].rests);
  for (std::size_t i = 0; i < way.size(); ++i) {  // of T, as the hand has it
    EXPECT_EQ(way[i].X_WT.p, haptic->hands[0].waypoints[i].X_WT.p);
    EXPECT_EQ(way[i].X_WT.q.coeffs(), haptic->hands[0].waypoints[i].X_WT.q.coeffs());
  }
  EXPECT_EQ(assemble_visual(*scenario, *models, haptic->scene)->desc.ghosts.size(), 1u);
  SceneDesc unnamed = haptic->scene;
  unnamed.guidance.reset();
  EXPECT_TRUE(assemble_visual(*scenario, *models, unnamed)->desc.ghosts.empty());
}

// So many points, on a box.
std::string lit_box(std::size_t count) {
  const std::string glb = box_glb({-0.01F, -0.01F, -0.01F}, {0.01F, 0.01F, 0.01F});
  std::string lights, nodes, roots;
  for (std::size_t i = 0; i < count; ++i) {
    lights += std::string(i == 0 ? "" : ",") + R"({"type":"point","intensity":683})";
    nodes += R"(,{"extensions":{"KHR_lights_punctual":{"light":)" + std::to_string(i) + "}}}";
    roots += "," + std::to_string(i + 1);
  }
  const std::size_t json_size = glb.find("BIN") - 4 - 20;
  std::string json = replaced(glb.substr(20, json_size), R"("nodes":[0])", R"("nodes":[0)" + roots + "]");
  json = replaced(json, R"("name":"box"}],"materials)", R"("name":"box"})" + nodes + R"(],"materials)");
  json = replaced(json, R"({"asset")",
                  R"({"extensions":{"KHR_lights_punctual":{"lights":[)" + lights + R"(]}},"asset")");
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string made = glb.substr(0, 20) + json + glb.substr(20 + json_size);
  const auto put = [&](std::size_t at, std::size_t value) {
    const auto word = static_cast<std::uint32_t>(value);
    made.replace(at, 4, std::string(reinterpret_cast<const char*>(&word), 4));
  };
  put(8, made.size());
  put(12, json.size());
  return made;
}

TEST_F(Assemble, LightsOfModelsAreCountedOverTheScene) {
  EXPECT_TRUE(assemble_visual(read(), *load_models(read()), {})->desc.lights.empty());
  const std::string text =
      replaced(kScenario, "models:\n",
               "models:\n  lamps: {file: lamps.glb, role: decor, scale: 2, position: [0, 1, 0]}\n");
  folder_.write("scenarios/peg/lamps.glb", lit_box(5));
  folder_.write("scenarios/peg/peg.glb", lit_box(3));
  const auto scenario = load_scenario_text(text, folder_.peg(), {});
  ASSERT_TRUE(scenario) << to_text(scenario.faults());
  const auto models = load_models(*scenario);
  ASSERT_TRUE(models) << to_text(models.faults());
  EXPECT_EQ(
      to_text(models->lights),
      "scenario.yaml:6:17: model 'lamps': 'lamps.glb' brings 5 lights (KHR_lights_punctual), which throw no "
      "shadows: the scene's 'light' alone does.\n"
      "scenario.yaml:8:15: model 'peg': 'peg.glb' brings 3 lights (KHR_lights_punctual), which throw no "
      "shadows: the scene's 'light' alone does.");
  EXPECT_TRUE(models->warnings.empty()) << to_text(models->warnings);
  const auto visual = assemble_visual(*scenario, *models, {});
  ASSERT_TRUE(visual) << to_text(visual.faults());
  ASSERT_EQ(visual->desc.lights.size(), 8u);
  const render::PunctualLight &standing = visual->desc.lights[0], &carried = visual->desc.lights[7];
  EXPECT_EQ(standing.position, glm::vec3(0, 1, 0));
  EXPECT_NEAR(standing.intensity, 4 / 3.14159265F, 1e-6F) << "683 cd, of a model that is twice as large";
  EXPECT_FALSE(standing.carried_by);
  ASSERT_TRUE(carried.carried_by);
  EXPECT_TRUE(visual->desc.instances[*carried.carried_by].movable);
  EXPECT_NEAR(carried.intensity, 1 / 3.14159265F, 1e-6F);

  folder_.write("scenarios/peg/peg.glb", lit_box(2000));
  const auto refused = load_models(*scenario);
  ASSERT_FALSE(refused);
  EXPECT_EQ(
      to_text(refused.faults()),
      "scenario.yaml:8:15: model 'peg': 'peg.glb' brings 2000 lights (KHR_lights_punctual), with which the "
      "models have 2005: at most 8 are drawn; take some out of the file.");
}

TEST_F(Assemble, AGhostIsThereWhereTheSceneShowsOne) {
  const Scenario scenario = read({"variant=B"});
  const auto models = load_models(scenario);
  ASSERT_TRUE(models) << to_text(models.faults());
  ASSERT_TRUE(scenario.effects.torque_substitution);
  EXPECT_EQ(scenario.effects.torque_substitution->variant, TorqueVariant::B);
  SceneDesc scene;
  EXPECT_TRUE(assemble_visual(scenario, *models, scene)->desc.ghosts.empty());
  scene.torque_substitution = scenario.effects.torque_substitution;
  EXPECT_EQ(assemble_visual(scenario, *models, scene)->desc.ghosts.size(), 1u);  // off, and a key away
  scene.device.senses_rotation = false;
  EXPECT_TRUE(assemble_visual(scenario, *models, scene)->desc.ghosts.empty());
  EXPECT_FALSE(read({}).effects.torque_substitution);
}

// Models are numbered as they stand in the file, those of the scene alone.
TEST_F(Assemble, EachModelOfTheSceneHasItsMaterialAndItsNumber) {
  folder_.write("scenarios/peg/materials/wood.yaml",
                "fulcrum: 1\nname: Wood\nattack: 0.1\ndecay: 9\nfrequency_Hz: 20\n");
  folder_.write("scenarios/peg/post.glb", box_glb({0.05F, 0.0F, 0.05F}, {0.07F, 0.1F, 0.07F}));
  const std::string text = replaced(
      replaced(kScenario, "  peg: {file",
               "  post: {file: post.glb, role: scene, material: wood}\n  peg: {file"),
      "contact:",
      "impact: {retreat: 0.005, least_speed: 0.02}\nimpact_vibration: {distance: beam, gain: 0.5}\ncontact:");
  const auto scenario = load_scenario_text(text, folder_.peg(), kCoarse);
  ASSERT_TRUE(scenario) << to_text(scenario.faults());
  const auto models = load_models(*scenario);
  ASSERT_TRUE(models) << to_text(models.faults());
  const auto haptic = assemble_haptic(*scenario, *models, cache_);
  ASSERT_TRUE(haptic) << haptic.error().sentence;
  const SceneDesc& scene = haptic->scene;
  EXPECT_EQ(scene.impact.retreat, 0.005);
  EXPECT_EQ(scene.impact.least_speed, 0.02);
  ASSERT_TRUE(scene.impact_vibration);
  EXPECT_EQ(scene.impact_vibration->distance, DistanceModel::beam);
  EXPECT_EQ(scene.impact_vibration->gain, 0.5);
  ASSERT_EQ(scene.impact_vibration->materials.size(), 2u);
  EXPECT_EQ(scene.impact_vibration->materials[0].attack, 0.5);
  EXPECT_EQ(scene.impact_vibration->materials[1].name, "Wood");
  EXPECT_EQ(scene.impact_vibration->materials[1].frequency_Hz, 20);
  ASSERT_TRUE(scene.scene_objects);
  EXPECT_EQ(scene.scene_objects->nearest(Vec3(0.06, 0.1, 0.06)), 1);
  EXPECT_EQ(scene.scene_objects->nearest(Vec3(0.05, 0.03, 0.06)), 1);
  EXPECT_EQ(scene.scene_objects->nearest(Vec3(0.03, 0.0, 0.06)), 0);
  EXPECT_EQ(scene.scene_objects->nearest(Vec3(-0.1, -0.01, 0)), 0);
}

TEST_F(Assemble, NobodyAsksForObjectsWhereNoImpactIsTold) {
  const Scenario plain = read(kCoarse);
  EXPECT_TRUE(plain.impact_materials.empty());
  std::vector<std::string> named = kCoarse;
  named.push_back("impact_vibration={}");
  const Scenario one = read(named);
  EXPECT_EQ(one.texts.files.count("materials/steel.yaml"), 1u) << "a tape keeps it";
  const auto models = load_models(one);
  ASSERT_TRUE(models) << to_text(models.faults());
  const auto haptic = assemble_haptic(one, *models, cache_);
  ASSERT_TRUE(haptic) << haptic.error().sentence;
  EXPECT_FALSE(haptic->scene.scene_objects) << "one object needs no telling apart";
}

TEST(Materials, ThoseOfTheContentAreWithinWhatWasTried) {
  int read = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(FULCRUM_SOURCE_DIR) / "content/materials")) {
    if (entry.path().stem() == "enamel") continue;  // only heard: no scene shakes a hand by it
    const Folder folder;
    std::filesystem::copy(entry.path(), folder.peg() / "materials",
                          std::filesystem::copy_options::overwrite_existing);
    const std::string name = entry.path().stem().string();
    const auto scenario = load_scenario_text(
        replaced(kScenario, "contact:", "impact_vibration: {material: " + name + "}\ncontact:"),
        folder.peg());
    ASSERT_TRUE(scenario) << to_text(scenario.faults());
    const ImpactMaterial& material = scenario->impact_materials.at(name);
    EXPECT_GE(material.frequency_Hz, 12) << name;
    EXPECT_LE(material.frequency_Hz, 40) << name;
    EXPECT_GE(material.decay, 5) << name;
    ++read;
  }
  EXPECT_EQ(read, 3);
}

// What is cut open is drawn in the place of what it was cut from, in views that say so, and never touched.
TEST_F(Assemble, DrawsAModelCutOpenWhereAViewSaysSo) {
  const std::string text =
      replaced(replaced(kScenario, "  peg: {file",
                        "  half: {file: peg.glb, role: decor, cut_of: block}\n  peg: {file"),
               "views:", "views:\n  - {name: inside, eye: [0, 0.1, 0.5], target: [0, 0, 0], cut: true}");
  const auto scenario = load_scenario_text(text, folder_.peg(), kCoarse);
  ASSERT_TRUE(scenario) << to_text(scenario.faults());
  const auto models = load_models(*scenario);
  ASSERT_TRUE(models) << to_text(models.faults());
  const auto visual = assemble_visual(*scenario, *models, {});
  ASSERT_TRUE(visual) << to_text(visual.faults());
  const auto seen_in = [&](std::size_t view) {
    std::string seen;
    for (const render::Instance& instance : visual->desc.instances)
      seen += (instance.layers & visual->views[view].camera.layers) != 0 ? instance.name + " " : "";
    return seen;
  };
  EXPECT_EQ(seen_in(0), "half/box peg/box ");
  EXPECT_EQ(seen_in(1), "block/box peg/box ");
  EXPECT_EQ(visual->desc.camera.layers, visual->views[0].camera.layers);
  const auto haptic = assemble_haptic(*scenario, *models, cache_);
  ASSERT_TRUE(haptic) << haptic.error().sentence;
  EXPECT_EQ(haptic->scene_W.mesh.triangles.size(), 12u);  // the block alone
}

TEST_F(Assemble, TellsTheTaskOfHardTouches) {
  const auto models = load_models(read(kCoarse));
  ASSERT_TRUE(models) << to_text(models.faults());
  EXPECT_FALSE(assemble_haptic(read(kCoarse), *models, cache_)->task.hard_touch);
  auto overrides = kCoarse;
  overrides.emplace_back("hard_touch.force=0.25");
  EXPECT_EQ(assemble_haptic(read(overrides), *models, cache_)->task.hard_touch, 0.25);
}

TEST_F(Assemble, NamesThePlaceOfWhatIsWrong) {
  const auto wrong_material = read({}, "materials: {stel: {roughness: 0.25}}\n");
  const auto models = load_models(wrong_material);
  ASSERT_TRUE(models) << to_text(models.faults());
  EXPECT_EQ(to_text(assemble_visual(wrong_material, *models, {}).faults()),
            "scenario.yaml:20:19: no model has a material 'stel'; did you mean 'steel'?");

  const auto missing = load_models(read({"models.peg.file=none.glb"}));
  ASSERT_FALSE(missing);
  EXPECT_TRUE(to_text(missing.faults()).starts_with("--set models.peg.file=none.glb: model 'peg': "))
      << to_text(missing.faults());

  const auto thin = read({"contact.surface=points", "field.voxel=0.02", "field.band=0.06"});
  const auto refused = assemble_haptic(thin, *models, cache_);
  ASSERT_FALSE(refused);
  EXPECT_TRUE(refused.error().sentence.starts_with("the scene's distance field: "))
      << refused.error().sentence;
}

}  // namespace
}  // namespace fulcrum::scenario::test
