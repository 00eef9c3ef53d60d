#pragma once
// A moment of a shipped scene from one of its views, whole enough to be drawn again whatever the hands of
// later versions do: camera and poses are kept beside the reference.

#include <filesystem>
#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "engine/app/prepare/prepare.h"
#include "engine/render/visual_desc.h"

namespace fulcrum::app {

struct Shot {
  std::string scene, view;
  double time_s = 0;  // of the scenario's hand
  render::Camera camera;
  std::vector<glm::mat4> X_WM;  // of the movable instances, in their order
};

struct WantedShot {
  const char* scene;
  const char* view;
  const char* hand;
  double time_s;
};

// Two of each shipped scene: as it begins, and where more is seen.
std::vector<WantedShot> wanted_shots();

// Lets the hand go on until then. Fails where the scene has no such hand or view.
Result<Shot> take_shot(const Prepared& prepared, const WantedShot& wanted);

// scene_view, for files.
std::string name_of(const WantedShot& shot);

nlohmann::ordered_json shot_json(const Shot& shot);
Result<Shot> read_shot(const nlohmann::ordered_json& json, const std::filesystem::path& file);

}  // namespace fulcrum::app
