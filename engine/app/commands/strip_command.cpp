#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/named_device.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/commands/commands.h"
#include "engine/files/line_reader.h"
#include "haptics/math/number_text.h"

namespace fulcrum::app {
namespace {

constexpr double kGoodFit = 1e-3;  // m rms: a finger's own place is no more certain

// "place,ohm" or "place, ohm"; nothing if it is not two finite numbers.
std::optional<StripPress> press_of(std::string_view line) {
  StripPress press;
  const char* const end = line.data() + line.size();
  const auto [comma, first] = std::from_chars(line.data(), end, press.place);
  if (first != std::errc() || comma == end || *comma != ',') return std::nullopt;
  const char* const ohm = std::find_if(comma + 1, end, [](char c) { return c != ' '; });
  const auto [rest, second] = std::from_chars(ohm, end, press.ohm);
  const bool whole = second == std::errc() && rest == end;
  return whole && std::isfinite(press.place) && std::isfinite(press.ohm) ? std::optional(press)
                                                                         : std::nullopt;
}

std::optional<std::vector<StripPress>> read_presses(const std::string& path) {
  const auto unread = [&path](const Error& why) {
    complain("'" + path + "' cannot be read (" + why.sentence +
             "): give a file with a line for each press, its place in m and ohm.");
    return std::nullopt;
  };
  Result<RegularFile> file = RegularFile::open(path);
  if (!file) return unread(file.error());
  LineReader lines(std::move(*file));
  std::vector<StripPress> presses;
  while (std::optional<std::string_view> line = lines.next()) {
    if (line->ends_with('\r')) line->remove_suffix(1);
    if (line->empty() || (lines.line() == 1 && *line == "place_m,ohm")) continue;
    const std::optional<StripPress> press = press_of(*line);
    if (!press) {
      complain(path + ", line " + std::to_string(lines.line()) +
               ": this is not a press. Write its place along the stick in m and what the strip said in ohm, "
               "such as "
               "0.05,1514.");
      return std::nullopt;
    }
    presses.push_back(*press);
  }
  if (lines.fault()) return unread(*lines.fault());
  return presses;
}

int strip_command(const std::string& device_name, const std::string& path) {
  const std::optional<DeviceDesc> device = device_named(device_name);
  if (!device) return kError;
  if (!device->strip) {
    complain("the device '" + device_name +
             "' has no strip: give its file a 'strip' with low_place and high_place.");
    return kError;
  }
  const auto presses = read_presses(path);
  if (!presses) return kError;
  const std::optional<StripFit> fit = fit_strip(*device->strip, *presses);
  if (!fit) {
    complain(path +
             ": no line goes through these presses. Press the strip in two places at least, near its ends.");
    return kError;
  }
  if (const double least = std::min(fit->low_ohm, fit->high_ohm); least < 0) {
    complain(path + ": by these presses the strip would have " + number_text(least, 6) +
             " ohm at one end. Check what was noted, and press it nearer to that end.");
    return kError;
  }
  std::printf("low_ohm: %s\nhigh_ohm: %s\n", number_text(fit->low_ohm, 6).c_str(),
              number_text(fit->high_ohm, 6).c_str());
  std::printf(
      "%zu presses lie %s mm rms from that line.%s\n", presses->size(),
      number_text(1e3 * fit->residual, 2).c_str(),
      fit->residual > kGoodFit
          ? " That is more than a finger errs: the strip is bent, or a place is not what it was noted as."
          : "");
  return kCompleted;
}

}  // namespace

void add_strip(Program& program) {
  const auto presses = std::make_shared<std::string>();
  const auto device = std::make_shared<std::string>("freedom6s");
  program.add(
      "strip", "Calibrate a device's strip: the ends of it from presses at known places",
      [presses, device](Arguments& arguments) {
        arguments.required({"presses", "FILE", "A line for each: its place in m along the stick, and ohm"},
                           *presses);
        arguments.text({"--device", "NAME", "A file of content/devices, by name (default: freedom6s)"},
                       *device);
      },
      [presses, device] { return strip_command(*device, *presses); });
}

}  // namespace fulcrum::app
