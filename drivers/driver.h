#pragma once
// What the list of devices says of each.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "drivers/hid/hid_family.h"
#include "drivers/registry.h"
#include "drivers/sound/alsa_pcm.h"

namespace fulcrum {

// One device that is listed.
struct Driver {
  std::string_view name;
  std::string_view shown;                                       // how --device takes it
  std::string_view what;                                        // one line
  std::string (*why_not)(const std::string& no_window_reason);  // empty: it is there
  // argument: what follows the colon.
  Result<OpenDevice> (*open)(const std::string& argument, const DeviceOrder& order) = nullptr;
  // Where it has axes that are pushed. signal: what its channels are to render.
  Result<std::shared_ptr<AxesSource>> (*axes)(const VibrotactileSignal& signal) = nullptr;
  // Where it plays on a sound card, beside another device alone.
  Result<sound::SoundPlace> (*plays)(const std::string& argument) = nullptr;
  const hid::HidFamily* family = nullptr;          // of a HID device
  std::span<const hid::HidId> (*usb)() = nullptr;  // of one that speaks USB without HID
  std::uint32_t stop_buttons = 0, go_buttons = 0;
  DeviceWords words{};
  bool in_hand = false;       // a person holds it
  bool in_window = false;     // a window has it alone
  bool table = false;         // content/devices has its figures
  bool vibrates = false;      // beside another device, too
  bool senses = false;        // where another device is held, beside that one alone
  bool motors = false;        // it pushes back
  bool by_service = false;    // a service on this machine has it
  bool by_headset = false;    // a headset's runtime has it, while a scene is shown there
  bool tracks_hands = false;  // by cameras that see hands without controllers
  bool simulated = false;
};

// Those in a hand in the order in which one is taken where none is asked for.
std::span<const Driver> all_drivers();
// What follows a colon in the name belongs to those alone that say so; null: there is none such.
const Driver* driver_of(std::string_view name);
// What follows the colon.
std::string argument_of(const std::string& part);

Error cannot_be_had(const std::string& name, const std::string& why);

}  // namespace fulcrum
