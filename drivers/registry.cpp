#include "drivers/registry.h"

#include <algorithm>
#include <cstdio>
#include <string_view>
#include <utility>

#include "drivers/dualsense/dualsense_protocol.h"
#include "drivers/dualshock4/dualshock4_protocol.h"
#include "drivers/falcon/falcon_bus.h"
#include "drivers/force/force_device.h"
#include "drivers/hid/hid_link.h"
#include "drivers/inverse3/inverse3_bus.h"
#include "drivers/joycon/joycon_pair.h"
#include "drivers/joycon/joycon_protocol.h"
#include "drivers/omega/omega_bus.h"
#include "drivers/permission.h"
#include "drivers/polhem/polhem_bus.h"
#include "drivers/sony/pad_axes.h"
#include "drivers/sound/sound.h"
#include "drivers/spacemouse/spacemouse_protocol.h"
#include "drivers/strip/strip_bus.h"
#include "drivers/strip/strip_device.h"
#include "drivers/touch/touch_bus.h"
#include "drivers/vibrating/rumbling_pad.h"
#include "drivers/vibrating/vibrating_device.h"

namespace fulcrum {
namespace {

using hid::HidOpened;
using hid::HidPlace;

// A family of HID devices that speak the same.
struct HidFamily {
  std::span<const hid::HidId> (*ids)();
  // Of those that are pushed. signal: what their channels are to render.
  std::unique_ptr<hid::HidProtocol> (*protocol)(const HidPlace&, const VibrotactileSignal& signal) = nullptr;
  hid::Nodes nodes = hid::Nodes::of_axes;
  std::string_view product{};  // what it calls itself, where its numbers may be others', too
};

sony::Link link_of(const HidPlace& place) {
  return place.bluetooth ? sony::Link::bluetooth : sony::Link::usb;
}

constexpr HidFamily kSpaceMouse{
    &spacemouse_ids,
    [](const HidPlace&, const VibrotactileSignal&) -> std::unique_ptr<hid::HidProtocol> {
      return std::make_unique<SpaceMouseProtocol>();
    }};
constexpr HidFamily kDualSense{
    &dualsense::usb_ids,
    [](const HidPlace& place, const VibrotactileSignal&) -> std::unique_ptr<hid::HidProtocol> {
      return std::make_unique<dualsense::DualSenseProtocol>(link_of(place));
    }};
constexpr HidFamily kDualShock4{
    &dualshock4::usb_ids,
    [](const HidPlace& place, const VibrotactileSignal&) -> std::unique_ptr<hid::HidProtocol> {
      return std::make_unique<dualshock4::DualShock4Protocol>(link_of(place));
    }};

template <joycon::Side kSide>
std::unique_ptr<hid::HidProtocol> joycon_protocol(const HidPlace&, const VibrotactileSignal& signal) {
  return std::make_unique<joycon::JoyConProtocol>(kSide, signal.carrier_Hz);
}
template <joycon::Side kSide>
constexpr HidFamily kJoyCon{[] { return joycon::ids(kSide); }, &joycon_protocol<kSide>};
constexpr HidFamily kJoyConPair{.ids = &joycon::pair_ids};  // each half has a node of its own

constexpr HidFamily kStrip{
    .ids = &strip::usb_ids, .nodes = hid::Nodes::of_vendor, .product = strip::kProduct};
constexpr HidFamily kPolhem{.ids = &polhem::usb_ids, .nodes = hid::Nodes::all};

// What is wrong with one matters only if there is no other.
std::optional<HidPlace> found(const HidFamily& family) {
  std::vector<HidPlace> places = hid::find_hid(family.ids(), family.nodes);
  std::erase_if(places, [&](const HidPlace& p) { return !p.product.starts_with(family.product); });
  if (places.empty()) return std::nullopt;
  const auto open = std::ranges::find(places, true, &HidPlace::permitted);
  return open != places.end() ? *open : places.front();
}

// Empty: it can be opened there.
std::string why_not_at(const HidFamily& family, const std::optional<HidPlace>& place) {
  if (!place)
    return family.nodes != hid::Nodes::of_axes
               ? "none is plugged in: plug one in, and switch it on."
               : "none is plugged in, and none is paired and awake: plug one in.";
  return place->permitted ? "" : not_permitted(place->path).sentence;
}

// Where it is, or why it is not.
Result<HidPlace> place_of(const HidFamily& family) {
  const std::optional<HidPlace> place = found(family);
  std::string reason = why_not_at(family, place);
  if (!reason.empty()) return Error{std::move(reason)};
  return *place;
}

// 0x0106 is "1.06".
std::string version_text(std::uint16_t release) {
  char text[8];
  std::snprintf(text, sizeof text, "%x.%02x", release >> 8, release & 0xffU);
  return release != 0 ? text : "";
}

HidOpened open_family(const HidFamily& family, const VibrotactileSignal& signal) {
  const Result<HidPlace> place = place_of(family);
  if (!place) return {};
  Result<std::unique_ptr<hid::HidPort>> port = hid::open_hid(*place);
  if (!port) return {};
  return {std::move(*port), family.protocol(*place, signal)};
}

template <const HidFamily& kFamily>
std::string why_no_hid(const std::string& /*no_window_reason*/) {
  const Result<HidPlace> place = place_of(kFamily);
  return place ? "" : place.error().sentence;
}

template <const HidFamily& kFamily>
Result<std::shared_ptr<AxesSource>> hid_axes(const VibrotactileSignal& signal) {
  const Result<HidPlace> place = place_of(kFamily);
  if (!place) return place.error();
  Result<std::unique_ptr<hid::HidPort>> port = hid::open_hid(*place);
  if (!port) return port.error();
  return std::shared_ptr<AxesSource>(
      std::make_shared<hid::HidLink>(HidOpened{std::move(*port), kFamily.protocol(*place, signal)},
                                     [signal] { return open_family(kFamily, signal); }));
}

// One half alone has neither six axes nor two channels.
std::string why_no_joycons(const std::string& no_window_reason) {
  const auto why_not = [](const char* half, const HidFamily& family, std::string reason) {
    if (reason.empty() || !hid::find_hid(family.ids()).empty()) return reason;
    return std::string(half) +
           " is not paired and awake, and both halves are needed: hold the button between its SL and SR "
           "until its "
           "lights run, pair it by Bluetooth, then press one of its keys.";
  };
  std::string left = why_not("the left one", kJoyCon<joycon::Side::left>,
                             why_no_hid<kJoyCon<joycon::Side::left>>(no_window_reason));
  return !left.empty() ? left
                       : why_not("the right one", kJoyCon<joycon::Side::right>,
                                 why_no_hid<kJoyCon<joycon::Side::right>>(no_window_reason));
}

Result<std::shared_ptr<AxesSource>> joycon_axes(const VibrotactileSignal& signal) {
  auto left = hid_axes<kJoyCon<joycon::Side::left>>(signal);
  if (!left) return left.error();
  auto right = hid_axes<kJoyCon<joycon::Side::right>>(signal);
  if (!right) return right.error();
  return std::shared_ptr<AxesSource>(
      std::make_shared<joycon::JoyConPair>(std::move(*left), std::move(*right)));
}

std::string always(const std::string& /*no_window_reason*/) {
  return "";
}
std::string in_window(const std::string& no_window_reason) {
  return no_window_reason;
}

OpenDevice by_axes(std::shared_ptr<AxesSource> axes, const DeviceOrder& order) {
  auto device = std::make_unique<RateDevice>(order.desc, std::move(axes), order.X_DH, order.tick_s);
  RateDevice* const rate = device.get();
  return OpenDevice{.device = std::move(device), .rate = rate};
}

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
  const HidFamily* family = nullptr;               // of a HID device
  std::span<const hid::HidId> (*usb)() = nullptr;  // of one that speaks USB without HID
  std::uint32_t stop_buttons = 0, go_buttons = 0;
  bool in_hand = false;   // a person holds it
  bool table = false;     // content/devices has its figures
  bool vibrates = false;  // beside another device, too
  bool senses = false;    // where another device is held, beside that one alone
  bool motors = false;    // it pushes back
};

Result<OpenDevice> open_simulated(const std::string& /*model*/, const DeviceOrder& order) {
  Result<std::unique_ptr<Device>> device = order.simulated();
  if (!device) return device.error();
  return OpenDevice{.device = std::move(*device)};
}

Result<OpenDevice> open_replay(const std::string& file, const DeviceOrder& order) {
  Result<std::unique_ptr<Device>> device = order.replay(file);
  if (!device) return device.error();
  return OpenDevice{.device = std::move(*device)};
}

Result<OpenDevice> open_mouse(const std::string& /*argument*/, const DeviceOrder& order) {
  auto device = std::make_unique<MouseDevice>(order.desc, order.X_DH, order.tick_s);
  MouseDevice* const mouse = device.get();
  return OpenDevice{.device = std::move(device), .mouse = mouse};
}

Result<OpenDevice> open_keyboard(const std::string& /*argument*/, const DeviceOrder& order) {
  auto keys = std::make_shared<KeyAxes>();
  OpenDevice opened = by_axes(keys, order);
  opened.keys = std::move(keys);
  return opened;
}

template <auto kAxes>
Result<OpenDevice> open_axes(const std::string& /*argument*/, const DeviceOrder& order) {
  Result<std::shared_ptr<AxesSource>> axes = kAxes(order.signal.value_or(VibrotactileSignal()));
  if (!axes) return axes.error();
  return by_axes(std::move(*axes), order);
}

std::unique_ptr<hid::HidPort> port_of(const HidFamily& family) {
  const Result<HidPlace> place = place_of(family);
  if (!place) return nullptr;
  Result<std::unique_ptr<hid::HidPort>> port = hid::open_hid(*place);
  return port ? std::move(*port) : nullptr;
}

// Bus: of a device with motors that speaks HID, made of a port and the device's figures.
template <const HidFamily& kFamily, class Bus>
Result<OpenDevice> open_hid_force(const std::string& /*argument*/, const DeviceOrder& order) {
  const Result<HidPlace> place = place_of(kFamily);
  if (!place) return place.error();
  Result<std::unique_ptr<hid::HidPort>> port = hid::open_hid(*place);
  if (!port) return port.error();
  const auto again = [desc = order.desc]() -> std::unique_ptr<ForceBus> {
    std::unique_ptr<hid::HidPort> found = port_of(kFamily);
    return found ? std::make_unique<Bus>(std::move(found), desc) : nullptr;
  };
  Result<std::unique_ptr<ForceDevice>> device =
      ForceDevice::start(order.desc, std::make_unique<Bus>(std::move(*port), order.desc), again);
  if (!device) return device.error();
  return OpenDevice{.device = std::move(*device)};
}

// Bus: of a device with motors that finds its device itself, or whose maker's library or service does.
template <class Bus>
Result<OpenDevice> open_force(const std::string& /*argument*/, const DeviceOrder& order) {
  Result<std::unique_ptr<Bus>> bus = Bus::open();
  if (!bus) return bus.error();
  const auto again = []() -> std::unique_ptr<ForceBus> {
    Result<std::unique_ptr<Bus>> found = Bus::open();
    return found ? std::move(*found) : nullptr;
  };
  Result<std::unique_ptr<ForceDevice>> device = ForceDevice::start(order.desc, std::move(*bus), again);
  if (!device) return device.error();
  return OpenDevice{.device = std::move(*device)};
}

std::string why_no_omega(const std::string& /*no_window_reason*/) {
  return dhd::why_no_omega();
}
std::string why_no_touch(const std::string& /*no_window_reason*/) {
  return hd::why_no_touch();
}
std::string why_no_falcon(const std::string& /*no_window_reason*/) {
  return falcon::why_no_falcon();
}
std::string why_no_inverse3(const std::string& /*no_window_reason*/) {
  return inverse3::why_no_inverse3();
}

Result<sound::SoundPlace> named_sound(const std::string& pcm) {
  return pcm.empty() ? sound::SoundPlace{} : sound::SoundPlace{.pcm = pcm};
}
Result<sound::SoundPlace> sound_of_dualsense(const std::string& /*argument*/) {
  return sound::dualsense_coils();
}

std::string why_no_sound(const Result<sound::SoundPlace>& place) {
  if (!place) return place.error().sentence;
  const Result<std::unique_ptr<sound::Pcm>> pcm = sound::open_alsa(*place, 2, sound::kRate_Hz / 10);
  return pcm ? "" : pcm.error().sentence;
}
std::string why_no_default_sound(const std::string& /*no_window_reason*/) {
  return why_no_sound(named_sound(""));
}
std::string why_no_coils(const std::string& /*no_window_reason*/) {
  return why_no_sound(sound::dualsense_coils());
}

// Those in a hand in the order in which one is taken where none is asked for.
constexpr Driver kDrivers[] = {
    {"simulated", "simulated", "a 6/3-DOF device in a simulated hand, for runs without a person", &always,
     &open_simulated},
    {"simulated", "simulated:MODEL",
     "the same with the figures of another device: content/devices/MODEL.yaml", &always, &open_simulated},
    {"replay", "replay:FILE", "the handle motion of a recorded tape or trace.csv", &always, &open_replay},
    {.name = "polhem",
     .shown = "polhem",
     .what = "a Polhem (WoodenHaptics): six axes by its arm and stylus; pushes on three",
     .why_not = &why_no_hid<kPolhem>,
     .open = &open_hid_force<kPolhem, polhem::PolhemBus>,
     .family = &kPolhem,
     .in_hand = true,
     .table = true,
     .motors = true},
    {.name = "omega6",
     .shown = "omega6",
     .what = "a Force Dimension omega.6: six axes, pushes on three; by its maker's library",
     .why_not = &why_no_omega,
     .open = &open_force<dhd::OmegaBus>,
     .in_hand = true,
     .table = true,
     .motors = true},
    {.name = "touch",
     .shown = "touch",
     .what = "a 3D Systems Touch: six axes, pushes on three; by its maker's library",
     .why_not = &why_no_touch,
     .open = &open_force<hd::TouchBus>,
     .in_hand = true,
     .table = true,
     .motors = true},
    {.name = "falcon",
     .shown = "falcon",
     .what = "a Novint Falcon: where its grip is, and pushes on three axes; with its maker's firmware",
     .why_not = &why_no_falcon,
     .open = &open_force<falcon::FalconBus>,
     .usb = &falcon::usb_ids,
     .in_hand = true,
     .table = true,
     .motors = true},
    {.name = "inverse3",
     .shown = "inverse3",
     .what = "a Haply Inverse3: six axes with a VerseGrip, three without; pushes on three; by its maker's "
             "service",
     .why_not = &why_no_inverse3,
     .open = &open_force<inverse3::Inverse3Bus>,
     .in_hand = true,
     .table = true,
     .motors = true},
    {.name = "spacemouse",
     .shown = "spacemouse",
     .what = "a 3Dconnexion SpaceMouse: six axes by its cap, no force",
     .why_not = &why_no_hid<kSpaceMouse>,
     .open = &open_axes<&hid_axes<kSpaceMouse>>,
     .axes = &hid_axes<kSpaceMouse>,
     .family = &kSpaceMouse,
     .in_hand = true,
     .table = true},
    {.name = "dualsense",
     .shown = "dualsense",
     .what = "a Sony DualSense: six axes by its sticks; vibrates left and right, no force",
     .why_not = &why_no_hid<kDualSense>,
     .open = &open_axes<&hid_axes<kDualSense>>,
     .axes = &hid_axes<kDualSense>,
     .family = &kDualSense,
     .stop_buttons = sony::kShare,
     .go_buttons = sony::kOptions,
     .in_hand = true,
     .table = true,
     .vibrates = true},
    {.name = "dualshock4",
     .shown = "dualshock4",
     .what = "a Sony DualShock 4: six axes by its sticks; vibrates left and right, no force",
     .why_not = &why_no_hid<kDualShock4>,
     .open = &open_axes<&hid_axes<kDualShock4>>,
     .axes = &hid_axes<kDualShock4>,
     .family = &kDualShock4,
     .stop_buttons = sony::kShare,
     .go_buttons = sony::kOptions,
     .in_hand = true,
     .table = true,
     .vibrates = true},
    {.name = "joycon",
     .shown = "joycon",
     .what = "a pair of Nintendo Joy-Cons: six axes by their sticks; vibrates left and right, no force",
     .why_not = &why_no_joycons,
     .open = &open_axes<&joycon_axes>,
     .axes = &joycon_axes,
     .family = &kJoyConPair,
     .stop_buttons = joycon::kMinus,
     .go_buttons = joycon::kPlus,
     .in_hand = true,
     .table = true,
     .vibrates = true},
    {.name = "switch_pro",
     .shown = "switch_pro",
     .what = "a Nintendo Pro Controller: six axes by its sticks; vibrates left and right, no force",
     .why_not = &why_no_hid<kJoyCon<joycon::Side::both>>,
     .open = &open_axes<&hid_axes<kJoyCon<joycon::Side::both>>>,
     .axes = &hid_axes<kJoyCon<joycon::Side::both>>,
     .family = &kJoyCon<joycon::Side::both>,
     .stop_buttons = joycon::kMinus,
     .go_buttons = joycon::kPlus,
     .in_hand = true,
     .table = true,
     .vibrates = true},
    {.name = "strip",
     .shown = "strip",
     .what = "a strip that knows where a stick is held, beside another device: polhem+strip",
     .why_not = &why_no_hid<kStrip>,
     .open = &open_hid_force<kStrip, strip::StripBus>,
     .family = &kStrip,
     .table = true,
     .senses = true},
    {.name = "mouse",
     .shown = "mouse",
     .what = "six axes by dragging, in a window; no force",
     .why_not = &in_window,
     .open = &open_mouse,
     .in_hand = true},
    {.name = "keyboard",
     .shown = "keyboard",
     .what = "six axes by keys, in a window; no force",
     .why_not = &in_window,
     .open = &open_keyboard,
     .in_hand = true,
     .table = true},
    {.name = "audio",
     .shown = "audio",
     .what = "voice coils on a sound card, left and right, beside another device: mouse+audio",
     .why_not = &why_no_default_sound,
     .plays = &named_sound,
     .table = true,
     .vibrates = true},
    {.name = "audio",
     .shown = "audio:PCM",
     .what = "the same on another PCM of ALSA, such as mouse+audio:hw:1,0",
     .why_not = &always,
     .plays = &named_sound,
     .table = true,
     .vibrates = true},
    {.name = "dualsense_coils",
     .shown = "dualsense_coils",
     .what = "a DualSense's own voice coils, by USB, beside another device: dualsense+dualsense_coils",
     .why_not = &why_no_coils,
     .plays = &sound_of_dualsense,
     .table = true,
     .vibrates = true},
};

// What follows a colon belongs to those alone that say so.
const Driver* driver_of(std::string_view name) {
  const std::size_t colon = name.find(':');
  const auto is_named = [&](const Driver& driver) {
    const bool takes_more = driver.shown != driver.name;
    return driver.name == name.substr(0, colon) && takes_more == (colon != std::string_view::npos);
  };
  const auto found = std::ranges::find_if(kDrivers, is_named);
  return found == std::end(kDrivers) ? nullptr : &*found;
}

std::string argument_of(const std::string& part) {
  const auto colon = part.find(':');
  return colon == std::string::npos ? "" : part.substr(colon + 1);
}

// A simulated hand holds none of the devices that a person does, and may feel what vibrates beside; its strip
// is simulated with it.
bool takes_beside(const Driver& moves, const Driver& beside) {
  return moves.in_hand || (moves.open == &open_simulated && beside.vibrates);
}

// One that is named is asked for by its name.
std::string why_not_part(const std::string& part, const std::string& no_window_reason) {
  const Driver* const driver = driver_of(part);
  if (driver == nullptr) return "";
  const std::string argument = argument_of(part);
  const bool named_sound = driver->plays != nullptr && !argument.empty();
  return named_sound ? why_no_sound(driver->plays(argument)) : driver->why_not(no_window_reason);
}

std::string names_where(bool (*counts)(const Driver&)) {
  std::string names;
  for (const Driver& driver : kDrivers)
    if (counts(driver)) names += (names.empty() ? "" : ", ") + std::string(driver.shown);
  return names;
}

Error cannot_be_had(const std::string& name, const std::string& why) {
  std::string sentence = "The device '";
  sentence.append(name).append("' cannot be had: ").append(why);
  return Error{std::move(sentence)};
}

DeviceListing listing_of(const Driver& driver, const std::string& no_window_reason) {
  DeviceListing listing{.name = std::string(driver.shown), .what = std::string(driver.what)};
  if (driver.table) listing.table = driver.name;
  listing.reason = driver.why_not(no_window_reason);
  if (driver.family != nullptr) {
    if (const std::optional<HidPlace> place = found(*driver.family)) {
      listing.node = place->path;
      listing.permitted = place->permitted;
      listing.firmware = version_text(place->release);
    }
  }
  listing.present = listing.reason.empty();
  return listing;
}

}  // namespace

std::vector<DeviceListing> list_devices(const std::string& no_window_reason) {
  std::vector<DeviceListing> listings;
  for (const Driver& driver : kDrivers) listings.push_back(listing_of(driver, no_window_reason));
  return listings;
}

DeviceListing best_device(const std::string& no_window_reason) {
  for (const Driver& driver : kDrivers) {
    if (!driver.in_hand) continue;
    DeviceListing listing = listing_of(driver, no_window_reason);
    if (listing.present || driver.name == "mouse") return listing;
  }
  return {};
}

namespace {

// Its numbers on USB; none of a device that a maker's library finds.
std::span<const hid::HidId> ids_of(const Driver& driver) {
  if (driver.usb != nullptr) return driver.usb();
  if (driver.family != nullptr) return driver.family->ids();
  return {};
}

std::string usb_rule(const hid::HidId& id) {
  char rule[160];
  std::snprintf(rule, sizeof rule,
                "SUBSYSTEM==\"usb\", ENV{DEVTYPE}==\"usb_device\", ATTR{idVendor}==\"%04x\", "
                "ATTR{idProduct}==\"%04x\", MODE=\"0660\", TAG+=\"uaccess\"\n",
                id.vendor, id.product);
  return rule;
}

// A node of hidraw by USB has the numbers of the device above it; by Bluetooth they are in that one's name.
std::string hid_rules(const hid::HidId& id) {
  char rules[240];
  std::snprintf(rules, sizeof rules,
                "KERNEL==\"hidraw*\", ATTRS{idVendor}==\"%04x\", ATTRS{idProduct}==\"%04x\", "
                "MODE=\"0660\", TAG+=\"uaccess\"\n"
                "KERNEL==\"hidraw*\", KERNELS==\"0005:%04X:%04X.*\", MODE=\"0660\", TAG+=\"uaccess\"\n",
                id.vendor, id.product, id.vendor, id.product);
  return rules;
}

}  // namespace

std::string udev_rules() {
  std::string rules =
      "# Devices that Fulcrum opens: the person at the seat may. Written by `fulcrum devices --udev`.\n";
  for (const Driver& driver : kDrivers) {
    if (ids_of(driver).empty()) continue;
    rules += "\n# " + std::string(driver.what) + "\n";
    for (const hid::HidId& id : ids_of(driver)) rules += driver.usb != nullptr ? usb_rule(id) : hid_rules(id);
  }
  return rules;
}

bool knows_usb(std::uint16_t vendor, std::uint16_t product) {
  return std::ranges::any_of(
      kDrivers,
      [&](const Driver& driver) {
        const std::span<const hid::HidId> ids = ids_of(driver);
        return std::ranges::find(ids, hid::HidId{vendor, product}) != ids.end();
      });
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

std::optional<Error> refuse_device(const std::string& name, const std::string& no_window_reason,
                                   bool by_clock) {
  const Result<DeviceName> parts = read_device_name(name);
  if (!parts) return parts.error();
  for (const std::string& part : {parts->moves, parts->beside}) {
    const std::string reason = why_not_part(part, no_window_reason);
    if (!reason.empty()) return cannot_be_had(part, reason);
  }
  if (driver_of(parts->moves)->in_hand && !no_window_reason.empty() && !by_clock)
    return Error{
        "The device '" + name +
        "' is in a hand, which cannot keep up with ticks that come as fast as they can: add --realtime."};
  if (!parts->beside.empty() && !no_window_reason.empty() && !by_clock)
    return Error{"'" + parts->beside +
                 "' vibrates by the clock, and cannot keep up with ticks that come as fast as they can: add "
                 "--realtime."};
  return std::nullopt;
}

bool moves_as_seen(const std::string& name) {
  const Driver* const driver = driver_of(name.substr(0, name.find('+')));
  return driver != nullptr && driver->in_hand && !driver->motors;
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
  return driver != nullptr && driver->open == &open_simulated;
}

bool plays_sound(const std::string& name) {
  const Result<DeviceName> parts = read_device_name(name);
  const Driver* const beside = parts ? driver_of(parts->beside) : nullptr;
  return beside != nullptr && beside->plays != nullptr;
}

namespace {

Result<OpenDevice> open_alone(const Driver& moves, const std::string& argument, const DeviceOrder& order) {
  Result<OpenDevice> opened = moves.open(argument, order);
  if (opened || !moves.in_hand) return opened;
  return cannot_be_had(std::string(moves.name), opened.error().sentence);
}

// by: what vibrates; it may be what moves, which has one link for both then.
Result<OpenDevice> open_vibrating(const Driver& moves, const std::string& argument, const Driver& by,
                                  const DeviceOrder& order) {
  Result<std::shared_ptr<AxesSource>> channels = by.axes(*order.signal);
  if (!channels) return cannot_be_had(std::string(by.name), channels.error().sentence);
  Result<OpenDevice> opened =
      &by == &moves ? Result<OpenDevice>(by_axes(*channels, order)) : open_alone(moves, argument, order);
  if (!opened) return opened;
  opened->device = std::make_unique<VibratingDevice>(
      std::move(opened->device), std::make_unique<RumblingPad>(std::move(*channels), *order.desc.vibrotactile,
                                                               *order.signal, order.tick_s));
  return opened;
}

// Nothing of sound is built where nothing drives the channels.
Result<OpenDevice> open_with_sound(const DeviceName& parts, const DeviceOrder& order) {
  Result<OpenDevice> opened = open_alone(*driver_of(parts.moves), argument_of(parts.moves), order);
  if (!opened || !order.signal || !order.desc.vibrotactile) return opened;
  const Result<sound::SoundPlace> place = driver_of(parts.beside)->plays(argument_of(parts.beside));
  if (!place) return cannot_be_had(parts.beside, place.error().sentence);
  Result<std::unique_ptr<sound::SoundLink>> link =
      sound::open_sound(*place, *order.desc.vibrotactile, *order.signal, order.tick_s);
  if (!link) return cannot_be_had(parts.beside, link.error().sentence);
  opened->sound = link->get();
  opened->device = std::make_unique<VibratingDevice>(std::move(opened->device), std::move(*link));
  return opened;
}

Result<OpenDevice> open_parts(const DeviceName& parts, const DeviceOrder& order) {
  const Driver& moves = *driver_of(parts.moves);
  const std::string argument = argument_of(parts.moves);
  if (!parts.beside.empty() && driver_of(parts.beside)->plays != nullptr)
    return open_with_sound(parts, order);
  const Driver& beside = parts.beside.empty() ? moves : *driver_of(parts.beside);
  const Driver& vibrating = beside.vibrates ? beside : moves;
  const bool vibrates = vibrating.vibrates && order.signal && order.desc.vibrotactile;
  Result<OpenDevice> opened =
      vibrates ? open_vibrating(moves, argument, vibrating, order) : open_alone(moves, argument, order);
  if (!opened || !beside.senses) return opened;
  Result<OpenDevice> strip = beside.open("", order);
  if (!strip) return cannot_be_had(parts.beside, strip.error().sentence);
  opened->device = std::make_unique<strip::StripDevice>(std::move(opened->device), std::move(strip->device));
  return opened;
}

}  // namespace

Result<OpenDevice> open_device(const std::string& name, const DeviceOrder& order) {
  const Result<DeviceName> parts = read_device_name(name);
  if (!parts) return parts.error();
  Result<OpenDevice> opened = open_parts(*parts, order);
  if (!opened) return opened;
  const Driver& moves = *driver_of(parts->moves);
  opened->stop_buttons = moves.stop_buttons;
  opened->go_buttons = moves.go_buttons;
  return opened;
}

}  // namespace fulcrum
