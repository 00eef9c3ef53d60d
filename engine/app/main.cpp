#include <csignal>
#include <exception>
#include <string>

#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/commands/commands.h"

namespace fulcrum::app {
namespace {

int run_program(int argc, char** argv) {
  Program program("Fulcrum, a haptic training simulator.");
  for (const auto add :
       {add_list, add_run, add_replay, add_check, add_explain, add_devices, add_compare, add_ambiguity,
        add_hardness, add_stability, add_workprecision, add_strip, add_uniformity, add_schema})
    add(program);
  return program.run(argc, argv);
}

}  // namespace
}  // namespace fulcrum::app

int main(int argc, char** argv) {
  // A file that may not grow becomes an error that is said, not the end of the program.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return fulcrum::app::run_program(argc, argv);
  } catch (const std::exception& error) {
    fulcrum::app::complain(std::string("this should not have happened: ") + error.what());
    return fulcrum::app::kError;
  }
}
