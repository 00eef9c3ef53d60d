#include "drivers/permission.h"

#include <utility>

namespace fulcrum {

Error not_permitted(const std::string& node) {
  std::string sentence = "it is plugged in (";
  sentence.append(node).append(
      "), and you may not open it: `tools/run --udev` installs the rule that lets you; then plug it in "
      "again.");
  return Error{std::move(sentence)};
}

}  // namespace fulcrum
