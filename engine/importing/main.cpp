#include "engine/importing/import_command.h"

int main(int argc, char** argv) {
  return fulcrum::app::run_program(argc, argv, "Models for Fulcrum, a haptic training simulator.",
                                   {fulcrum::importing::add_import});
}
