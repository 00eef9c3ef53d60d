// Reference: none; any text as that of a device which a scenario names. Invariants: scenario_answer.h.

#include <cstdint>

#include "tests/fuzz/scenario_answer.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fulcrum::scenario::fuzz::read_example_with("devices/test_arm.yaml",
                                             {reinterpret_cast<const char*>(data), size});
  return 0;
}
