#pragma once
// Piping as the program prepares it, once for all tests of a program.

#include <stdexcept>

#include "engine/app/prepare.h"
#include "haptics/loop/run_tick.h"

namespace fulcrum::test {

inline const app::Prepared& piping() {
  static const std::optional<app::Prepared> prepared = app::prepare("piping", std::vector<std::string>{});
  if (!prepared) throw std::runtime_error("piping could not be prepared");
  return *prepared;
}

// A run of piping in a simulated hand, tick by tick.
struct PipingRun {
  explicit PipingRun(const std::string& hand) {
    Result<World> built = World::build(piping().haptic.scene);
    if (!built) throw std::runtime_error(built.error().sentence);
    world.emplace(std::move(*built));
    auto made = app::simulated_device(piping(), hand);
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
