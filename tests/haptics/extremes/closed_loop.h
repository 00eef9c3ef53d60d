#pragma once
// A whole loop under an extreme: a World, the simulated device, a hand that presses. What came of it is
// judged in one way: nothing diverges; either the loop comes to rest, or safety bounds it and a fault says
// so.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "haptics/device/simulated_device.h"
#include "tests/haptics/scenes.h"

namespace fulcrum::test {

// Three points, 1 cm below the tool's centre, so that it can stand.
inline std::vector<Vec3> three_feet() {
  return {{0.02, -0.01, 0.02}, {-0.02, -0.01, 0.02}, {0, -0.01, -0.02}};
}

// A hand without tremor that goes from `from` to `to` in `travel` s and stays there.
inline HandTask hand_from_to(const Vec3& from, const Vec3& to, double travel) {
  HandTask task{.path = HandPath({Waypoint{{Quat::Identity(), from}, 0, 0.6},
                                  Waypoint{{Quat::Identity(), to}, travel, 0}}),
                .hand = {},
                .X_HT = {},
                .mapping = {}};
  task.hand.tremor = task.hand.tremor_rad = 0;
  return task;
}

struct Verdict {
  bool finite = true;
  double depth_max = 0;   // m, over all ticks
  double force_max = 0;   // N, commanded
  double late_tool = 0;   // m, how far the tool still moved in the last half second
  double late_force = 0;  // N, how far the commanded force still swung
  std::uint32_t faults = 0;
  TickRecord last;

  bool at_rest() const { return finite && late_tool < 60e-6 && late_force < 0.15; }  // some encoder counts
};

// between_ticks may play with the device: a stall, a lost sample.
using Mischief = std::function<DeviceSample(SimulatedDevice&, int tick)>;

inline Verdict run_closed_loop(SceneDesc scene, HandTask task, double seconds,
                               const Mischief& mischief = {}) {
  SimulatedDeviceDesc desc;
  desc.device = scene.device;
  desc.tick_s = scene.tick_s;
  task.mapping = scene.mapping;
  SimulatedDevice device(desc, std::move(task));
  const double tick_s = scene.tick_s;
  World world = expect(World::build(std::move(scene)));
  Verdict verdict;
  Vec3 least = Vec3::Constant(std::numeric_limits<double>::infinity()), most = -least;
  Vec3 least_F = least, most_F = most;
  const int ticks = static_cast<int>(std::lround(seconds / tick_s));
  for (int i = 0; i < ticks; ++i) {
    const DeviceSample sample = mischief ? mischief(device, i) : device.read();
    const StepResult result = step(world, sample, {});
    device.write(result.command);
    const TickRecord& record = result.record;
    verdict.finite = verdict.finite && record.X_WT.is_finite() && result.command.F_H_D.is_finite() &&
                     device.X_DH().is_finite();
    verdict.depth_max = std::max(verdict.depth_max, record.depth_max);
    verdict.force_max = std::max(verdict.force_max, result.command.F_H_D.force.norm());
    verdict.faults |= record.faults;
    verdict.last = record;
    if ((ticks - i) * tick_s <= 0.5) {
      least = least.cwiseMin(record.X_WT.p);
      most = most.cwiseMax(record.X_WT.p);
      least_F = least_F.cwiseMin(result.command.F_H_D.force);
      most_F = most_F.cwiseMax(result.command.F_H_D.force);
    }
  }
  verdict.late_tool = (most - least).norm();
  verdict.late_force = (most_F - least_F).norm();
  return verdict;
}

// What holds however a scene answers to touch. The responses themselves are named in every_response_test.cpp,
// once for all files of tests: a second instantiation would run each of them again.
class EveryResponse : public testing::TestWithParam<ContactResponse> {
public:
  static std::string name(const testing::TestParamInfo<ContactResponse>& info) {
    switch (info.param) {
      case ContactResponse::penalty:
        return "Penalty";
      case ContactResponse::voxel:
        return "Voxel";
      case ContactResponse::quasi_static:
        return "Static";
      case ContactResponse::constraint:
        return "Constraint";
      case ContactResponse::direct:
        return "Direct";
    }
    return "Unnamed";
  }

protected:
  static SceneDesc answering(SceneDesc scene) {
    scene.contact.response = GetParam();
    return scene;
  }
};
// All but the classic method: its depths come by the voxel, so it never quite rests.
class EveryResponseThatRests : public EveryResponse {};

// The floor scene, pressed 5 mm deep by the hand.
inline SceneDesc pressing_scene() {
  SceneDesc scene = floor_scene(three_feet(), 0.013);
  scene.integrator = Integrator::implicit_euler;
  return scene;
}

inline HandTask pressing_hand() {
  return hand_from_to({0, 0.013, 0}, {0, 0.005, 0}, 0.3);
}

}  // namespace fulcrum::test
