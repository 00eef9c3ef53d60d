#include "engine/scenario/load.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/scenario/content.h"
#include "tests/scenario/example.h"

namespace fulcrum::scenario::test {
namespace {

// What a file leaves out is what the descriptions of the haptic core say.
TEST(Load, DefaultsAreThoseOfTheDescs) {
  const Folder folder;
  const auto scenario = load_scenario(folder.peg() / kScenarioFile);
  ASSERT_TRUE(scenario) << to_text(scenario.faults());
  EXPECT_EQ(scenario->title, "Peg");
  EXPECT_EQ(scenario->time_limit, 10);
  EXPECT_EQ(scenario->tick_rate_Hz, 1000);
  EXPECT_EQ(scenario->contact.stiffness, 5000);
  EXPECT_EQ(scenario->contact.dissipation, ContactDesc{}.dissipation);
  EXPECT_FALSE(scenario->coupling.max_force) << "it follows from the device";
  EXPECT_EQ(scenario->velocity_estimator.kind, VelocityEstimatorDesc{}.kind);
  EXPECT_EQ(scenario->velocity_estimator.cutoff_Hz, VelocityEstimatorDesc{}.cutoff_Hz);
  EXPECT_EQ(scenario->field.voxel_m, FieldDesc{}.voxel_m);
  EXPECT_EQ(scenario->shell.spacing_m, PointshellDesc{}.spacing_m);
  EXPECT_EQ(scenario->device.desc.name, "Test arm");
  EXPECT_EQ(scenario->device.desc.max_force, 3);
  EXPECT_EQ(scenario->device.desc.friction, DeviceDesc{}.friction);
  EXPECT_EQ(scenario->device.mapping.clutch_button, -1);
  EXPECT_EQ(scenario->device.mapping.drift, 0);
  EXPECT_FALSE(scenario->effects.workspace_walls);
  EXPECT_EQ(scenario->dwell, 3);
  EXPECT_FALSE(scenario->tool.density);
  EXPECT_FALSE(scenario->tool.mass);
  EXPECT_TRUE(scenario->tool.weight);
  EXPECT_EQ(scenario->tool.X_WM_start.p, Vec3(0, 0.1, 0));
  ASSERT_EQ(scenario->hands.size(), 1u);
  ASSERT_EQ(scenario->hands[0].waypoints.size(), 2u);
  EXPECT_EQ(scenario->hands[0].waypoints[0].dwell, 0.5);
  EXPECT_EQ(scenario->hands[0].waypoints[1].travel, 2);
  EXPECT_EQ(scenario->hands[0].waypoints[1].X_WT.q.x(), 1);
  ASSERT_TRUE(scenario->light);
  EXPECT_EQ(scenario->light->colour, render::KeyLight{}.colour);
  EXPECT_EQ(scenario->ambient.sky, render::Ambient{}.sky);
  EXPECT_EQ(scenario->models[1].role, ModelRole::tool);
  EXPECT_EQ(scenario->models[1].file.path, folder.peg() / "peg.glb");
  EXPECT_EQ(scenario->models[1].file.where.text(), (folder.peg() / kScenarioFile).string() + ":7:15");
}

TEST(Load, ReadsTheEyesOfAView) {
  const Folder folder;
  const auto read = [&](const std::string& stereo) {
    return load_scenario_text(replaced(kScenario, "target: [0, 0, 0]}", "target: [0, 0, 0]" + stereo + "}"),
                              folder.peg());
  };
  const auto plain = read(""), given = read(", stereo: {eye_distance: 0.01, convergence: 0.3}");
  ASSERT_TRUE(plain && given);
  EXPECT_FALSE(plain->views[0].camera.eyes.distance);
  EXPECT_FALSE(plain->views[0].camera.eyes.convergence);
  EXPECT_EQ(given->views[0].camera.eyes.distance, 0.01F);
  EXPECT_EQ(given->views[0].camera.eyes.convergence, 0.3F);
  const auto wrong = read(", stereo: {convergence: 0.0009}");
  ASSERT_FALSE(wrong);
  EXPECT_NE(to_text(wrong.faults()).find("'views.0.stereo.convergence'"), std::string::npos)
      << to_text(wrong.faults());
}

TEST(Load, ReadsWallsAndDriftOfTheDevice) {
  const Folder folder;
  const auto read = [&](const std::string& lines) {
    auto scenario = load_scenario_text(
        replaced(kScenario, "  model: test_arm\n", "  model: test_arm\n" + lines), folder.peg());
    if (!scenario) ADD_FAILURE() << to_text(scenario.faults());
    return scenario ? std::move(*scenario) : Scenario{};
  };
  EXPECT_EQ(read("  drift: 0.05\n").device.mapping.drift, 0.05);
  const Scenario plain = read("  workspace_walls: {}\n");
  ASSERT_TRUE(plain.effects.workspace_walls);
  EXPECT_FALSE(plain.effects.workspace_walls->margin);
  EXPECT_FALSE(plain.effects.workspace_walls->stiffness);
  const Scenario given = read("  workspace_walls: {margin: 0.008, stiffness: 250}\n");
  ASSERT_TRUE(given.effects.workspace_walls);
  EXPECT_EQ(given.effects.workspace_walls->margin, 0.008);
  EXPECT_EQ(given.effects.workspace_walls->stiffness, 250);
}

TEST(Load, ReadsTheOtherForms) {
  const Folder folder;
  const auto read = [&](const std::string& lines) {
    auto scenario = load_scenario_text(std::string(kScenario) + lines, folder.peg());
    if (!scenario) ADD_FAILURE() << to_text(scenario.faults());
    return scenario ? std::move(*scenario) : Scenario{};
  };
  EXPECT_FALSE(read("light: none\n").light);
  const auto spot = read("light: {kind: spot, position: [0, 1, 0], cone_deg: 90}\n").light;
  ASSERT_TRUE(spot);
  EXPECT_EQ(spot->kind, render::KeyLight::Kind::spot);
  EXPECT_EQ(spot->position, glm::vec3(0, 1, 0));
  EXPECT_FLOAT_EQ(spot->cone_rad, 1.5707964F);
  EXPECT_EQ(spot->intensity, render::KeyLight{}.intensity);
  EXPECT_EQ(read("velocity_estimator: difference\n").velocity_estimator.kind,
            VelocityEstimatorKind::difference);
  // sRGB half is linear 0.214; a list is linear already.
  const auto coloured = read("background: {top: \"#808080\", bottom: [0.5, 0, 1]}\n").background;
  EXPECT_NEAR(coloured.top.x, 0.21586F, 1e-5F);
  EXPECT_EQ(coloured.bottom, glm::vec3(0.5F, 0.0F, 1.0F));
  const auto material = read("materials: {bare steel: {roughness: 0.25}}\n").materials.at(0);
  EXPECT_EQ(material.name, "bare steel");
  EXPECT_EQ(material.roughness, 0.25);
  EXPECT_FALSE(material.metallic);
}

// Presence is construction: a hand that does not say so does not yield.
TEST(Load, HandsYieldWhereTheySaySo) {
  const Folder folder;
  const auto yields = [&](const std::string& hand, const std::vector<std::string>& overrides) {
    const auto scenario =
        load_scenario_text(replaced(kScenario, "{path: sure.yaml}", hand), folder.peg(), overrides);
    if (!scenario) ADD_FAILURE() << to_text(scenario.faults());
    return scenario ? scenario->hands.at(0).desc.yields : std::nullopt;
  };
  EXPECT_FALSE(yields("{path: sure.yaml}", {}));
  const auto defaults = yields("{path: sure.yaml, yields: {}}", {});
  ASSERT_TRUE(defaults);
  EXPECT_EQ(defaults->reaction, YieldingDesc{}.reaction);
  EXPECT_EQ(defaults->recovery, YieldingDesc{}.recovery);
  const auto given = yields("{path: sure.yaml, yields: {reaction: 0.4}}", {"hands.sure.yields.gain=2"});
  ASSERT_TRUE(given);
  EXPECT_EQ(given->reaction, 0.4);
  EXPECT_EQ(given->gain, 2);
}

TEST(Load, MakesNearlyUnitRotationsUnit) {
  const Folder folder;
  const auto scenario = load_scenario_text(
      replaced(kScenario, "position: [0, 0.1, 0]", "orientation: [0.7072, 0.7072, 0, 0]"), folder.peg());
  ASSERT_TRUE(scenario) << to_text(scenario.faults());
  EXPECT_NEAR(scenario->tool.X_WM_start.q.w(), std::sqrt(0.5), 1e-15);
}

// A tape keeps the texts; what it builds is what was built, though the files have changed or gone.
TEST(Load, RepeatsFromTheTextsItKept) {
  const Folder folder;
  const std::vector<std::string> overrides{"seed=5"};
  const auto first = load_scenario(folder.peg() / kScenarioFile, overrides);
  ASSERT_TRUE(first) << to_text(first.faults());
  EXPECT_EQ(first->texts.scenario, "scenario.yaml");
  ASSERT_EQ(first->texts.files.size(), 3u);
  EXPECT_EQ(first->texts.files.at("scenario.yaml"), kScenario);
  EXPECT_EQ(first->texts.files.at("sure.yaml"), kHandPath);
  EXPECT_EQ(first->texts.files.at("scenario:devices/test_arm.yaml"), kDevice);

  folder.write("scenarios/peg/sure.yaml", "broken");
  folder.write("scenarios/peg/devices/test_arm.yaml", "broken");
  const auto again = load_scenario_texts(first->texts, folder.peg(), overrides);
  ASSERT_TRUE(again) << to_text(again.faults());
  EXPECT_EQ(again->seed, 5);
  EXPECT_EQ(again->device.desc.max_force, 3);
  EXPECT_TRUE(again->device.own);
  EXPECT_EQ(again->hands[0].waypoints.size(), 2u);
  EXPECT_EQ(again->texts.files, first->texts.files);

  SourceTexts incomplete = first->texts;
  incomplete.files.erase("sure.yaml");
  const auto refused = load_scenario_texts(incomplete, folder.peg(), overrides);
  ASSERT_FALSE(refused);
  EXPECT_EQ(to_text(refused.faults()),
            "scenario.yaml:17:16: cannot read 'sure.yaml': the texts at hand do not include it");
}

// A small scenario may name a large file many times, and each time it is read and kept.
TEST(Load, BoundsTheFilesThatAScenarioNames) {
  const Folder folder;
  folder.write("scenarios/peg/sure.yaml", std::string(kHandPath) + "#" + std::string(1'000'000, ' '));
  std::string four = kScenario;
  for (const char* name : {"second", "third", "fourth"})
    four = replaced(four, "hands:\n", "hands:\n  " + std::string(name) + ": {path: sure.yaml}\n");
  EXPECT_EQ(faults_of(folder, four), "");

  const std::string five = replaced(four, "hands:\n", "hands:\n  fifth: {path: sure.yaml}\n");
  const std::string sentence = "the files that the scenario names have more than 4 MiB of text with it";
  EXPECT_EQ(faults_of(folder, five),
            "scenario.yaml:21:16: cannot read 'sure.yaml': " + sentence +
                "\nscenario.yaml:13:10: cannot read 'devices/test_arm.yaml': " + sentence);
}

TEST(Load, DoesNotOfferAFileThatIsThereInsteadOfItself) {
  const Folder folder;
  ASSERT_EQ(::mkfifo((folder.peg() / "pipe.yaml").c_str(), 0600), 0);
  EXPECT_EQ(faults_of(folder, replaced(kScenario, "path: sure.yaml", "path: pipe.yaml")),
            "scenario.yaml:17:16: cannot read 'pipe.yaml': it is a pipe, not a file");
}

TEST(Load, OfWhatIsNoFile) {
  const Folder folder;
  const auto missing = load_scenario(folder.peg() / "none.yaml");
  ASSERT_FALSE(missing);
  EXPECT_EQ(to_text(missing.faults()),
            (folder.peg() / "none.yaml").string() + ": cannot read the scenario: No such file or directory");
  const auto directory = load_scenario(folder.peg());
  ASSERT_FALSE(directory);
  EXPECT_NE(to_text(directory.faults()).find("it is a folder"), std::string::npos);
}

TEST(Content, IsFoundByNameOrPath) {
  const Folder folder;
  const std::vector<std::filesystem::path> roots{folder.root()};
  const auto file = folder.peg() / kScenarioFile;
  EXPECT_EQ(*find_scenario("peg", roots), file);
  EXPECT_EQ(*find_scenario(file.string(), roots), file);
  EXPECT_EQ(*find_scenario(folder.peg().string(), roots), file);
  EXPECT_EQ(find_scenario("pge", roots).error().sentence,
            "there is no scenario 'pge'; did you mean 'peg'? `fulcrum list` shows them all");
  EXPECT_EQ(find_scenario("x/y.yaml", roots).error().sentence,
            "there is no scenario file 'x/y.yaml'; `fulcrum list` shows the ones that have a name");
  EXPECT_NE(find_scenario("peg", {}).error().sentence.find("FULCRUM_CONTENT"), std::string::npos);
}

TEST(Content, IsListedWithWhatIsWrongWithIt) {
  const Folder folder;
  std::filesystem::create_directories(folder.root() / "scenarios" / "broken");
  std::filesystem::create_directories(folder.root() / "scenarios" / "empty");
  folder.write("scenarios/broken/scenario.yaml", "fulcrum: 3\n");
  const auto listings = list_scenarios({folder.root()});
  ASSERT_EQ(listings.size(), 2u);
  EXPECT_EQ(listings[0].name, "broken");
  EXPECT_NE(listings[0].fault.find("format 3"), std::string::npos);
  EXPECT_EQ(listings[1].name, "peg");
  EXPECT_EQ(listings[1].title, "Peg");
  EXPECT_EQ(listings[1].about, "A peg and a hole.");
  EXPECT_EQ(listings[1].fault, "");
}

TEST(Content, IsListedWithTheTutorialFirst) {
  const Folder folder;
  std::filesystem::copy(folder.peg(), folder.root() / "scenarios" / "tutorial",
                        std::filesystem::copy_options::recursive);
  folder.write("scenarios/tutorial/scenario.yaml", std::string(kScenario) + "difficulty: easy\n");
  std::filesystem::copy(folder.peg(), folder.root() / "scenarios" / "zebra",
                        std::filesystem::copy_options::recursive);
  const auto listings = list_scenarios({folder.root()});
  ASSERT_EQ(listings.size(), 3u);
  EXPECT_EQ(listings[0].name, "tutorial");
  EXPECT_EQ(listings[0].difficulty, Difficulty::easy);
  EXPECT_EQ(listings[0].checkpoints, 1u);
  EXPECT_EQ(listings[0].time_limit, 10);
  EXPECT_EQ(listings[1].name, "peg");
  EXPECT_FALSE(listings[1].difficulty);
  EXPECT_EQ(listings[2].name, "zebra");
}

// Who is new is told how hard each is, and what to do.
TEST(Content, ThatComesWithTheProgramSaysHowHardItIsAndWhatToDo) {
  const std::filesystem::path root = std::filesystem::path(FULCRUM_SOURCE_DIR) / "content";
  const Installed content(root);
  const auto listings = list_scenarios({root});
  ASSERT_FALSE(listings.empty());
  EXPECT_EQ(listings.front().name, kTutorial);
  for (const auto& listing : listings) {
    EXPECT_TRUE(listing.difficulty) << listing.name;
    const auto scenario = load_scenario(listing.file);
    ASSERT_TRUE(scenario) << listing.name;
    for (const Checkpoint& checkpoint : scenario->checkpoints)
      EXPECT_NE(checkpoint.hint, "") << listing.name << ": " << checkpoint.name;
  }
}

TEST(Content, ThatComesWithTheProgramReads) {
  const std::filesystem::path root = std::filesystem::path(FULCRUM_SOURCE_DIR) / "content";
  const Installed content(root);
  for (const auto& listing : list_scenarios({root})) EXPECT_EQ(listing.fault, "") << listing.name;
  const auto piping = load_scenario(root / "scenarios" / "piping" / kScenarioFile);
  ASSERT_TRUE(piping) << to_text(piping.faults());
  EXPECT_GE(piping->checkpoints.size(), 4u);
  EXPECT_EQ(piping->views.size(), 4u);
  ASSERT_GE(piping->hands.size(), 2u);
  for (const HandEntry& hand : piping->hands) {
    const Pose& first = hand.waypoints.front().X_WT;
    EXPECT_LT((first.p - piping->tool.X_WM_start.p).norm(), 1e-6)
        << hand.name << " does not begin at the start pose";
    EXPECT_LT(first.q.angularDistance(piping->tool.X_WM_start.q), 1e-5) << hand.name;
    EXPECT_LT(HandPath(hand.waypoints).duration(), piping->time_limit) << hand.name;
  }
  // The expert's hand itself brings the touch point to every checkpoint, in order and for the dwell time.
  const auto expert = std::find_if(piping->hands.begin(), piping->hands.end(),
                                   [](const HandEntry& hand) { return hand.name == "expert"; });
  ASSERT_NE(expert, piping->hands.end());
  const HandPath path(expert->waypoints);
  std::size_t next = 0;
  double inside = 0;
  for (double t = 0; t < path.duration() && next < piping->checkpoints.size(); t += 0.01) {
    const Checkpoint& checkpoint = piping->checkpoints[next];
    const bool is_inside =
        (path.at(t) * piping->tool.touch_point - checkpoint.position).norm() < checkpoint.radius;
    inside = is_inside ? inside + 0.01 : 0;
    if (inside > piping->dwell) {
      ++next;
      inside = 0;
    }
  }
  EXPECT_EQ(next, piping->checkpoints.size());
}

TEST(Devices, AreFilesOfTheirOwn) {
  const Folder first, second;
  second.write("devices/other.yaml", "fulcrum: 1\nname: Other\n");
  second.write("devices/notes.txt", "");
  const auto files = device_files({first.root(), second.root(), "/nowhere"});
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files.at("test_arm"), first.root() / "devices" / "test_arm.yaml");
  const auto device = load_device(files.at("test_arm"));
  ASSERT_TRUE(device) << to_text(device.faults());
  EXPECT_EQ(device->name, "Test arm");
  EXPECT_EQ(device->max_force, 3);
  EXPECT_EQ(device->handle_mass, DeviceDesc{}.handle_mass);
}

TEST(Devices, OfAScenarioDoNotReplaceInstalledOnes) {
  const Folder folder, installed;
  const Installed content(installed.root());
  const auto refused = load_scenario_text(kScenario, folder.peg());
  ASSERT_FALSE(refused);
  EXPECT_EQ(
      to_text(refused.faults()),
      "scenario.yaml:13:10: 'test_arm' is an installed device, and the scenario's folder has a "
      "'devices/test_arm.yaml' too: a scenario cannot change an installed device's figures; give its own "
      "device another name");
  folder.write("scenarios/peg/devices/my_arm.yaml", "fulcrum: 1\nname: My arm\nmax_force: 1000\n");
  const auto own = load_scenario_text(replaced(kScenario, "test_arm", "my_arm"), folder.peg());
  ASSERT_TRUE(own) << to_text(own.faults());
  EXPECT_TRUE(own->device.own);
  EXPECT_EQ(own->device.desc.max_force, 1000);

  std::filesystem::remove(folder.peg() / "devices" / "test_arm.yaml");
  folder.write("devices/test_arm.yaml", "fulcrum: 1\nname: Beside\nmax_force: 1000\n");  // outside its folder
  const auto real = load_scenario_text(kScenario, folder.peg());
  ASSERT_TRUE(real) << to_text(real.faults());
  EXPECT_FALSE(real->device.own);
  EXPECT_EQ(real->device.desc.max_force, 3);
  EXPECT_TRUE(real->texts.files.contains("devices/test_arm.yaml"));
}

TEST(Devices, BesideBringTheirChannelsOrTheirStrip) {
  const Folder folder, installed;
  const Installed content(installed.root());
  std::filesystem::remove(folder.peg() / "devices" / "test_arm.yaml");
  const std::string motor = ": {kind: tone, largest: 10}\n";
  installed.write("devices/test_pad.yaml",
                  "fulcrum: 1\nname: Pad\nchannels:\n  left" + motor + "  right" + motor);
  installed.write("devices/test_strip.yaml",
                  "fulcrum: 1\nname: Strip\nstrip: {low_place: 0.02, high_place: 0.1}\n");
  installed.write("devices/test_cap.yaml", "fulcrum: 1\nname: Cap\n");
  const auto beside = [&](const std::string& name) {
    return load_scenario_text(replaced(kScenario, "test_arm", "test_arm\n  beside: " + name), folder.peg());
  };
  const auto pad = beside("test_pad");
  ASSERT_TRUE(pad) << to_text(pad.faults());
  EXPECT_EQ(pad->device.desc.name, "Test arm");
  ASSERT_TRUE(pad->device.desc.vibrotactile);
  EXPECT_EQ(pad->device.desc.vibrotactile->channels[1].kind, ChannelKind::tone);
  EXPECT_FALSE(pad->device.desc.strip);
  const auto strip = beside("test_strip");
  ASSERT_TRUE(strip) << to_text(strip.faults());
  EXPECT_EQ(strip->device.desc.name, "Test arm");
  EXPECT_FALSE(strip->device.desc.vibrotactile);
  ASSERT_TRUE(strip->device.desc.strip);
  EXPECT_EQ(strip->device.desc.strip->high_place, 0.1);
  const auto cap = beside("test_cap");
  ASSERT_FALSE(cap);
  EXPECT_NE(to_text(cap.faults()).find("neither channels nor a strip"), std::string::npos)
      << to_text(cap.faults());
}

// Neither a file nor a folder of them may be a link to elsewhere: what is read is quoted in sentences.
TEST(Devices, OfAScenarioLieInItsFolder) {
  const Folder folder, elsewhere;
  const auto fault = [&](const std::string& text) {
    const auto scenario = load_scenario_text(text, folder.peg());
    return scenario ? "" : to_text(scenario.faults());
  };
  elsewhere.write("secret.yaml", "password: 1234\n");
  std::filesystem::create_symlink(elsewhere.root() / "secret.yaml", folder.peg() / "devices" / "linked.yaml");
  const std::string outside = "leads out of the folder " + folder.peg().string() + "; copy the file there";
  const std::string linked = fault(replaced(kScenario, "test_arm", "linked"));
  EXPECT_NE(linked.find("cannot read 'devices/linked.yaml': it " + outside), std::string::npos) << linked;
  ASSERT_EQ(::mkfifo((folder.peg() / "devices" / "pipe.yaml").c_str(), 0600), 0);
  const std::string pipe = fault(replaced(kScenario, "test_arm", "pipe"));
  EXPECT_NE(pipe.find("cannot read 'devices/pipe.yaml': it is a pipe, not a file"), std::string::npos)
      << pipe;

  std::filesystem::remove_all(folder.peg() / "devices");
  std::filesystem::create_symlink(elsewhere.root(), folder.peg() / "devices");
  const std::string through = fault(replaced(kScenario, "test_arm", "secret"));
  EXPECT_NE(through.find(outside), std::string::npos) << through;
  const std::string near = fault(replaced(kScenario, "test_arm", "secre"));
  EXPECT_EQ(near.find("secret"), std::string::npos) << near;

  std::filesystem::remove(folder.peg() / kScenarioFile);
  std::filesystem::create_symlink(elsewhere.root() / "secret.yaml", folder.peg() / kScenarioFile);
  const auto scenario = load_scenario(folder.peg() / kScenarioFile);
  ASSERT_FALSE(scenario);
  EXPECT_NE(to_text(scenario.faults()).find("cannot read the scenario: it " + outside), std::string::npos);
}

TEST(Devices, SayWhatIsWrong) {
  const Folder folder;
  folder.write("devices/test_arm.yaml", "fulcrum: 1\nname: Test arm\nhandle_mass: -1\n");
  const auto device = load_device(folder.root() / "devices" / "test_arm.yaml");
  ASSERT_FALSE(device);
  EXPECT_NE(to_text(device.faults()).find("test_arm.yaml:3:"), std::string::npos) << to_text(device.faults());
  EXPECT_FALSE(load_device(folder.root() / "devices" / "nothing.yaml"));
}

TEST(Devices, SayWhatTheirVibratorsLack) {
  const Folder folder;
  const auto said = [&](const std::string& left) {
    folder.write("devices/test_arm.yaml", "fulcrum: 1\nname: Arm\nchannels:\n  left: {" + left + "}\n");
    const auto device = load_device(folder.root() / "devices" / "test_arm.yaml");
    return device ? "nothing" : to_text(device.faults());
  };
  const std::string coil = said("kind: pcm, largest: 10, resonance_Hz: 233");
  EXPECT_NE(coil.find("test_arm.yaml:4:"), std::string::npos) << coil;
  EXPECT_NE(coil.find("must be above 0.5 for the kind pcm"), std::string::npos) << coil;
  const std::string alone = said("kind: rumble, largest: 10");
  EXPECT_NE(alone.find("must have 'left' and 'right', and two more at most"), std::string::npos) << alone;
}

// They become columns and files.
TEST(Devices, SayWhichNamesVibratorsCannotHave) {
  const Folder folder;
  const auto said = [&](const std::string& name) {
    const std::string motor = ": {kind: rumble, largest: 10}\n";
    folder.write("devices/test_arm.yaml", "fulcrum: 1\nname: Arm\nchannels:\n  left" + motor + "  right" +
                                              motor + "  " + name + motor);
    const auto device = load_device(folder.root() / "devices" / "test_arm.yaml");
    return device ? "nothing" : to_text(device.faults());
  };
  EXPECT_EQ(said("thumb_2"), "nothing");
  for (const char* name : {"'../thumb'", "'a,b'", "'a b'", "''"})
    EXPECT_NE(said(name).find("letters, digits, '_' and '-'"), std::string::npos) << name << said(name);
}

}  // namespace
}  // namespace fulcrum::scenario::test
