#include <utility>

#include "drivers/driver.h"
#include "drivers/openers.h"
#include "drivers/sound/sound.h"
#include "drivers/strip/strip_device.h"
#include "drivers/vibrating/rumbling_pad.h"
#include "drivers/vibrating/vibrating_device.h"

namespace fulcrum {
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

// They have one link to the headset, whichever of the two parts they are.
Result<OpenDevice> open_with_controllers(const Driver& moves, const std::string& argument,
                                         const DeviceOrder& order) {
  Result<OpenDevice> opened = open_alone(moves, argument, order);
  if (!opened) return opened;
  if (opened->controllers == nullptr)
    opened->controllers = std::make_shared<Controllers>(order.signal->carrier_Hz);
  opened->device = std::make_unique<VibratingDevice>(
      std::move(opened->device), std::make_unique<RumblingPad>(opened->controllers, *order.desc.vibrotactile,
                                                               *order.signal, order.tick_s));
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
  Result<OpenDevice> opened = !vibrates              ? open_alone(moves, argument, order)
                              : vibrating.by_headset ? open_with_controllers(moves, argument, order)
                                                     : open_vibrating(moves, argument, vibrating, order);
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
