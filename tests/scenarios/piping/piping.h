#pragma once
// Piping as the program prepares it, once for all tests of a program.

#include <stdexcept>

#include "engine/app/prepare/prepare.h"
#include "haptics/loop/run_tick.h"

namespace fulcrum::test {

inline app::Prepared prepared_piping(const std::vector<std::string>& overrides) {
  std::optional<app::Prepared> prepared = app::prepare("piping", overrides);
  if (!prepared) throw std::runtime_error("piping could not be prepared");
  return std::move(*prepared);
}

inline const app::Prepared& piping() {
  static const app::Prepared prepared = prepared_piping({});
  return prepared;
}

inline const app::Prepared& piping_on_springs() {
  static const app::Prepared prepared = prepared_piping({"response=penalty"});
  return prepared;
}

// A run of piping in a simulated hand, tick by tick.
struct PipingRun {
  explicit PipingRun(const std::string& hand, const app::Prepared& prepared = piping()) {
    Result<World> built = World::build(prepared.haptic.scene);
    if (!built) throw std::runtime_error(built.error().sentence);
    world.emplace(std::move(*built));
    auto made = app::simulated_device(prepared, hand);
    if (!made) throw std::runtime_error(made.error().sentence);
    device = std::move(*made);
  }
  TickRecord tick() {
    run_tick(*world, *device, {}, event);
    return event.record;
  }

  std::optional<World> world;
  std::unique_ptr<SimulatedDevice> device;
  TickEvent event;
};

}  // namespace fulcrum::test
