#pragma once
// The devices. One line of the list in driver_list.cpp says of each what it is, whether it is there, and
// makes it.
//
// A name on the command line is one of them, or two: "spacemouse+dualsense" moves by the first and vibrates
// by the second, "polhem+strip" learns from the second where the first is held.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/controller/controllers.h"
#include "drivers/gamepad/gamepad_axes.h"
#include "drivers/keyboard/key_axes.h"
#include "drivers/mouse/mouse_device.h"
#include "drivers/rate/rate_device.h"
#include "drivers/sound/sound_link.h"
#include "haptics/device/device.h"
#include "haptics/math/result.h"

namespace fulcrum {

struct DeviceListing {
  std::string name;  // as --device takes it
  std::string what;  // what it is, one line
  bool present = false;
  std::string reason{};             // why not, and what would change that; empty when present
  bool beside_alone = false;        // it moves nothing, and stands beside another device
  std::string table{};              // the file of content/devices with its figures, by name; empty: none
  std::string node{};               // where it is plugged in; empty: it is not, or its driver does not know
  std::optional<bool> permitted{};  // that node may be opened by you; none: there is no node
  std::string firmware{};           // its version, such as "1.06"; empty: nothing tells

  bool operator==(const DeviceListing&) const = default;
};

// no_window_reason: why no window can be opened; empty if one can.
std::vector<DeviceListing> list_devices(const std::string& no_window_reason);

// Those of them that a service on this machine has: the kernel shows nothing of whether it runs.
std::vector<DeviceListing> list_services(const std::string& no_window_reason);

// The first of the devices in a hand that is there, in the order of the list; the mouse where none before it
// is, even if there is no window for it: then it is not present, and the listing says why.
DeviceListing best_device(const std::string& no_window_reason);

// The rules for udev that let the person at the seat open these devices, as a file of /etc/udev/rules.d whose
// name begins with 70-.
std::string udev_rules();

// A device with these numbers is one of them.
bool knows_usb(std::uint16_t vendor, std::uint16_t product);

// What the two parts of a name stand for.
struct DeviceName {
  std::string moves;   // the device that the hand moves
  std::string beside;  // what vibrates or senses beside it; may be empty
};
// Errors: there is no such device, or one of the two cannot do what is asked of it.
Result<DeviceName> read_device_name(const std::string& name);

// The device moves the handle as the trainee sees it, not in a frame of its own: a mouse, a cap, sticks,
// keys.
bool moves_as_seen(const std::string& name);

// Beside the device, something senses where its handle is held.
bool senses_beside(const std::string& name);

// How a device's person does what a scenario speaks of, as clauses: "push the cap".
struct DeviceWords {
  std::string_view move = "move the handle";
  std::string_view turn = "turn the handle";
  std::string_view finely = "move it slowly";
  std::string_view stop = "press Esc";
  std::string_view go_on = "press Enter";
};
// Of the device that the hand moves; those of a handle where there is no such device.
DeviceWords device_words(const std::string& name);

// The device has motors of its own, and a person holds it.
bool pushes_back(const std::string& name);

// content/devices has its figures, under its name.
bool has_table(const std::string& name);

// The table of a part of a name that has one: of audio:hw:1,0 audio.
std::string table_of(const std::string& part);

// The handle is moved by a simulated hand.
bool is_simulated(const std::string& name);

// The handle is moved by hands that a headset's runtime sees.
bool is_of_headset(const std::string& name);

// The handle is moved by a hand without a controller, as a headset's cameras see it.
bool tracks_hands(const std::string& name);

// What vibrates beside is played on a sound card.
bool plays_sound(const std::string& name);

// What a run has for its device.
struct RunsIn {
  std::string no_window_reason{};  // empty where a window will be there
  bool by_clock = false;           // ticks come when they are due, as a hand needs them
  bool headset = false;            // a headset shows it
};

// Why nothing that has no window can have this device, whatever is plugged in.
std::optional<Error> refuse_without_window(const std::string& name, const std::string& no_window_reason);

// Why a run cannot have this device now, known before anything is baked.
std::optional<Error> refuse_device(const std::string& name, const RunsIn& runs);

// What a run asks of its device.
struct DeviceOrder {
  DeviceDesc desc;                             // its figures, with the channels of what vibrates beside it
  std::optional<VibrotactileSignal> signal{};  // what the channels are to render; none: nothing drives them
  Pose X_DH;                                   // where the handle begins
  double tick_s = 1e-3;
  // What the scenario makes.
  std::function<Result<std::unique_ptr<Device>>()> simulated{};
  std::function<Result<std::unique_ptr<Device>>(const std::string& file)> replay{};
};

struct OpenDevice {
  std::unique_ptr<Device> device;
  // Parts of it that the window or the headset talks to; null where it has none.
  MouseDevice* mouse = nullptr;
  RateDevice* rate = nullptr;
  std::shared_ptr<KeyAxes> keys{};
  std::shared_ptr<GamepadAxes> gamepad{};
  std::shared_ptr<Controllers> controllers{};
  const sound::SoundLink* sound = nullptr;
  // Of DeviceSample::buttons: those that ask for what Esc and Enter ask for.
  std::uint32_t stop_buttons = 0, go_buttons = 0;
};

// name: one that refuse_device() has passed. Errors: it is gone meanwhile, or what it was made of is wrong.
Result<OpenDevice> open_device(const std::string& name, const DeviceOrder& order);

}  // namespace fulcrum
