// Reference: none; any text as a scenario, in a folder with a device, a material and hands' paths of its own,
// with the devices and materials that the program comes with. Invariants: scenario_answer.h, and what a
// scenario keeps of its texts, as a tape does, reads again.

#include <cstdint>
#include <cstdlib>

#include "tests/fuzz/scenario_answer.h"
#include "tests/scenario/example.h"

namespace {

using namespace fulcrum::scenario;

// The hands of content/scenarios are called so, and a scenario from there is read whole.
struct FolderWithHands : test::Folder {
  FolderWithHands() {
    for (const char* hand : {"expert", "clumsy", "still", "yielding"})
      write("scenarios/peg/" + std::string(hand) + ".yaml", test::kHandPath);
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const test::Installed content(FULCRUM_SOURCE_DIR "/content");
  static const FolderWithHands folder;
  const SourceTexts texts{"scenario.yaml",
                          {{"scenario.yaml", {reinterpret_cast<const char*>(data), size}},
                           {"devices/test_arm.yaml", test::kDevice}}};
  const auto answer = load_scenario_text(texts.files.at("scenario.yaml"), folder.peg());
  fuzz::expect_answer(answer, texts);
  if (answer && !load_scenario_texts(answer->texts, folder.peg())) std::abort();
  return 0;
}
