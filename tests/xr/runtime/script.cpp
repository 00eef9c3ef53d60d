#include "tests/xr/runtime/script.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace runtime {
namespace {

[[noreturn]] void refuse(const std::string& line) {
  std::fprintf(stderr, "The script of the tests' runtime has a line that it does not know: %s\n",
               line.c_str());
  std::_Exit(70);
}

bool read_blend(std::istringstream& rest, XrEnvironmentBlendMode& blend) {
  std::string what;
  rest >> what;
  if (what == "additive") blend = XR_ENVIRONMENT_BLEND_MODE_ADDITIVE;
  return what == "additive" || what == "opaque";
}

bool read_setting(const std::string& name, std::istringstream& rest, Script& script) {
  if (name == "size") return static_cast<bool>(rest >> script.width >> script.height);
  if (name == "eyes") return static_cast<bool>(rest >> script.eyes_apart);
  if (name == "focus") return static_cast<bool>(rest >> script.focus);
  if (name == "pace") return static_cast<bool>(rest >> script.pace_ms);
  if (name == "tracking") return static_cast<bool>(rest >> script.tracking);
  if (name == "look") return static_cast<bool>(rest >> script.look) && script.look > 0;
  if (name == "largest") return static_cast<bool>(rest >> script.largest_width >> script.largest_height);
  if (name == "blend") return read_blend(rest, script.blend);
  if (name != "fov") return false;
  for (float& angle : script.fov) rest >> angle;
  return static_cast<bool>(rest);
}

}  // namespace

Script read_script() {
  Script script;
  const char* const name = std::getenv("FULCRUM_XR_SCRIPT");
  if (name == nullptr) return script;
  std::ifstream file(name);
  if (!file) refuse(name);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string first;
    if (!(words >> first)) continue;
    if (first.find_first_not_of("0123456789") != std::string::npos) {
      if (!read_setting(first, words, script)) refuse(line);
      continue;
    }
    Event event{std::stoull(first), {}, {}};
    if (!(words >> event.what)) refuse(line);
    for (std::string word; words >> word;) event.words.push_back(word);
    script.events.push_back(std::move(event));
  }
  std::ranges::stable_sort(script.events, {}, &Event::frame);
  return script;
}

XrPosef pose_in(const std::vector<std::string>& words, std::size_t first) {
  const auto number = [&](std::size_t i, float otherwise) {
    return first + i < words.size() ? std::stof(words[first + i]) : otherwise;
  };
  return {{number(3, 0), number(4, 0), number(5, 0), number(6, 1)},
          {number(0, 0), number(1, 0), number(2, 0)}};
}

}  // namespace runtime
