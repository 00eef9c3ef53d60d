#include "engine/app/cli/beside.h"
#include "engine/app/commands/commands.h"

namespace fulcrum::app {

void add_import(Program& program) {
  program.add_elsewhere(
      "import", "Make models for scenarios of the meshes of other programs",
      [](char** argv) {
        return run_beside({"fulcrum-import", "meshes are imported"}, argv,
                          "a file that is damaged in a way that its reader could not bear ended the import: "
                          "export it again, or give the files one by one to find it.");
      });
}

}  // namespace fulcrum::app
