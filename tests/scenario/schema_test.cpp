// The schema and the reader are made of one description; these tests hold them together from outside.

#include "engine/scenario/schema.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "engine/scenario/describe.h"
#include "engine/scenario/key_list.h"
#include "tests/scenario/example.h"

namespace fulcrum::scenario::test {
namespace {

using Json = nlohmann::json;

// Every dotted path that a schema has a property for, "*" for elements.
void collect(const Json& schema, const std::string& path, std::set<std::string>& paths) {
  const std::string prefix = path.empty() ? "" : path + ".";
  if (schema.contains("properties")) {
    for (const auto& [name, property] : schema["properties"].items()) {
      paths.insert(prefix + name);
      collect(property, prefix + name, paths);
    }
  }
  if (schema.contains("items") && schema["items"].contains("properties"))
    collect(schema["items"], prefix + "*", paths);
  if (schema.contains("additionalProperties") && schema["additionalProperties"].is_object())
    collect(schema["additionalProperties"], prefix + "*", paths);
  if (schema.contains("oneOf"))
    for (const Json& form : schema["oneOf"]) collect(form, path, paths);
}

std::set<std::string> paths_of(const std::string& schema_text) {
  std::set<std::string> paths;
  collect(Json::parse(schema_text), "", paths);
  return paths;
}

std::set<std::string> paths_of(const Describe& describe) {
  std::set<std::string> paths;
  for (const KeyEntry& key : list_keys(describe)) paths.insert(key.path());
  return paths;
}

TEST(Schema, ListsEveryKeyAndNoOther) {
  Scenario scenario;
  const auto keys = paths_of([&](KeyVisitor& visitor) { describe_scenario(visitor, scenario); });
  EXPECT_EQ(paths_of(scenario_schema()), keys);
  EXPECT_TRUE(keys.contains("contact.stiffness"));
  EXPECT_TRUE(keys.contains("velocity_estimator.window"));
  EXPECT_TRUE(keys.contains("checkpoints.*.radius"));
  EXPECT_TRUE(keys.contains("light.cone_deg"));

  std::vector<Waypoint> waypoints;
  EXPECT_EQ(paths_of(hand_path_schema()),
            paths_of([&](KeyVisitor& visitor) { describe_hand_path(visitor, waypoints); }));
  DeviceDesc device;
  EXPECT_EQ(paths_of(device_schema()),
            paths_of([&](KeyVisitor& visitor) { describe_device_file(visitor, device); }));
}

std::string overridable(std::string path) {
  const std::size_t star = path.find('*');
  if (star == path.npos) return path;
  const bool is_list = path.starts_with("checkpoints") || path.starts_with("views");
  const std::string name = path.starts_with("models") ? "peg" : path.starts_with("hands") ? "sure" : "steel";
  return path.replace(star, 1, is_list ? "0" : name);
}

// The reader knows every key of the schema: a nonsensical value is refused as a value, never as an unknown
// key; and a key that is not there is unknown.
TEST(Schema, HasOnlyKeysThatTheReaderTakes) {
  const Folder folder;
  const std::string text = std::string(kScenario) + "materials: {steel: {}}\n";
  for (const std::string& path : paths_of(scenario_schema())) {
    const std::string faults = faults_of(folder, text, {overridable(path) + "=[]"});
    EXPECT_EQ(faults.find("unknown key"), std::string::npos) << path << ": " << faults;
    EXPECT_NE(faults, "") << path << " takes an empty list";
  }
  EXPECT_NE(faults_of(folder, text, {"contact.colour=[]"}).find("unknown key"), std::string::npos);
}

TEST(Schema, SaysTypesUnitsRangesAndDefaults) {
  const Json schema = Json::parse(scenario_schema());
  EXPECT_EQ(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
  EXPECT_EQ(schema["additionalProperties"], false);
  const Json stiffness = schema["properties"]["contact"]["properties"]["stiffness"];
  EXPECT_EQ(stiffness["type"], "number");
  EXPECT_EQ(stiffness["exclusiveMinimum"], 0);
  EXPECT_EQ(stiffness["maximum"], 1e7);
  EXPECT_EQ(stiffness["default"], ContactDesc{}.stiffness);
  EXPECT_EQ(stiffness["description"], "N/m; of each contact region");
  EXPECT_FALSE(schema["properties"]["coupling"]["properties"]["stiffness"].contains("default"));
  const Json difficulty = schema["properties"]["difficulty"];
  EXPECT_EQ(difficulty["enum"], Json({"easy", "medium", "hard"}));
  EXPECT_FALSE(difficulty.contains("default"));
  const Json needs = schema["properties"]["checkpoints"]["items"]["properties"]["needs"];
  EXPECT_EQ(needs["enum"], Json({"place", "touch", "stop"}));
  EXPECT_EQ(needs["default"], "place");
  const Json& required = schema["required"];
  EXPECT_NE(std::find(required.begin(), required.end(), "time_limit"), required.end());
  EXPECT_EQ(std::find(required.begin(), required.end(), "seed"), required.end());
  EXPECT_EQ(schema["properties"]["light"]["oneOf"][0]["properties"]["colour"]["default"],
            Json({1, 0.96, 0.9}));
}

// Each key says what it is, so that a completion in an editor is of use.
void expect_described(const Json& schema, const std::string& path) {
  if (schema.contains("properties")) {
    for (const auto& [name, property] : schema["properties"].items()) {
      EXPECT_NE(property.value("description", ""), "") << path << "." << name;
      expect_described(property, std::string(path).append(".").append(name));
    }
  }
}

TEST(Schema, DescribesEveryKey) {
  expect_described(Json::parse(scenario_schema()), "");
  expect_described(Json::parse(device_schema()), "");
  expect_described(Json::parse(material_schema()), "");
  expect_described(Json::parse(calibration_schema()), "");
}

}  // namespace
}  // namespace fulcrum::scenario::test
