#include "engine/scenario/fault.h"

namespace fulcrum::scenario {

std::string Place::text() const {
  std::string text = file;
  if (line > 0)
    for (const int number : {line, column}) text.append(1, ':').append(std::to_string(number));
  return text;
}

std::string Fault::text() const {
  return Place{file, line, column}.text() + ": " + sentence;
}

std::string to_text(const Faults& faults) {
  std::string text;
  for (const Fault& fault : faults) {
    if (!text.empty()) text += '\n';
    text += fault.text();
  }
  return text;
}

}  // namespace fulcrum::scenario
