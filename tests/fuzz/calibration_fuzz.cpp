// Reference: none; any text as the calibration that a tape has. Invariants: those of scenario_answer.h; and a
// calibration that is taken stays within the device's table.

#include <cstdint>
#include <cstdlib>

#include "tests/fuzz/scenario_answer.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fulcrum;
  const scenario::SourceTexts texts =
      scenario::fuzz::example_with("/calibration.yaml", {reinterpret_cast<const char*>(data), size});
  const auto answer = scenario::load_scenario_texts(texts, "/nowhere");
  scenario::fuzz::expect_answer(answer, texts);
  if (!answer) return 0;
  const DeviceDesc& device = answer->device.desc;
  const DeviceDesc table;  // that of the example says no more of these than that it pushes with 3 N
  const Vec3 reach = device.workspace_centre.cwiseAbs() + device.workspace;
  if (!((reach - table.workspace).maxCoeff() <= 1e-8) || !(device.workspace.minCoeff() >= 0.02)) std::abort();
  if (!(device.handle_weight >= 0 && device.handle_weight <= 1)) std::abort();
  return 0;
}
