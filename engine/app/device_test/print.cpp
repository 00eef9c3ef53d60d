#include "engine/app/device_test/print.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include "engine/app/cli/terminal.h"

namespace fulcrum::app::device_test {
namespace {

std::string in_colour(Outcome outcome) {
  const std::string name(name_of(outcome));
  const std::string room(name_of(Outcome::unknown).size() - name.size(), ' ');
  if (outcome == Outcome::good) return green(name) + room;
  if (outcome == Outcome::bad) return red(name) + room;
  return (outcome == Outcome::odd ? yellow(name) : dim(name)) + room;
}

}  // namespace

void print(const Findings& findings) {
  std::size_t width = 0;
  for (const Part& part : findings.parts) width = std::max(width, part.name.size());
  constexpr std::size_t kOutcome = 9;  // with its two spaces
  for (const Part& part : findings.parts)
    std::printf("%s  %s  %s\n", (part.name + std::string(width - part.name.size(), ' ')).c_str(),
                in_colour(part.outcome).c_str(),
                in_lines(part.says, width + 2 + kOutcome).substr(width + 2 + kOutcome).c_str());
}

}  // namespace fulcrum::app::device_test
