#pragma once
// A device or a material that a scenario names without folder and end: KIND/NAME.yaml, in the scenario's own
// folder or in the program's content.

#include <filesystem>
#include <string>
#include <vector>

#include "engine/files/regular_file.h"

namespace fulcrum::scenario {

class ContentFile {
public:
  // kind: "devices" or "materials".
  ContentFile(std::filesystem::path scenario_folder, std::string kind, const std::string& name);

  std::string name() const { return kind_ + "/" + file_; }
  bool is_own() const;        // the scenario brings one
  bool is_installed() const;  // the program comes with one
  // The scenario's own where there is one.
  Result<RegularFile> open() const;
  std::vector<std::filesystem::path> folders() const;  // where it is looked for

private:
  // The first folder of the program's content that has it; an empty path where none has.
  std::filesystem::path installed() const;

  std::filesystem::path scenario_folder_;
  std::string kind_;
  std::string file_;
};

}  // namespace fulcrum::scenario
