// Reference: none; any lines as options KEY=VALUE of --set, for a scenario that is good without them.
// Invariants: scenario_answer.h.

#include <cstdint>
#include <sstream>

#include "tests/fuzz/scenario_answer.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fulcrum::scenario;
  constexpr std::size_t kMaxOptions = 16;  // more of them only take longer
  std::istringstream lines(std::string(reinterpret_cast<const char*>(data), size));
  std::vector<std::string> overrides;
  for (std::string line; overrides.size() < kMaxOptions && std::getline(lines, line);)
    overrides.push_back(line);
  static const SourceTexts texts = fuzz::example_with("sure.yaml", "fulcrum: 1\nwaypoints: [{}]\n");
  fuzz::expect_answer(load_scenario_texts(texts, "/nowhere", overrides), texts);
  return 0;
}
