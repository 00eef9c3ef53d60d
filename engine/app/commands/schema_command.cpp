#include <cstdio>
#include <memory>
#include <string>

#include "engine/app/cli/exit_code.h"
#include "engine/app/commands/commands.h"
#include "engine/scenario/key_page.h"
#include "engine/scenario/schema.h"

namespace fulcrum::app {
namespace {

int schema_command(const std::string& of) {
  if (of == "page") {
    std::printf("%s", scenario::key_page().c_str());
    return kCompleted;
  }
  const std::string schema = of == "hand"          ? scenario::hand_path_schema()
                             : of == "device"      ? scenario::device_schema()
                             : of == "calibration" ? scenario::calibration_schema()
                             : of == "material"    ? scenario::material_schema()
                                                   : scenario::scenario_schema();
  std::printf("%s\n", schema.c_str());
  return kCompleted;
}

}  // namespace

void add_schema(Program& program) {
  const auto of = std::make_shared<std::string>("scenario");
  program.add(
      "schema", "The JSON Schema of a file, for an editor",
      [of](Arguments& arguments) {
        arguments.choice(
            "of", "scenario (default), hand, device, calibration or material; page: all their keys, to read",
            *of, {"scenario", "hand", "device", "calibration", "material", "page"});
      },
      [of] { return schema_command(*of); });
}

}  // namespace fulcrum::app
