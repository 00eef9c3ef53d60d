#pragma once
// A small scenario in a content folder of its own, for the tests of this room.

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scenario/load.h"

namespace fulcrum::scenario::test {

inline constexpr const char* kScenario = R"(fulcrum: 1
title: Peg
about: A peg and a hole.
time_limit: 10
models:
  block: {file: block.glb, role: scene}
  peg: {file: peg.glb, role: tool}
tool:
  start: {position: [0, 0.1, 0]}
contact:
  stiffness: 5000
device:
  model: test_arm
checkpoints:
  - {name: hole, position: [0, 0, 0], radius: 0.005}
hands:
  sure: {path: sure.yaml}
views:
  - {name: front, eye: [0, 0.1, 0.5], target: [0, 0, 0]}
)";

inline constexpr const char* kHandPath = R"(fulcrum: 1
waypoints:
  - {position: [0, 0.1, 0], dwell: 0.5}
  - {position: [0, 0, 0], orientation: [0, 1, 0, 0], travel: 2}
)";

inline constexpr const char* kDevice = "fulcrum: 1\nname: Test arm\nmax_force: 3\n";

inline constexpr const char* kMaterial = "fulcrum: 1\nname: Steel\nattack: 0.5\ndecay: 6\nfrequency_Hz: 35\n";

// ROOT/scenarios/peg with kScenario and its files, removed at the end. ROOT is content as a program may come
// with, too: its devices and materials are the scenario's own.
class Folder {
public:
  Folder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "fulcrum-scenario-XXXXXX").string();
    if (!mkdtemp(pattern.data())) throw std::filesystem::filesystem_error("mkdtemp", {});
    root_ = std::filesystem::canonical(pattern);
    std::filesystem::create_directories(peg());
    std::filesystem::create_directories(peg() / "devices");
    std::filesystem::create_directories(peg() / "materials");
    std::filesystem::create_directories(root_ / "devices");
    write("scenarios/peg/scenario.yaml", kScenario);
    write("scenarios/peg/sure.yaml", kHandPath);
    write("scenarios/peg/devices/test_arm.yaml", kDevice);
    write("scenarios/peg/materials/steel.yaml", kMaterial);
    write("devices/test_arm.yaml", kDevice);
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(root_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  void write(const std::string& name, std::string_view text) const {
    std::ofstream(root_ / name, std::ios::binary) << text;
  }
  const std::filesystem::path& root() const { return root_; }
  std::filesystem::path peg() const { return root_ / "scenarios" / "peg"; }

private:
  std::filesystem::path root_;
};

// $FULCRUM_CONTENT for as long as this lives.
// NOLINTBEGIN(concurrency-mt-unsafe): no thread runs yet.
class Installed {
public:
  explicit Installed(const std::filesystem::path& root) { ::setenv("FULCRUM_CONTENT", root.c_str(), 1); }
  ~Installed() {
    if (before_)
      ::setenv("FULCRUM_CONTENT", before_->c_str(), 1);
    else
      ::unsetenv("FULCRUM_CONTENT");
  }

private:
  std::optional<std::string> before_ = std::getenv("FULCRUM_CONTENT")
                                           ? std::optional<std::string>(std::getenv("FULCRUM_CONTENT"))
                                           : std::nullopt;
};
// NOLINTEND(concurrency-mt-unsafe)

inline std::string replaced(std::string text, std::string_view what, std::string_view by) {
  const std::size_t at = text.find(what);
  if (at == text.npos) return "no such text in the example: " + std::string(what);
  return text.replace(at, what.size(), by);
}

// The faults of a text, a line for each; empty: it was read.
inline std::string faults_of(const Folder& folder, std::string_view text,
                             const std::vector<std::string>& overrides = {}) {
  const auto scenario = load_scenario_text(text, folder.peg(), overrides);
  return scenario ? std::string() : to_text(scenario.faults());
}

}  // namespace fulcrum::scenario::test
