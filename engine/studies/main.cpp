#include "engine/studies/commands.h"

int main(int argc, char** argv) {
  using namespace fulcrum::app;
  return run_program(
      argc, argv, "The studies of Fulcrum, a haptic training simulator.",
      {add_compare, add_ambiguity, add_hardness, add_stability, add_workprecision, add_uniformity});
}
