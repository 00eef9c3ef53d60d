#pragma once
// What an effect may do in a tick. One of these is built for each effect that a scene names and its device
// can use; another costs no instruction. A program may give a World effects of its own besides
// (examples/own_effect.cpp).
//
// May: change its own state. Must not: allocate, lock, read a clock, throw, keep a pointer into the tick.
// What it wants goes through every limit that the device has; none of that can be seen or changed from here.

#include <cstdint>
#include <optional>

#include "haptics/device/device.h"
#include "haptics/safety/rendered.h"
#include "haptics/scene/built_part.h"
#include "haptics/tick/command.h"
#include "haptics/tick/effect_tick.h"
#include "haptics/tick/knob.h"
#include "haptics/tick/transient.h"

namespace fulcrum {

struct EffectRecords;

// What is to happen once a tick's wrench is known.
struct Settled {
  // Of correct(), what was commanded: its energy is on an account of the effect's own, and the passivity
  // observer leaves it out. Not of an effect from outside haptics/effects: the observer counts all that it
  // does.
  Wrench correction_F_H_D;
  std::optional<double> torque_limit{};  // N m, of the coupling from the next tick on
  std::uint32_t faults = 0;              // bits of limits that the effect has applied
  // J at the device, in springs of shape() that are the effect's own: they can give it back. Not of an effect
  // from outside, either.
  double stored = 0;
};

class Effect {
public:
  virtual ~Effect() = default;

  // A command of the main thread; most are for others.
  virtual void apply(const Command&) noexcept {}
  // A continuous wrench on the handle about H, in D, part of what the hand should feel. One that is known in
  // W goes through MappingDesc::wrench_in_device(), of the scene that the effect was built for. It is asked
  // while the clutch is pressed, too (handle.engaged), and on a device that renders no torque.
  virtual Wrench shape(const EffectTick&) noexcept { return {}; }
  // A continuous wrench on the handle about H, in D, that makes up for what the device itself does to the
  // hand.
  virtual Wrench correct(const EffectTick&) noexcept { return {}; }
  // A wrench that no slew limit slows down, bounded by its source's budget. A World has budgets for those
  // sources alone that the effects of its scene ask for: without one nothing is sent, and the tick has
  // kTransientLimited.
  virtual std::optional<Transient> strike(const EffectTick&) noexcept { return std::nullopt; }
  // What guard and motors left of it all.
  virtual Settled settle(const EffectTick&, const Rendered&) noexcept { return {}; }
  // What the device does beside the wrench: channels, cues. gain: of ramp and stop, 0 to 1.
  virtual void command(const EffectTick&, double /*gain*/, bool /*stopped*/, DeviceCommand&) noexcept {}
  // What the tick leaves behind of it: the same values in every tick, and before the first, when the trace's
  // columns are named.
  virtual void record(EffectRecords& records) const noexcept = 0;
  // What it is made of, with its parameters in words.
  virtual BuiltPart part() const = 0;
};

}  // namespace fulcrum
