#pragma once
// A guessed scenario as its author finds it: files with comments that say what was guessed, and why.

#include <string>
#include <vector>

#include "engine/app/author/first_guess.h"

namespace fulcrum::app {

// A model, its file in the scenario's folder.
struct FirstModel {
  std::string name, file;
  std::string role;
  bool marked = false;   // of the file's objects those alone that are marked so
  std::string material;  // of what is touched; empty: none
};

struct FirstFiles {
  std::string title;
  std::vector<FirstModel> models;
  std::string device;   // a table of content/devices
  std::string schemas;  // the folder where the schemas are that editors read; empty: none was found
};

std::string scenario_text(const FirstFiles& files, const FirstGuess& guess);
std::string expert_text(const FirstFiles& files, const FirstGuess& guess);  // the hand that knows how

// Where the program's own content has its schemas; empty: nowhere.
std::string schema_folder();

// The first line of a file of that kind, "scenario" or "hand", by which an editor completes and explains
// keys.
std::string schema_line(const std::string& schemas, const std::string& kind);

}  // namespace fulcrum::app
