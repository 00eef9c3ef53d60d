#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/studies.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/commands/commands.h"

namespace fulcrum::app {
namespace {

// Does not return where it succeeds: this process becomes the other program.
int start_studies(char** argv) {
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path program = self.parent_path() / "fulcrum-studies";
  if (!error) {
    execv(program.c_str(), argv);
    error = std::error_code(errno, std::generic_category());
  }
  complain("studies are carried out by " + program.string() + ", which could not be started (" +
           error.message() +
           "): `tools/run --build` builds it, or `cmake --build` with the target fulcrum-studies.");
  return kError;
}

}  // namespace

void add_studies(Program& program) {
  for (const Study& study : kStudies) program.add_elsewhere(study.name, study.about, &start_studies);
}

}  // namespace fulcrum::app
