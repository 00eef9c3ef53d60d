// Teeth in its clumsy hand, which trembles on the border of an encoder's count: the observer reads
// millijoules below the truth there. By the true way of the simulated handle, which the encoders do not tell,
// the loop gives out no more than a tenth of a millijoule, and the observer is on the safe side.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "engine/app/prepare/prepare.h"
#include "haptics/loop/run_tick.h"
#include "haptics/math/rotation.h"

namespace fulcrum::test {
namespace {

constexpr double kBound = 1e-4;  // J

struct Port {
  double least_truth = 0, least_read = 0, above_truth = 0;  // J
};

// The work of the force that is held from tick to tick, and what the tool's weight has stored of it.
Port run(const app::Prepared& prepared, const std::string& hand) {
  const SceneDesc& scene = prepared.haptic.scene;
  Result<World> world = World::build(scene);
  const auto device = app::simulated_device(prepared, hand);
  Port port;
  double work = 0;
  Pose X_DH = (*device)->X_DH();
  TickEvent event;
  run_tick(*world, **device, {}, event);
  const double start = event.record.X_WT.p.y();
  const auto ticks = static_cast<std::int64_t>(prepared.scenario.time_limit / scene.tick_s);
  for (std::int64_t tick = 1; tick < ticks; ++tick) {
    run_tick(*world, **device, {}, event);
    const Wrench& held = world->continuous_F_H_D();
    const Pose now = (*device)->X_DH();
    work -= held.force.dot(now.p - X_DH.p) + held.torque.dot(rotation_vector(now.q * X_DH.q.conjugate()));
    X_DH = now;
    const double stored =
        scene.mapping.energy_scale() * tool_weight(scene.tool) * (event.record.X_WT.p.y() - start);
    const double truth = work - stored;
    port.least_truth = std::min(port.least_truth, truth);
    port.least_read = std::min(port.least_read, event.record.energy_port);
    port.above_truth = std::max(port.above_truth, event.record.energy_port - truth);
  }
  return port;
}

TEST(PortEnergy, TeethsClumsyHandIsGivenNothing) {
  const std::optional<app::Prepared> prepared = app::prepare("teeth", std::vector<std::string>{});
  ASSERT_TRUE(prepared);
  const Port port = run(*prepared, "clumsy");
  std::printf("least %.3g J, read %.3g J, above the truth by %.3g J\n", port.least_truth, port.least_read,
              port.above_truth);
  EXPECT_GT(port.least_truth, -kBound);
  EXPECT_LT(port.above_truth, kBound);
}

}  // namespace
}  // namespace fulcrum::test
