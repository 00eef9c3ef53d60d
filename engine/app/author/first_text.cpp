#include "engine/app/author/first_text.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "engine/scenario/content.h"

namespace fulcrum::app {
namespace {

// m, to a hundredth of a millimetre; no minus before nothing.
std::string number(double value, int decimals = 5) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  std::string shown = text;
  while (decimals > 0 && shown.back() == '0') shown.pop_back();
  if (shown.back() == '.') shown.pop_back();
  return shown == "-0" ? "0" : shown;
}

std::string vector(const Vec3& v) {
  return "[" + number(v.x()) + ", " + number(v.y()) + ", " + number(v.z()) + "]";
}

std::string pose(const Pose& X) {
  return "position: " + vector(X.p) + ", orientation: [" + number(X.q.w(), 6) + ", " + number(X.q.x(), 6) +
         ", " + number(X.q.y(), 6) + ", " + number(X.q.z(), 6) + "]";
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

std::string millimetres(double metres) {
  return number(1e3 * metres, 0) + " mm";
}

std::string view(const char* name, const FirstGuess& guess, const Vec3& direction) {
  const Vec3 eye = guess.look_at + guess.look_from * direction.normalized();
  return std::string("  - {name: ") + name + ", eye: " + vector(eye) + ", target: " + vector(guess.look_at) +
         ", fov_deg: 40}\n";
}

std::string device_block(const FirstFiles& files, const FirstGuess& guess) {
  return "device:\n  model: " + files.device +
         "  # `fulcrum list` and content/devices have others; --device takes what is in your hand\n"
         "  position_scale: " +
         number(guess.position_scale) +
         "  # guessed: the scene, or 0.6 m of it, in 0.7 of the device's workspace\n  force_scale: " +
         number(guess.force_scale) +
         "     # as much smaller, so that a wall is as stiff as the device can hold it\n  base: {position: " +
         vector(guess.base) + "}  # guessed: the middle of the way below\n\n";
}

std::string models_block(const std::vector<FirstModel>& models) {
  std::string block;
  for (const FirstModel& model : models) {
    block += "  " + model.name + ": {file: " + quoted(model.file) + ", role: " + model.role +
             (model.marked ? ", marked: true" : "") +
             (model.material.empty() ? "" : ", material: " + model.material) + "}";
    if (&model == &models.front())
      block += model.marked ? "  # those of its objects that are marked so"
                            : "  # of a file in millimetres: unit: mm";
    block += '\n';
  }
  return block;
}

std::string tool_block(const FirstGuess& guess) {
  const std::string mass =
      guess.density > 0
          ? "  density: " + number(guess.density) + "  # kg/m^3, steel; or `mass` in kg\n"
          : "  mass: " + number(guess.mass) +
                "  # kg, guessed: of steel it would be no tool for fingers; or `density` in kg/m^3\n";
  return "tool:\n" + mass + "  weight: false  # the hand does not carry it; true: it does\n  touch_point: " +
         vector(guess.touch_point) +
         "  # of its model: guessed, the middle of its slimmer end\n  touch_name: the tool's tip\n"
         "  grasp: {position: " +
         vector(guess.X_HM.p) + "}  # guessed: held a third of its " + millimetres(guess.length) +
         " from the other end\n  start: {" + pose(guess.X_WM_start) + "}" +
         (guess.is_clear ? "\n\n" : "  # no way without a touch was found: move it\n\n");
}

}  // namespace

std::string schema_folder() {
  for (const std::filesystem::path& root : scenario::content_roots()) {
    std::error_code ignored;
    const std::filesystem::path folder = std::filesystem::absolute(root / "schema", ignored);
    if (std::filesystem::is_directory(folder, ignored)) return folder.string();
  }
  return {};
}

std::string schema_line(const std::string& schemas, const std::string& kind) {
  return schemas.empty() ? "" : "# yaml-language-server: $schema=" + schemas + "/" + kind + ".json\n";
}

std::string scenario_text(const FirstFiles& files, const FirstGuess& guess) {
  return schema_line(files.schemas, "scenario") +
         "fulcrum: 1\n"
         "title: " +
         quoted(files.title) +
         "\n"
         "about: Touch it with the tip, and lift the tip off again.  # what has to be done, in one line\n"
         "time_limit: 60  # s\n\n"
         "# Lengths are metres; y is up, z comes towards the trainee. `fulcrum check` says what is wrong or "
         "may not feel\n"
         "# right, `fulcrum explain` what is built, `fulcrum schema` every key there is.\n"
         "models:\n" +
         models_block(files.models) + "\n" + tool_block(guess) +
         "# Triangles are felt as they are; what else there is: content/scenarios, and docs.\n"
         "contact: {response: constraint, surface: triangles}\n\n" +
         device_block(files, guess) +
         "dwell: 0.3  # s, how long to stay at a checkpoint\n"
         "checkpoints:  # in this order\n"
         "  - {name: touch, position: " +
         vector(guess.place) + ", radius: " + number(guess.radius) +
         ",\n"
         "     needs: touch, hint: \"Bring the tip to the surface and touch it: {move}.\"}\n"
         "  - {name: back, position: " +
         vector(guess.X_WM_start * guess.touch_point) + ", radius: " + number(2 * guess.radius) +
         ",\n"
         "     hint: \"Lift the tip off, back to where it began.\"}\n\n"
         "hands:\n"
         "  expert: {path: expert.yaml}  # carries the task out: fulcrum run HERE --headless --hand "
         "expert\n\n"
         "views:  # keys 1 to 3; the first is where a window starts\n" +
         view("overview", guess, Vec3(0.55, 0.55, 1)) + view("side", guess, Vec3(1, 0.15, 0.1)) +
         view("top", guess, Vec3(0, 1, 0.02)) +
         "\nlight: {kind: directional, direction: [-0.5, -1, -0.6], intensity: 2.5, shadow: true}\n";
}

std::string expert_text(const FirstFiles& files, const FirstGuess& guess) {
  Pose pressed = guess.X_WM_touch;
  pressed.p += (pressed.q * guess.axis) * std::min(0.002, 0.5 * guess.radius);
  return schema_line(files.schemas, "hand") +
         "fulcrum: 1\n"
         "# Where the hand wants the tool's model, and how many seconds the way there takes.\n"
         "waypoints:\n"
         "  - {" +
         pose(guess.X_WM_start) +
         ", dwell: 0.5}\n"
         "  - {" +
         pose(guess.X_WM_touch) +
         ", travel: 1.5}\n"
         "  - {" +
         pose(pressed) +
         ", travel: 0.4, dwell: 1.2}  # pressed\n"
         "  - {" +
         pose(guess.X_WM_start) + ", travel: 1.2, dwell: 1.5}\n";
}

}  // namespace fulcrum::app
