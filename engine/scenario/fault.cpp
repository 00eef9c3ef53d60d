#include "engine/scenario/fault.h"

namespace fulcrum::scenario {

std::string place_text(std::string file, int line, int column) {
  if (line > 0)
    for (const int number : {line, column}) file.append(1, ':').append(std::to_string(number));
  return file;
}

std::string Fault::text() const {
  return place_text(file, line, column) + ": " + sentence;
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
