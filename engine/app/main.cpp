#include "engine/app/commands/commands.h"
#include "engine/audio/output.h"

int main(int argc, char** argv) {
  using namespace fulcrum::app;
  fulcrum::audio::settle_library();
  return run_program(argc, argv, "Fulcrum, a haptic training simulator.",
                     {add_start, add_list, add_run, add_replay, add_results, add_check, add_explain,
                      add_devices, add_device_test, add_calibrate, add_doctor, add_new, add_edit, add_path,
                      add_import, add_studies, add_strip, add_schema});
}
