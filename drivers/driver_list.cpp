#include <algorithm>
#include <iterator>
#include <utility>

#include "drivers/controller/controller_device.h"
#include "drivers/driver.h"
#include "drivers/dualsense/dualsense_protocol.h"
#include "drivers/dualshock4/dualshock4_protocol.h"
#include "drivers/falcon/falcon_bus.h"
#include "drivers/gamepad/find_gamepads.h"
#include "drivers/inverse3/inverse3_bus.h"
#include "drivers/joycon/joycon_pair.h"
#include "drivers/joycon/joycon_protocol.h"
#include "drivers/omega/omega_bus.h"
#include "drivers/openers.h"
#include "drivers/polhem/polhem_bus.h"
#include "drivers/sony/pad_axes.h"
#include "drivers/sound/sound.h"
#include "drivers/spacemouse/spacemouse_protocol.h"
#include "drivers/strip/strip_bus.h"
#include "drivers/touch/touch_bus.h"
#include "haptics/device/hand.h"

namespace fulcrum {
namespace {

sony::Link link_of(const hid::HidPlace& place) {
  return place.bluetooth ? sony::Link::bluetooth : sony::Link::usb;
}

constexpr hid::HidFamily kSpaceMouse{
    &spacemouse_ids,
    [](const hid::HidPlace&, const VibrotactileSignal&) -> std::unique_ptr<hid::HidProtocol> {
      return std::make_unique<SpaceMouseProtocol>();
    }};
constexpr hid::HidFamily kDualSense{
    &dualsense::usb_ids,
    [](const hid::HidPlace& place, const VibrotactileSignal&) -> std::unique_ptr<hid::HidProtocol> {
      return std::make_unique<dualsense::DualSenseProtocol>(link_of(place));
    }};
constexpr hid::HidFamily kDualShock4{
    &dualshock4::usb_ids,
    [](const hid::HidPlace& place, const VibrotactileSignal&) -> std::unique_ptr<hid::HidProtocol> {
      return std::make_unique<dualshock4::DualShock4Protocol>(link_of(place));
    }};

template <joycon::Side kSide>
std::unique_ptr<hid::HidProtocol> joycon_protocol(const hid::HidPlace&, const VibrotactileSignal& signal) {
  return std::make_unique<joycon::JoyConProtocol>(kSide, signal.carrier_Hz);
}
template <joycon::Side kSide>
constexpr hid::HidFamily kJoyCon{[] { return joycon::ids(kSide); }, &joycon_protocol<kSide>};
constexpr hid::HidFamily kJoyConPair{.ids = &joycon::pair_ids};  // each half has a node of its own

constexpr hid::HidFamily kStrip{
    .ids = &strip::usb_ids, .nodes = hid::Nodes::of_vendor, .product = strip::kProduct};
constexpr hid::HidFamily kPolhem{.ids = &polhem::usb_ids, .nodes = hid::Nodes::all};

// One half alone has neither six axes nor two channels.
std::string why_no_joycons(const std::string& no_window_reason) {
  const auto why_not = [](const char* half, const hid::HidFamily& family, std::string reason) {
    if (reason.empty() || !hid::find_hid(family.ids()).empty()) return reason;
    return std::string(half) +
           " is not paired and awake, and both halves are needed: hold the button between its SL and SR "
           "until its lights run, pair it by Bluetooth, then press one of its keys.";
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

// s. A headset's runtime tells where a hand will be when the picture is seen, 20 to 40 ms ahead: following
// takes a part of that, and none of it is felt. Cameras see a hand without a controller as seldom as every
// 33 ms, and a lag of half of that makes one motion of their steps.
constexpr double kControllerLag = 8e-3, kTrackedHandLag = 16e-3;

template <const double& kLag>
Result<OpenDevice> open_in_headset(const std::string& /*argument*/, const DeviceOrder& order) {
  auto controllers = std::make_shared<Controllers>(order.signal.value_or(VibrotactileSignal()).carrier_Hz);
  auto device = std::make_unique<ControllerDevice>(order.desc, controllers, order.X_DH, kLag, order.tick_s);
  return OpenDevice{.device = std::move(device), .controllers = std::move(controllers)};
}

std::string why_no_gamepad_here(const std::string& no_window_reason) {
  return no_window_reason.empty() ? why_no_gamepad() : no_window_reason;
}

Result<OpenDevice> open_gamepad(const std::string& /*argument*/, const DeviceOrder& order) {
  auto gamepad = std::make_shared<GamepadAxes>();
  OpenDevice opened = by_axes(gamepad, order);
  opened.gamepad = std::move(gamepad);
  return opened;
}

std::string why_no_controller(const std::string& /*no_window_reason*/) {
  return "it is there while a headset shows a scene: fulcrum run SCENE --xr (docs/headset.md).";
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

std::string why_no_default_sound(const std::string& /*no_window_reason*/) {
  return sound::why_no_sound(named_sound(""));
}
std::string why_no_coils(const std::string& /*no_window_reason*/) {
  return sound::why_no_sound(sound::dualsense_coils());
}

constexpr DeviceWords kOfController{.move = "squeeze to take the tool, and move your hand",
                                    .turn = "turn your hand",
                                    .finely = "move it slowly",
                                    .stop = "press menu, Y or B",
                                    .go_on = "squeeze to take the tool"};
constexpr DeviceWords kOfTrackedHand{.move = "pinch to take the tool, and move your hand",
                                     .turn = "turn your hand",
                                     .finely = "move it slowly",
                                     .stop = "touch your thumb with your little finger",
                                     .go_on = "pinch to take the tool"};
constexpr DeviceWords kOfGrip{.move = "move the grip", .turn = "turn the grip"};
constexpr DeviceWords kOfFixedGrip{.move = "move the grip", .turn = "this device cannot turn it"};
constexpr DeviceWords kOfCap{.move = "push the cap", .turn = "turn the cap", .finely = "push it gently"};
constexpr DeviceWords kOfSonyPad{.move = "left stick, and R2 and L2 away and nearer",
                                 .turn = "right stick, and L1 and R1 roll",
                                 .finely = "push a stick a little",
                                 .stop = "press Share",
                                 .go_on = "press Options"};
constexpr DeviceWords kOfNintendoPad{.move = "left stick, and ZR and ZL away and nearer",
                                     .turn = "right stick, and L and R roll",
                                     .finely = "push a stick a little",
                                     .stop = "press minus",
                                     .go_on = "press plus"};
constexpr DeviceWords kOfMouse{.move = "drag with the left button, and the wheel goes away and nearer",
                               .turn = "drag with the right button, and with Shift it rolls",
                               .finely = "with Shift the wheel goes in small steps"};
constexpr DeviceWords kOfKeys{.move = "arrows, Page Up and Page Down",
                              .turn = "keys W, S, A, D, Q and E",
                              .finely = "with Shift it goes slowly"};

constexpr Driver kDrivers[] = {
    {.name = "simulated",
     .shown = "simulated",
     .what = "a 6/3-DOF device in a simulated hand, for runs without a person",
     .why_not = &always,
     .open = &open_simulated,
     .stop_buttons = kHandStopButton,
     .go_buttons = kHandGoButton,
     .simulated = true},
    {.name = "simulated",
     .shown = "simulated:MODEL",
     .what = "the same with the figures of another device: content/devices/MODEL.yaml",
     .why_not = &always,
     .open = &open_simulated,
     .stop_buttons = kHandStopButton,
     .go_buttons = kHandGoButton,
     .simulated = true},
    {.name = "replay",
     .shown = "replay:FILE",
     .what = "the handle motion of a recorded tape or trace.csv",
     .why_not = &always,
     .open = &open_replay},
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
     .open = &open_own_force<falcon::FalconBus>,
     .usb = &falcon::usb_ids,
     .words = kOfFixedGrip,
     .in_hand = true,
     .table = true,
     .motors = true},
    {.name = "inverse3",
     .shown = "inverse3",
     .what = "a Haply Inverse3: six axes with a VerseGrip, three without; pushes on three; by its maker's "
             "service",
     .why_not = &why_no_inverse3,
     .open = &open_own_force<inverse3::Inverse3Bus>,
     .words = kOfGrip,
     .in_hand = true,
     .table = true,
     .motors = true,
     .by_service = true},
    {.name = "spacemouse",
     .shown = "spacemouse",
     .what = "a 3Dconnexion SpaceMouse: six axes by its cap, no force",
     .why_not = &why_no_hid<kSpaceMouse>,
     .open = &open_axes<&hid_axes<kSpaceMouse>>,
     .axes = &hid_axes<kSpaceMouse>,
     .family = &kSpaceMouse,
     .words = kOfCap,
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
     .words = kOfSonyPad,
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
     .words = kOfSonyPad,
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
     .words = kOfNintendoPad,
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
     .words = kOfNintendoPad,
     .in_hand = true,
     .table = true,
     .vibrates = true},
    {.name = "gamepad",
     .shown = "gamepad",
     .what = "an Xbox pad or one built like it: six axes by its sticks and triggers, in a window; no force",
     .why_not = &why_no_gamepad_here,
     .open = &open_gamepad,
     .in_hand = true,
     .in_window = true,
     .table = true},
    {.name = "controller",
     .shown = "controller",
     .what = "a headset's controllers: six axes by the hand, as they are held; they vibrate, no force",
     .why_not = &why_no_controller,
     .open = &open_in_headset<kControllerLag>,
     .words = kOfController,
     .in_hand = true,
     .table = true,
     .vibrates = true,
     .by_headset = true},
    {.name = "tracked_hand",
     .shown = "tracked_hand",
     .what = "a hand without a controller, as a headset's cameras see it: six axes, no force",
     .why_not = &why_no_controller,
     .open = &open_in_headset<kTrackedHandLag>,
     .words = kOfTrackedHand,
     .in_hand = true,
     .table = true,
     .by_headset = true,
     .tracks_hands = true},
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
     .words = kOfMouse,
     .in_hand = true,
     .in_window = true},
    {.name = "keyboard",
     .shown = "keyboard",
     .what = "six axes by keys, in a window; no force",
     .why_not = &in_window,
     .open = &open_keyboard,
     .words = kOfKeys,
     .in_hand = true,
     .in_window = true,
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

}  // namespace

std::span<const Driver> all_drivers() {
  return kDrivers;
}

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

}  // namespace fulcrum
