// dictionary scenario|device|material|calibration|hand|override: the words that such a fuzzer puts into its
// inputs, in libFuzzer's form. They are every key of the files and every value that has a name, as the schema
// has them; for overrides every key with its path.

#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "engine/scenario/describe.h"
#include "engine/scenario/key_list.h"
#include "engine/scenario/schema.h"

namespace {

using namespace fulcrum::scenario;
using Words = std::set<std::string>;

void collect(const nlohmann::json& schema, Words& words) {
  if (!schema.is_structured()) return;
  for (const auto& [name, part] : schema.items()) {
    if (name == "properties")
      for (const auto& property : part.items()) words.insert(property.key());
    if (name == "enum")
      for (const auto& value : part) words.insert(value.get<std::string>());
    collect(part, words);
  }
}

Words words_of(const std::string& schema) {
  Words words;
  collect(nlohmann::json::parse(schema), words);
  return words;
}

// The first element of every list, and the names of the scenario that is overridden.
Words options() {
  Scenario scenario;
  Words options;
  for (KeyEntry& key : list_keys([&](KeyVisitor& visitor) { describe_scenario(visitor, scenario); })) {
    for (std::string& part : key.parts)
      if (part == "*")
        part = key.parts.front() == "models" ? "peg" : key.parts.front() == "hands" ? "sure" : "0";
    options.insert(key.path() + "=");
  }
  return options;
}

}  // namespace

int main(int count, char** arguments) {
  const std::string kind = count == 2 ? arguments[1] : "";
  const Words words = kind == "scenario"      ? words_of(scenario_schema())
                      : kind == "device"      ? words_of(device_schema())
                      : kind == "material"    ? words_of(material_schema())
                      : kind == "calibration" ? words_of(calibration_schema())
                      : kind == "hand"        ? words_of(hand_path_schema())
                      : kind == "override"    ? options()
                                              : Words();
  for (const std::string& word : words) std::printf("\"%s\"\n", word.c_str());
  return words.empty() ? 1 : 0;
}
