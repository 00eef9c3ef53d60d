#pragma once
// A simulated hand that yields to what it is told of torque: it turns the handle back.
//
// A model, not a finding about people. Its figures are chosen, and every result that comes of it says so: a
// hand that turns back because it is told to has less torque, by construction.
//
// What the hand perceives is `reaction` old: where the handle would have had to be turned to for the tool to
// be free. It turns there at gain times the level of the cue, about the handle, and stops where that is: it
// knows how far it has turned since. Vibration says that the turn is wrong and hardly which way to undo it,
// the ghost shows the way: with each bout of a cue the hand errs about the way by a new angle, normally
// distributed. What it undid comes back with a time constant when it perceives no cue: the hand goes on with
// what it meant to do.

#include <cstdint>
#include <vector>

#include "haptics/device/device.h"
#include "haptics/math/linear.h"
#include "haptics/math/split_mix.h"

namespace fulcrum {

struct YieldingDesc {
  double reaction = 0.25;  // s. Assumed: a single reaction to touch or sight takes 0.15 to 0.2 s, a choice
                           // more, as remembered from R. Kosinski, "A literature review on reaction time"
  double gain = 1;         // rad/s, how fast the hand turns back at a full cue
  double spread = 0.2;     // of reaction and gain from seed to seed: log-normal, those two the medians
  double full_vibration = 0.4;    // N, the amplitude that is a full cue; a ghost is one when it is opaque
  double least_vibration = 0.02;  // N, the amplitude below which nothing is felt
  double felt_error_rad = 0.5;    // rms, of the way under vibration alone
  double seen_error_rad = 0.1;    // rms, of the way where the ghost is seen
  double recovery = 2;            // s, time constant
};

class Yielding {
public:
  Yielding(const YieldingDesc& desc, double tick_s, std::uint64_t seed);

  // One tick: what the hand is told in it.
  void advance(const DeviceCommand::Cues& cues) noexcept;

  // What the hand adds to the turn of the handle that it meant to make, in D: now, and a tick ago.
  const Quat& turn() const { return turn_; }
  const Quat& turn_before() const { return turn_before_; }

private:
  struct Percept {
    double felt = 0, seen = 0;     // 0 to 1, of a full cue
    Quat goal = Quat::Identity();  // turn_, where the tool would be free
  };
  Percept percept_of(const DeviceCommand::Cues& cues) const noexcept;
  void turn_back(const Percept& percept) noexcept;
  void recover() noexcept;

  YieldingDesc desc_;
  double tick_s_;
  double kept_;  // of the turn, each tick without a cue
  SplitMix random_;
  double gain_;                    // rad/s, this hand's
  std::vector<Percept> percepts_;  // a ring: the newest to the one that is `reaction` old
  std::size_t at_ = 0;
  bool told_ = false;               // a cue is being perceived
  double error_ = 0;                // of the way: in standard deviations
  Vec3 error_axis_ = Vec3::Zero();  // (3) unit, in D
  Quat turn_ = Quat::Identity(), turn_before_ = Quat::Identity();
};

}  // namespace fulcrum
