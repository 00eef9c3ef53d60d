#include "drivers/fault/injected_fault.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace fulcrum {
namespace {

std::string all_faults() {
  std::string names;
  for (const std::string_view name : names_of<Injection>)
    names.append(names.empty() ? "" : ", ").append(name);
  return names;
}

}  // namespace

Result<InjectedFault> read_injected_fault(const std::string& text) {
  const std::size_t at = text.find('@');
  const auto named = std::ranges::find(names_of<Injection>, std::string_view(text).substr(0, at));
  if (named == names_of<Injection>.end())
    return Error{"there is no fault '" + text.substr(0, at) + "'; there are " + all_faults() + "."};
  const auto kind = static_cast<Injection>(named - names_of<Injection>.begin());
  const std::string time = at == std::string::npos ? "" : text.substr(at + 1);
  char* end = nullptr;
  const double seconds = std::strtod(time.c_str(), &end);
  if (time.empty() || *end != '\0' || !std::isfinite(seconds) || seconds < 0)
    return Error{"'" + text + "' does not say when: " + std::string(*named) +
                 "@T with T in s from the run's start, such as " + std::string(*named) + "@1.5."};
  return InjectedFault{kind, seconds};
}

bool needs_clock(Injection kind) {
  return kind == Injection::late || kind == Injection::pause;
}

bool is_of_device(Injection kind) {
  return kind < Injection::disk_full;
}

}  // namespace fulcrum
