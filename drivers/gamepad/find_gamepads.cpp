#include "drivers/gamepad/find_gamepads.h"

#include <dirent.h>
#include <linux/input.h>
#include <unistd.h>

#include <algorithm>
#include <bitset>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "drivers/registry.h"

namespace fulcrum {
namespace {

using Codes = std::bitset<KEY_CNT>;

std::string first_line(const std::string& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  return line;
}

std::uint16_t hex_number(const std::string& text) {
  return static_cast<std::uint16_t>(std::strtoul(text.c_str(), nullptr, 16));
}

// sysfs has words of 64 bits, the highest first, and leaves out those above that are 0.
Codes codes_in(const std::string& line) {
  std::vector<unsigned long long> words;
  std::istringstream in(line);
  std::string word;
  while (in >> word) words.push_back(std::strtoull(word.c_str(), nullptr, 16));
  std::ranges::reverse(words);
  Codes codes;
  for (std::size_t code = 0; code < codes.size() && code / 64 < words.size(); ++code)
    codes[code] = ((words[code / 64] >> (code % 64)) & 1U) != 0;
  return codes;
}

// As GLFW numbers them: buttons in the order of their codes, axes too, but for those of crosses.
std::size_t buttons_before(const Codes& keys, unsigned code) {
  std::size_t count = 0;
  for (unsigned below = BTN_MISC; below < code; ++below) count += keys[below] ? 1 : 0;
  return count;
}
std::size_t axes_before(const Codes& axes, unsigned code) {
  std::size_t count = 0;
  for (unsigned below = 0; below < code; ++below)
    count += axes[below] && (below < ABS_HAT0X || below > ABS_HAT3Y) ? 1 : 0;
  return count;
}

struct Id {
  std::uint16_t bus, vendor, product, version;
};

// By which GLFW knows a pad; Id's numbers, the lower byte first.
std::string guid_of(const Id& id) {
  std::string guid;
  for (const std::uint16_t number : {id.bus, id.vendor, id.product, id.version}) {
    char part[16];
    std::snprintf(part, sizeof part, "%02x%02x0000", number & 0xffU, number >> 8U);
    guid += part;
  }
  return guid;
}

std::string mapping_of(const Id& id, const Codes& keys, const Codes& axes) {
  struct Named {
    const char* name;
    unsigned code;
  };
  constexpr Named kButtons[] = {{"a", BTN_SOUTH},
                                {"b", BTN_EAST},
                                {"x", BTN_X},
                                {"y", BTN_Y},
                                {"back", BTN_SELECT},
                                {"start", BTN_START},
                                {"guide", BTN_MODE},
                                {"leftstick", BTN_THUMBL},
                                {"rightstick", BTN_THUMBR},
                                {"leftshoulder", BTN_TL},
                                {"rightshoulder", BTN_TR},
                                {"dpup", BTN_DPAD_UP},
                                {"dpdown", BTN_DPAD_DOWN},
                                {"dpleft", BTN_DPAD_LEFT},
                                {"dpright", BTN_DPAD_RIGHT}};
  constexpr Named kAxes[] = {{"leftx", ABS_X},   {"lefty", ABS_Y},       {"rightx", ABS_RX},
                             {"righty", ABS_RY}, {"lefttrigger", ABS_Z}, {"righttrigger", ABS_RZ}};
  std::string mapping = guid_of(id) + ",Gamepad";
  for (const Named& button : kButtons)
    if (keys[button.code])
      mapping.append(",")
          .append(button.name)
          .append(":b")
          .append(std::to_string(buttons_before(keys, button.code)));
  for (const Named& axis : kAxes)
    if (axes[axis.code])
      mapping.append(",").append(axis.name).append(":a").append(std::to_string(axes_before(axes, axis.code)));
  if (!axes[ABS_Z] && keys[BTN_TL2])
    mapping += ",lefttrigger:b" + std::to_string(buttons_before(keys, BTN_TL2));
  if (!axes[ABS_RZ] && keys[BTN_TR2])
    mapping += ",righttrigger:b" + std::to_string(buttons_before(keys, BTN_TR2));
  if (axes[ABS_HAT0X]) mapping += ",dpup:h0.1,dpright:h0.2,dpdown:h0.4,dpleft:h0.8";
  return mapping + ",platform:Linux,";
}

std::vector<std::string> event_nodes() {
  std::vector<std::string> names;
  DIR* const open = opendir("/sys/class/input");
  if (open == nullptr) return names;
  while (const dirent* const entry = readdir(open))
    if (std::string name = entry->d_name; name.starts_with("event")) names.push_back(std::move(name));
  closedir(open);
  // event10 after event9
  std::ranges::sort(names, {}, [](const std::string& name) { return std::atoi(name.c_str() + 5); });
  return names;
}

}  // namespace

std::vector<GamepadPlace> find_gamepads() {
  std::vector<GamepadPlace> places;
  for (const std::string& event : event_nodes()) {
    const std::string device = "/sys/class/input/" + event + "/device/";
    const Codes keys = codes_in(first_line(device + "capabilities/key"));
    const Codes axes = codes_in(first_line(device + "capabilities/abs"));
    if (!keys[BTN_GAMEPAD] || !axes[ABS_X] || !axes[ABS_Y]) continue;
    const auto number = [&](const char* part) { return hex_number(first_line(device + "id/" + part)); };
    const Id id{number("bustype"), number("vendor"), number("product"), number("version")};
    if (knows_usb(id.vendor, id.product)) continue;
    const std::string node = "/dev/input/" + event;
    places.push_back(
        {node, first_line(device + "name"), access(node.c_str(), R_OK) == 0, mapping_of(id, keys, axes)});
  }
  return places;
}

std::string why_no_gamepad() {
  const std::vector<GamepadPlace> places = find_gamepads();
  if (places.empty())
    return "none is plugged in, and none is paired and awake: plug one in. Pads that have a name of their "
           "own in this list are used by it.";
  if (std::ranges::any_of(places, &GamepadPlace::permitted)) return "";
  // systemd's own rule lets who sits at the machine open every pad.
  return "it is plugged in (" + places.front().node +
         "), and you may not open it: `sudo usermod -aG input $USER` lets you, once you have logged in "
         "again.";
}

}  // namespace fulcrum
