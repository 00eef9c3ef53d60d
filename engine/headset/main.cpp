#include "engine/app/commands/commands.h"
#include "engine/audio/output.h"
#include "engine/headset/run_in_headset.h"

namespace {

void add_run(fulcrum::app::Program& program) {
  fulcrum::app::add_run_in_headset(program, &fulcrum::headset::run_in_headset);
}

}  // namespace

int main(int argc, char** argv) {
  fulcrum::audio::settle_library();
  return fulcrum::app::run_program(argc, argv, "Fulcrum in a headset.", {add_run});
}
