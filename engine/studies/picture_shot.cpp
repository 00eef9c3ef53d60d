#include "engine/studies/picture_shot.h"

#include <nlohmann/json.hpp>

#include "engine/app/picture/bridge.h"
#include "engine/app/prepare/chosen_view.h"
#include "engine/app/run/run_sink.h"
#include "haptics/loop/run_tick.h"

namespace fulcrum::app {
namespace {

nlohmann::ordered_json json_of(const glm::vec3& v) {
  return {v.x, v.y, v.z};
}

glm::vec3 vec3_of(const nlohmann::ordered_json& json) {
  return {json.at(0).get<float>(), json.at(1).get<float>(), json.at(2).get<float>()};
}

}  // namespace

std::vector<WantedShot> wanted_shots() {
  return {{"tutorial", "overview", "expert", 0}, {"tutorial", "ridges", "expert", 14},
          {"piping", "overview", "expert", 0},   {"piping", "slot", "yielding", 18.4},
          {"teeth", "overview", "expert", 0},    {"teeth", "front", "expert", 5},
          {"ear", "outside", "expert", 0},       {"ear", "cutaway", "expert", 24.5},
          {"plate", "overview", "expert", 0},    {"plate", "faces", "expert", 0.7},
          {"knock", "overview", "expert", 0},    {"knock", "row", "expert", 21.066},
          {"stick", "overview", "expert", 0},    {"stick", "ball", "expert", 9},
          {"sweep", "overview", "expert", 0},    {"sweep", "front", "expert", 1.31},
          {"nut", "overview", "expert", 0},      {"nut", "behind", "expert", 9}};
}

Result<Shot> take_shot(const Prepared& prepared, const WantedShot& wanted) {
  if (const auto refused = refuse_view(prepared.scenario, prepared.name, wanted.view)) return *refused;
  const SceneDesc scene = scene_for_device(prepared, "simulated");
  Result<World> world = World::build(scene);
  if (!world) return world.error();
  const Result<std::unique_ptr<SimulatedDevice>> device = simulated_device(prepared, wanted.hand);
  if (!device) return device.error();
  const Result<scenario::VisualAssembly> visual = assemble_view(prepared, scene, wanted.view);
  if (!visual) return visual.error();
  RunSink sink(prepared, std::nullopt, prepared.scenario.time_limit);
  do {
    TickEvent event;
    run_tick(*world, **device, {}, event);
    sink.take(event);
  } while (sink.time() < wanted.time_s && sink.end() == RunSink::End::running);
  FrameBridge bridge(visual->desc, prepared.scenario, scene);
  const render::FrameState frame =
      bridge.frame(sink.last(), sink.afterglow(), sink.task(), visual->desc.camera, wanted.time_s);
  return Shot{
      wanted.scene, wanted.view, wanted.time_s, visual->desc.camera, {frame.X_WM.begin(), frame.X_WM.end()}};
}

std::string name_of(const WantedShot& shot) {
  return std::string(shot.scene) + "_" + shot.view;
}

nlohmann::ordered_json shot_json(const Shot& shot) {
  nlohmann::ordered_json poses = nlohmann::ordered_json::array();
  for (const glm::mat4& X : shot.X_WM) {
    nlohmann::ordered_json columns = nlohmann::ordered_json::array();
    for (int i = 0; i < 16; ++i) columns.push_back(X[i / 4][i % 4]);
    poses.push_back(columns);
  }
  return {{"scene", shot.scene},
          {"view", shot.view},
          {"time_s", shot.time_s},
          {"camera",
           {{"eye", json_of(shot.camera.eye)},
            {"target", json_of(shot.camera.target)},
            {"vertical_fov_rad", shot.camera.vertical_fov_rad},
            {"layers", shot.camera.layers}}},
          {"X_WM", poses}};
}

Result<Shot> read_shot(const nlohmann::ordered_json& json, const std::filesystem::path& file) {
  try {
    Shot shot;
    shot.scene = json.at("scene").get<std::string>();
    shot.view = json.at("view").get<std::string>();
    shot.time_s = json.at("time_s").get<double>();
    const auto& camera = json.at("camera");
    shot.camera.eye = vec3_of(camera.at("eye"));
    shot.camera.target = vec3_of(camera.at("target"));
    shot.camera.vertical_fov_rad = camera.at("vertical_fov_rad").get<float>();
    shot.camera.layers = camera.at("layers").get<std::uint32_t>();
    for (const auto& columns : json.at("X_WM")) {
      glm::mat4 X(1.0F);
      for (int i = 0; i < 16; ++i) X[i / 4][i % 4] = columns.at(static_cast<std::size_t>(i)).get<float>();
      shot.X_WM.push_back(X);
    }
    return shot;
  } catch (const nlohmann::json::exception&) {
    return Error{file.string() + " is not what tools/references writes; make it anew with that."};
  }
}

}  // namespace fulcrum::app
