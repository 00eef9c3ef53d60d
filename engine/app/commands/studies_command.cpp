#include "engine/app/cli/beside.h"
#include "engine/app/cli/studies.h"
#include "engine/app/commands/commands.h"

namespace fulcrum::app {

void add_studies(Program& program) {
  for (const Study& study : kStudies)
    program.add_elsewhere(
        study.name, study.about,
        [](char** argv) {
          return become({"fulcrum-studies", "studies are carried out"}, argv);
        });
}

}  // namespace fulcrum::app
