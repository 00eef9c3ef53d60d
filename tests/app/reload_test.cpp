// A scenario that is saved a thousand times, well and badly, while a hand leans on it: what it feels, what is
// said, and what memory there is.

#include "engine/app/edit/reloader.h"
#include "engine/app/edit/scene_editor.h"
#include "engine/app/picture/projection.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <thread>

#include "engine/app/author/first_guess.h"
#include "engine/app/author/first_text.h"
#include "engine/app/author/starter_models.h"
#include "engine/assets/gltf_writer.h"
#include "engine/scenario/content.h"
#include "engine/scenario/load.h"
#include "engine/scenario/to_glm.h"
#include "haptics/loop/run_tick.h"
#include "haptics/safety/output_limit.h"
#include "tests/assets/hdr_of.h"

namespace fulcrum::app {
namespace {

namespace fs = std::filesystem;

// A handle that stays where it is, whatever pushes it; it keeps the largest step of what does.
class StandingHandle : public Device {
public:
  StandingHandle(const DeviceDesc& desc, const Pose& X_DH) : desc_(desc) { sample_.X_DH = X_DH; }
  const DeviceDesc& desc() const override { return desc_; }
  DeviceSample read() noexcept override { return sample_; }
  void write(const DeviceCommand& command) noexcept override {
    largest_step_ = std::max(largest_step_, (command.F_H_D.force - last_).norm());
    last_ = command.F_H_D.force;
    strongest_ = std::max(strongest_, last_.norm());
  }
  void miss(int) noexcept override {}
  double largest_step() const { return largest_step_; }
  double strongest() const { return strongest_; }
  void forget_strongest() { strongest_ = 0; }

private:
  DeviceDesc desc_;
  DeviceSample sample_;
  Vec3 last_ = Vec3::Zero();
  double largest_step_ = 0, strongest_ = 0;
};

class ReloadTest : public testing::Test {
protected:
  ReloadTest() {
    folder_ = fs::temp_directory_path() / ("fulcrum_reload_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
    const auto devices = scenario::device_files(scenario::content_roots());
    const auto device = scenario::load_device(devices.at("phantom_like"));
    const Model board = starter_board(), pin = starter_pin();
    guess_ =
        guess_scenario(*build_solid(to_triangle_mesh(board)), *build_solid(to_triangle_mesh(pin)), *device);
    write("scene.glb", to_glb(board, "board", "test"));
    write("tool.glb", to_glb(pin, "pin", "test"));
    const FirstFiles files{
        "Reloaded",
        {{"scene", "scene.glb", "scene", false, {}}, {"tool", "tool.glb", "tool", false, {}}},
        "phantom_like",
        {}};
    write("expert.yaml", expert_text(files, guess_));
    text_ = scenario_text(files, guess_);
    write("scenario.yaml", text_);
  }
  ~ReloadTest() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
  }

  // The text with something else in it, longer by `longer`.
  std::string with(const std::string& what, const std::string& in_its_place) const {
    std::string text = text_;
    const std::size_t at = text.find(what);
    EXPECT_NE(at, text.npos) << what;
    return text.replace(at, what.size(), in_its_place);
  }

  // Until what was saved has been read, however long that takes.
  static void settle(Reloader& reloader) {
    for (int i = 0; i < 3; ++i) reloader.look();
    while (reloader.message() == "Reading what was saved.") {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      reloader.look();
    }
  }

  void run(int rounds);

  fs::path folder_;
  FirstGuess guess_;
  std::string text_;
};

// The address sanitizer does, for a while; what is lost it tells by itself.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool kKeepsWhatIsFreed = true;
#else
constexpr bool kKeepsWhatIsFreed = false;
#endif
#else
constexpr bool kKeepsWhatIsFreed = false;
#endif

double resident_MB() {
  long pages = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> pages >> resident;
  return static_cast<double>(resident * ::sysconf(_SC_PAGESIZE)) / 1e6;
}

void ReloadTest::run(int rounds) {
  const std::string file = (folder_ / "scenario.yaml").string();
  std::optional<Prepared> first = prepare(file, std::vector<std::string>());
  ASSERT_TRUE(first);
  Reloader reloader(file, first->scenario);
  auto prepared = std::make_unique<Prepared>(std::move(*first));
  // The pin's tip half a millimetre deep in the step: the hand leans on it.
  Pose X_WM = guess_.X_WM_touch;
  X_WM.p.y() -= 0.0005;
  const SceneDesc& scene = prepared->haptic.scene;
  const Pose X_WT = X_WM * Pose{Quat::Identity(), prepared->models.p_MT};
  StandingHandle handle(scene.device, scene.mapping.handle_in_device(X_WT * scene.tool.X_HT.inverse()));
  const double most = SlewSteps(scene.device, scene.tick_s).force;

  const std::string bad[] = {with("time_limit: 60", "time_limit: soon"),
                             with("role: scene", "role: scenery"),
                             with("scene.glb", "none.glb"),
                             text_ + "checkpoints: [\n",
                             text_ + "materials: {gold: {metallic: 1}}\n",
                             text_.substr(0, text_.size() / 2),
                             with("start: {position: [", "start: {position: [.nan, ")};
  double resident = 0;
  for (int round = 0; round < rounds; ++round) {
    Result<World> world = World::build(prepared->haptic.scene);
    ASSERT_TRUE(world);
    handle.forget_strongest();
    TickEvent event;
    for (int tick = 0; tick < 700; ++tick) run_tick(*world, handle, {}, event);
    EXPECT_GT(handle.strongest(), 0.1) << "nothing is felt in round " << round;

    // A bad save: the scene goes on, and it is said what is wrong and where.
    write("scenario.yaml", bad[static_cast<std::size_t>(round) % std::size(bad)]);
    settle(reloader);
    ASSERT_FALSE(reloader.is_ready());
    ASSERT_NE(reloader.message().find("scenario.yaml:"), std::string::npos) << reloader.message();
    for (int tick = 0; tick < 50; ++tick) run_tick(*world, handle, {}, event);

    // A good one takes over once the force has been let go.
    const double friction = 0.1 + 0.001 * (round % 700);
    write("scenario.yaml",
          with("response: constraint", "friction: " + std::to_string(friction) + ", response: constraint") +
              std::string(static_cast<std::size_t>(round) % 7, '\n'));
    settle(reloader);
    ASSERT_TRUE(reloader.is_ready()) << reloader.message();
    ASSERT_EQ(reloader.message(), "");
    const Command release{Command::Kind::release};
    run_tick(*world, handle, {&release, 1}, event);
    for (int tick = 0; tick < 2000 && !(event.record.stopped && event.record.device_F_H_D.is_zero()); ++tick)
      run_tick(*world, handle, {}, event);
    ASSERT_TRUE(event.record.stopped && event.record.device_F_H_D.is_zero());
    const Pose X_MT{Quat::Identity(), prepared->models.p_MT};
    const Pose left = event.record.X_WT * X_MT.inverse();
    prepared = reloader.take();
    ASSERT_NEAR(prepared->haptic.scene.contact.friction, friction, 1e-9);
    ASSERT_TRUE(begin_at(*prepared, left)) << round;
    ASSERT_LT((prepared->haptic.scene.tool.X_WT_start.p - event.record.X_WT.p).norm(), 1e-9);
    ASSERT_LE(handle.largest_step(), most * (1 + 1e-9)) << "N in a tick, in round " << round;
    if (round == rounds / 10) resident = resident_MB();
  }
  // A scene that nobody lets go of is at least a megabyte.
  if (!kKeepsWhatIsFreed) EXPECT_LT(resident_MB() - resident, 0.05 * rounds + 8);
}

TEST_F(ReloadTest, GoodAndBadSavesByTurns) {
  run(20);
}

TEST_F(ReloadTest, AThousandTimesLong) {
  run(1000);
}

// What an author puts goes into the file that is seen, and into no other.
TEST_F(ReloadTest, NothingIsWrittenIntoATextThatIsNotSeen) {
  const fs::path file = folder_ / "scenario.yaml";
  const std::optional<Prepared> prepared = prepare(file.string(), std::vector<std::string>());
  ASSERT_TRUE(prepared);
  const auto text = [&] {
    std::stringstream all;
    all << std::ifstream(file).rdbuf();
    return all.str();
  };
  SceneEditor editor(file, prepared->scenario);
  const SceneEditor::Seen seen{*prepared, prepared->haptic.scene.tool.X_WT_start, {}, {640, 360}};
  const std::string newer = with("checkpoints:  # in this order\n",
                                 "checkpoints:\n  - {name: new, position: [1, 2, 3], radius: 0.01}\n");
  write("scenario.yaml", newer);
  editor.put(seen);
  EXPECT_EQ(text(), newer);
  EXPECT_NE(editor.message(seen).find("saved since"), std::string::npos) << editor.message(seen);

  // By way of a link, and as closed to others as it was; a download beside it is none of ours.
  write("scenario.yaml", text_);
  write("model.glb.part", "half a download");
  fs::rename(file, folder_ / "real.yaml");
  fs::permissions(folder_ / "real.yaml", fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("real.yaml", file);
  editor.put(seen);
  EXPECT_NE(text(), text_);
  EXPECT_TRUE(fs::is_symlink(file));
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_TRUE(fs::exists(folder_ / "model.glb.part"));
  // And once more, on what it has written itself.
  const std::string once = text();
  SceneEditor::Seen moved = seen;
  moved.X_WT.p.x() += 0.02;
  editor.put(moved);
  EXPECT_NE(text(), once);
}

// Each handle is moved in a text that has all kinds of them, and the text read anew: it is where it was put,
// to what the file's digits can say, and the others are where they were.
TEST_F(ReloadTest, AHandleIsWhereItWasDragged) {
  text_ = with("checkpoints:  # in this order\n",
               "avoid:\n  - {name: hot, position: [0.02, 0.03, 0.01], radius: 0.004}\n"
               "checkpoints:\n  - {name: line, position: [0, 0.02, 0], radius: 0.002, follow: "
               "[{corner: [0.02, 0.02, 0]}, {corner: [0.02, 0.02, 0.02]}]}\n");
  text_ = std::regex_replace(text_, std::regex("\nlight:.*"),
                             "\nlight: {kind: spot, position: [0.1, 0.4, 0.1], direction: [0, -1, 0.1]}");
  write("scenario.yaml", text_);
  const fs::path file = folder_ / "scenario.yaml";
  const auto read = [&] { return prepare(file.string(), std::vector<std::string>()); };
  std::optional<Prepared> prepared = read();
  ASSERT_TRUE(prepared);
  Pose X_WT = prepared->haptic.scene.tool.X_WT_start;
  X_WT.p += Vec3(0.01, 0.02, 0.03);
  const std::size_t count = handles_of(*prepared, X_WT).size();
  std::set<Handle::Kind> kinds;
  const render::Extent size{1280, 720};
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<Handle> before = handles_of(*prepared, X_WT);
    kinds.insert(before[i].kind);
    SceneEditor editor(file, prepared->scenario);
    // Seen from a place of its own, so that nothing else lies nearer to the pixel.
    render::Camera camera;
    camera.target = scenario::narrowed(before[i].p_W);
    camera.eye = camera.target + glm::vec3(0.13F, 0.11F, 0.17F);
    const SceneEditor::Seen seen{*prepared, X_WT, camera, size};
    editor.press(seen, 640, 360);
    ASSERT_TRUE(editor.held()) << before[i].name;
    ASSERT_EQ(editor.held()->name, before[i].name);
    editor.drag(seen, 40, -25);
    const Vec3 put = editor.held()->p_W;
    EXPECT_GT((put - before[i].p_W).norm(), 0.001) << before[i].name;
    editor.release(seen);
    EXPECT_NE(editor.message(seen).find("is written"), std::string::npos) << editor.message(seen);
    prepared = read();
    ASSERT_TRUE(prepared) << before[i].name;
    const std::vector<Handle> after = handles_of(*prepared, X_WT);
    ASSERT_EQ(after.size(), count);
    for (std::size_t k = 0; k < count; ++k)
      EXPECT_LT((after[k].p_W - (k == i ? put : before[k].p_W)).norm(), 2e-5) << after[k].name;
  }
  EXPECT_EQ(kinds.size(), 8U) << "each kind is there";
}

// The checkpoint "back" lies on the start, and all three views look at one place: what F8 chose, and the view
// that is seen, are meant. A handle that was chosen stays so when others come before it.
TEST_F(ReloadTest, OfHandlesInOnePlaceTheOneThatIsMeantIsTaken) {
  const fs::path file = folder_ / "scenario.yaml";
  std::optional<Prepared> prepared = prepare(file.string(), std::vector<std::string>());
  ASSERT_TRUE(prepared);
  const Pose X_WT{Quat::Identity(), Vec3(1, 1, 1)};
  render::Camera camera;
  SceneEditor editor(file, prepared->scenario);
  const auto held_at = [&](const Vec3& p_W, std::size_t view) {
    camera.target = scenario::narrowed(p_W);
    camera.eye = camera.target + glm::vec3(0.1F, 0.1F, 0.1F);
    editor.press({*prepared, X_WT, camera, {640, 360}, view}, 320, 180);
    std::string name = editor.held() ? editor.held()->name : "";
    editor.let_go();
    return name;
  };
  const auto named = [&](const std::string& name) {
    for (const Handle& handle : handles_of(*prepared, X_WT))
      if (handle.name == name) return handle.p_W;
    return Vec3(Vec3::Constant(9));
  };
  const Vec3 start = named("start"), target = named("view side: target");
  EXPECT_EQ(held_at(start, 0), "back");
  const auto choose = [&](const std::string& words) {
    const SceneEditor::Seen seen{*prepared, X_WT, camera, {640, 360}};
    for (int i = 0; i < 20; ++i) {
      editor.next_item(seen);
      if (editor.message(seen).find(words) != std::string::npos) return;
    }
    ADD_FAILURE() << "nothing is " << words;
  };
  choose("put the start");
  EXPECT_EQ(held_at(start, 0), "start");
  EXPECT_EQ(held_at(target, 0), "view overview: target");
  EXPECT_EQ(held_at(target, 1), "view side: target");
  choose("put the start");
  prepared->scenario.checkpoints.insert(prepared->scenario.checkpoints.begin(), {.name = "new"});
  EXPECT_EQ(held_at(start, 0), "start");
}

TEST_F(ReloadTest, WhatIsSetFromOutsideIsNotWritten) {
  const fs::path file = folder_ / "scenario.yaml";
  for (const auto& [set, name] : {std::pair("start={position: [0.1, 0.1, 0.1]}", "start"),
                                  {"light.kind=spot", "light"},
                                  {"views.0.eye=[0.3, 0.3, 0.3]", "view overview: eye"}}) {
    const std::optional<Prepared> prepared = prepare(file.string(), std::vector<std::string>{set});
    ASSERT_TRUE(prepared) << set;
    const Pose X_WT{Quat::Identity(), Vec3(1, 1, 1)};
    for (const Handle& handle : handles_of(*prepared, X_WT)) {
      if (handle.name != name) continue;
      SceneEditor editor(file, prepared->scenario);
      render::Camera camera;
      camera.target = scenario::narrowed(handle.p_W);
      camera.eye = camera.target + glm::vec3(0.3F, 0.31F, 0.32F);
      const SceneEditor::Seen seen{*prepared, X_WT, camera, {640, 360}};
      for (int i = 0; i < 20 && !(editor.held() && editor.held()->name == name); ++i) {
        editor.next_item(seen);
        editor.press(seen, 320, 180);
      }
      ASSERT_TRUE(editor.held() && editor.held()->name == name) << name;
      editor.drag(seen, 30, 20);
      editor.release(seen);
      EXPECT_NE(editor.message(seen).find("It is set by --set"), std::string::npos) << editor.message(seen);
    }
  }
}

// Where the picture shows a place, that is what is looked up; its depth is that of a board of 20 mm, seen
// aslant.
TEST_F(ReloadTest, WhatIsLookedUpIsWhatTheRendererShowsThere) {
  const std::optional<Prepared> prepared =
      prepare((folder_ / "scenario.yaml").string(), std::vector<std::string>());
  ASSERT_TRUE(prepared);
  render::Camera camera;
  camera.eye = {0.05F, 0.3F, 0.2F};
  camera.target = {0.05F, 0.0F, 0.04F};
  const render::Extent size{640, 360};
  const Pose X_WT{Quat::Identity(), Vec3(1, 1, 1)};
  const auto middle = pick(*prepared, X_WT, camera, size, 320, 180);
  ASSERT_TRUE(middle);
  EXPECT_LT((middle->p - Vec3(0.05, 0, 0.04)).norm(), 1e-6);
  EXPECT_LT((middle->nhat - Vec3::UnitY()).norm(), 1e-9);
  EXPECT_EQ(middle->part, "scene/board");
  EXPECT_NEAR(middle->depth.value_or(0), 0.02 * 0.34 / 0.3, 1e-6);
  for (const auto& [x, y] : {std::pair(250.0, 150.0), {340.0, 210.0}, {330.0, 100.0}}) {
    const auto picked = pick(*prepared, X_WT, camera, size, x, y);
    ASSERT_TRUE(picked);
    const Projection projection(camera, size);
    const glm::vec2 seen = projection.pixel(projection.clip(picked->p));
    EXPECT_NEAR(seen.x, x, 0.01);
    EXPECT_NEAR(seen.y, y, 0.01);
  }
  EXPECT_FALSE(pick(*prepared, X_WT, camera, size, 320, -5000)) << "the sky";
}

// Whatever a scenario names is watched, wherever it lies; what an editor leaves beside it is not.
TEST_F(ReloadTest, WhatIsNamedIsWatched) {
  fs::create_directories(folder_ / "meshes");
  fs::rename(folder_ / "scene.glb", folder_ / "meshes" / "scene.GLB");
  write("mine.yml", with("scene.glb", "meshes/scene.GLB"));
  const std::string file = (folder_ / "mine.yml").string();
  std::optional<Prepared> prepared = prepare(file, std::vector<std::string>());
  ASSERT_TRUE(prepared);
  Reloader reloader(file, prepared->scenario);
  settle(reloader);
  EXPECT_FALSE(reloader.is_ready());
  write(".mine.yml.swp", "x");
  write("mine.yml~", "x");
  settle(reloader);
  EXPECT_FALSE(reloader.is_ready());
  write("meshes/scene.GLB", "glTF no more");
  settle(reloader);
  EXPECT_NE(reloader.message().find("scene.GLB"), std::string::npos) << reloader.message();
  write("meshes/scene.GLB", to_glb(starter_board(), "board", "test"));
  settle(reloader);
  EXPECT_TRUE(reloader.is_ready());
}

TEST_F(ReloadTest, ThePictureOfItsSurroundingsIsWatched) {
  const auto sky = [](float blue) {
    const auto bytes = fulcrum::test::hdr_of(2, 1, fulcrum::test::HdrRows::flat, [&](auto, auto) {
      return fulcrum::test::Rgb{0.5F, 0.5F, blue};
    });
    return std::string(bytes.begin(), bytes.end());
  };
  fs::create_directories(folder_ / "light");
  write("light/sky.hdr", sky(1));
  write("scenario.yaml",
        with("time_limit: 60", "time_limit: 60\nambient: {kind: picture, file: light/sky.hdr}"));
  const std::string file = (folder_ / "scenario.yaml").string();
  std::optional<Prepared> prepared = prepare(file, std::vector<std::string>());
  ASSERT_TRUE(prepared);
  Reloader reloader(file, prepared->scenario);
  settle(reloader);
  EXPECT_FALSE(reloader.is_ready());
  write("light/sky.hdr", "no picture any more");
  settle(reloader);
  EXPECT_FALSE(reloader.is_ready());
  EXPECT_NE(reloader.message().find("sky.hdr"), std::string::npos) << reloader.message();
  write("light/sky.hdr", sky(2));
  settle(reloader);
  EXPECT_TRUE(reloader.is_ready());
}

// A picture in a folder of its own, which the model's file names and the scenario does not.
TEST_F(ReloadTest, WhatAModelNamesIsWatched) {
  fs::create_directories(folder_ / "textures");
  write("textures/grain.png", "no picture yet");
  write(
      "wall.gltf",
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":)"
      R"([{"attributes":{"POSITION":0},"material":0}]}],"materials":[{"pbrMetallicRoughness":{"baseColorTexture":)"
      R"({"index":0}}}],"textures":[{"source":0}],"images":[{"uri":"textures/grain.png"}],"accessors":[{"bufferView":0,)"
      R"("componentType":5126,"count":3,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":)"
      R"([{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})");
  write("scenario.yaml", with("models:", "models:\n  wall: {file: wall.gltf, role: decor}"));
  const std::string file = (folder_ / "scenario.yaml").string();
  std::optional<Prepared> prepared = prepare(file, std::vector<std::string>());
  ASSERT_TRUE(prepared);
  Reloader reloader(file, prepared->scenario);
  reloader.watch_beside(*prepared);
  settle(reloader);
  EXPECT_FALSE(reloader.is_ready());
  write("textures/grain.png", "another one");
  settle(reloader);
  EXPECT_TRUE(reloader.is_ready());
}

// A save between reading and watching.
TEST_F(ReloadTest, ASaveBeforeItIsWatchedIsNotLost) {
  const std::string file = (folder_ / "scenario.yaml").string();
  std::optional<Prepared> prepared = prepare(file, std::vector<std::string>());
  ASSERT_TRUE(prepared);
  write("scenario.yaml", with("time_limit: 60", "time_limit: 61"));
  Reloader reloader(file, prepared->scenario);
  settle(reloader);
  ASSERT_TRUE(reloader.is_ready());
  EXPECT_EQ(reloader.take()->scenario.time_limit, 61);
}

// What is not free in the new scene is no place to go on.
TEST_F(ReloadTest, AToolThatWouldBeInTheNewSceneBeginsWhereThatSays) {
  std::optional<Prepared> prepared =
      prepare((folder_ / "scenario.yaml").string(), std::vector<std::string>());
  ASSERT_TRUE(prepared);
  const Pose start = prepared->haptic.scene.tool.X_WT_start;
  EXPECT_FALSE(begin_at(*prepared, Pose{Quat::Identity(), Vec3(0, -0.01, 0)}));
  EXPECT_EQ(prepared->haptic.scene.tool.X_WT_start.p, start.p);
  EXPECT_TRUE(begin_at(*prepared, Pose{Quat::Identity(), Vec3(0, 0.1, 0)}));
  EXPECT_LT((prepared->scenario.tool.X_WM_start.p - Vec3(0, 0.1, 0)).norm(), 1e-12);
}

}  // namespace
}  // namespace fulcrum::app
