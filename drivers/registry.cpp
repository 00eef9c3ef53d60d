#include "drivers/registry.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "drivers/driver.h"
#include "drivers/sound/sound.h"
#include "drivers/usb/usb_port.h"

namespace fulcrum {
namespace {

// A simulated hand holds none of the devices that a person does, and may feel what vibrates beside; its strip
// is simulated with it.
bool takes_beside(const Driver& moves, const Driver& beside) {
  return moves.in_hand || (moves.simulated && beside.vibrates);
}

// One that is named is asked for by its name.
std::string why_not_part(const std::string& part, const RunsIn& runs) {
  const Driver* const driver = driver_of(part);
  if (driver == nullptr || (driver->by_headset && runs.headset)) return "";
  const std::string argument = argument_of(part);
  const bool named_sound = driver->plays != nullptr && !argument.empty();
  return named_sound ? sound::why_no_sound(driver->plays(argument)) : driver->why_not(runs.no_window_reason);
}

std::string names_where(bool (*counts)(const Driver&)) {
  std::string names;
  for (const Driver& driver : all_drivers())
    if (counts(driver)) names += (names.empty() ? "" : ", ") + std::string(driver.shown);
  return names;
}

// 0x0106 is "1.06".
std::string version_text(std::uint16_t release) {
  char text[8];
  std::snprintf(text, sizeof text, "%x.%02x", release >> 8, release & 0xffU);
  return release != 0 ? text : "";
}

DeviceListing listing_of(const Driver& driver, const std::string& no_window_reason) {
  DeviceListing listing{.name = std::string(driver.shown), .what = std::string(driver.what)};
  listing.beside_alone = !driver.in_hand && (driver.vibrates || driver.senses);
  if (driver.table) listing.table = driver.name;
  listing.reason = driver.why_not(no_window_reason);
  if (driver.family != nullptr) {
    if (const std::optional<hid::HidPlace> place = hid::find_one(*driver.family)) {
      listing.node = place->path;
      listing.permitted = place->permitted;
      listing.firmware = version_text(place->release);
    }
  }
  if (driver.usb != nullptr) {
    const std::vector<usb::UsbPlace> places = usb::find_usb(driver.usb());
    const auto open = std::ranges::find(places, true, &usb::UsbPlace::permitted);
    const auto place = open != places.end() ? open : places.begin();
    if (place != places.end()) {
      listing.node = place->path;
      listing.permitted = place->permitted;
    }
  }
  listing.present = listing.reason.empty();
  return listing;
}

}  // namespace

std::vector<DeviceListing> list_devices(const std::string& no_window_reason) {
  std::vector<DeviceListing> listings;
  for (const Driver& driver : all_drivers()) listings.push_back(listing_of(driver, no_window_reason));
  return listings;
}

std::vector<DeviceListing> list_services(const std::string& no_window_reason) {
  std::vector<DeviceListing> listings;
  for (const Driver& driver : all_drivers())
    if (driver.by_service) listings.push_back(listing_of(driver, no_window_reason));
  return listings;
}

DeviceListing best_device(const std::string& no_window_reason) {
  for (const Driver& driver : all_drivers()) {
    if (!driver.in_hand) continue;
    DeviceListing listing = listing_of(driver, no_window_reason);
    if (listing.present || driver.name == "mouse") return listing;
  }
  return {};
}

Error cannot_be_had(const std::string& name, const std::string& why) {
  std::string sentence = "The device '";
  sentence.append(name).append("' cannot be had: ").append(why);
  return Error{std::move(sentence)};
}

Result<DeviceName> read_device_name(const std::string& name) {
  const auto plus = name.starts_with("replay:") ? std::string::npos : name.find('+');
  const DeviceName parts{name.substr(0, plus), plus == std::string::npos ? "" : name.substr(plus + 1)};
  const Driver* const moves = driver_of(parts.moves);
  if (moves == nullptr)
    return Error{"There is no device '" + parts.moves + "'; there are " +
                 names_where([](const Driver&) { return true; }) +
                 ". `fulcrum devices` says what is there and what is not."};
  if (moves->senses)
    return Error{"'" + parts.moves +
                 "' moves nothing: put the device that it is fixed to before it, such as polhem+" +
                 parts.moves + "."};
  if (plus == std::string::npos && moves->open == nullptr)
    return Error{"'" + parts.moves + "' moves nothing: it vibrates beside another device, as in mouse+" +
                 parts.moves + "."};
  if (plus == std::string::npos) return parts;
  const Driver* const beside = driver_of(parts.beside);
  if (beside == nullptr || !(beside->vibrates || beside->senses))
    return Error{"Nothing vibrates by '" + parts.beside +
                 "', and it senses nothing: after the + comes what does either beside the device in the "
                 "hand, one of " +
                 names_where([](const Driver& driver) { return driver.vibrates || driver.senses; }) + "."};
  if (!takes_beside(*moves, *beside) || moves == beside)
    return Error{"'" + parts.moves +
                 "' takes nothing beside it: before the + comes another device in the hand, "
                 "such as spacemouse or mouse."};
  return parts;
}

std::optional<Error> refuse_without_window(const std::string& name, const std::string& no_window_reason) {
  const Result<DeviceName> parts = read_device_name(name);
  if (!parts) return parts.error();
  if (!no_window_reason.empty() && driver_of(parts->moves)->in_window)
    return cannot_be_had(parts->moves, no_window_reason);
  return std::nullopt;
}

std::optional<Error> refuse_device(const std::string& name, const RunsIn& runs) {
  if (auto refused = refuse_without_window(name, runs.no_window_reason)) return refused;
  const Result<DeviceName> parts = read_device_name(name);
  if (!parts) return parts.error();
  for (const std::string& part : {parts->moves, parts->beside}) {
    const std::string reason = why_not_part(part, runs);
    if (!reason.empty()) return cannot_be_had(part, reason);
  }
  if (driver_of(parts->moves)->in_hand && !runs.no_window_reason.empty() && !runs.by_clock)
    return Error{
        "The device '" + name +
        "' is in a hand, which cannot keep up with ticks that come as fast as they can: add --realtime."};
  if (!parts->beside.empty() && !runs.no_window_reason.empty() && !runs.by_clock)
    return Error{"'" + parts->beside +
                 "' vibrates by the clock, and cannot keep up with ticks that come as fast as they can: add "
                 "--realtime."};
  return std::nullopt;
}

bool moves_as_seen(const std::string& name) {
  const Driver* const driver = driver_of(name.substr(0, name.find('+')));
  return driver != nullptr && driver->in_hand && !driver->motors;
}

DeviceWords device_words(const std::string& name) {
  const std::string moves = name.substr(0, name.find('+'));
  const Driver* const driver = driver_of(moves.substr(0, moves.find(':')));
  return driver != nullptr ? driver->words : DeviceWords();
}

bool senses_beside(const std::string& name) {
  const Result<DeviceName> parts = read_device_name(name);
  return parts && !parts->beside.empty() && driver_of(parts->beside)->senses;
}

bool pushes_back(const std::string& name) {
  const Driver* const driver = driver_of(name.substr(0, name.find('+')));
  return driver != nullptr && driver->motors;
}

bool has_table(const std::string& name) {
  const Driver* const driver = driver_of(name);
  return driver != nullptr && driver->table;
}

std::string table_of(const std::string& part) {
  return part.substr(0, part.find(':'));
}

bool is_simulated(const std::string& name) {
  const Driver* const driver = driver_of(name.substr(0, name.find('+')));
  return driver != nullptr && driver->simulated;
}

bool is_of_headset(const std::string& name) {
  const Driver* const driver = driver_of(name.substr(0, name.find('+')));
  return driver != nullptr && driver->by_headset;
}

bool tracks_hands(const std::string& name) {
  const Driver* const driver = driver_of(name.substr(0, name.find('+')));
  return driver != nullptr && driver->tracks_hands;
}

bool plays_sound(const std::string& name) {
  const Result<DeviceName> parts = read_device_name(name);
  const Driver* const beside = parts ? driver_of(parts->beside) : nullptr;
  return beside != nullptr && beside->plays != nullptr;
}

}  // namespace fulcrum
