#pragma once
// Guidance on request: a guidance virtual fixture on the expert's way, soft enough to be overruled, and where
// the expert's tool would be a little later, for the renderer. L. B. Rosenberg, "Virtual fixtures: perceptual
// tools for telerobotic manipulation" (IEEE VRAIS 1993); J. J. Abbott, P. Marayong, A. M. Okamura, "Haptic
// virtual fixtures for robot-assisted manipulation" (Robotics Research 28, 2007), whose guidance fixture of
// impedance type this is. With e (3) m from the handle to its place on the way, both at the device's scale:
//     f = L clamp(K s - B v . e / |e|, 0, f_max) e / |e|      s = max(0, |e| - b)
// on the handle's origin, and no torque. Within the dead band b nothing is felt; beyond it pulls a
// DampedSpring (device/damped_spring.h). L goes from 0 to the gain within half a second, and back.
//
// The place on the way goes on and never back. In each tick it moves on for as long as that brings it no
// farther from the handle, within a window of w ahead. Places of the window behind a farther stretch, such as
// the way back from a dead end, it takes only once they are nearer by more than b / 2. So a handle that rests
// has a place that rests; a tick looks at 24 pieces at most; and a place that moves never winds the spring:
// energy comes of L's rise alone. That is let in by design, once for each time that it rises, and told apart
// from what the spring would make (stored()).
//
// While it is off, the places where the expert rests are watched for, in their order, so that it begins where
// the task stands. Switched on it looks through the way from there on, 16 pieces a tick, and takes the first
// place that none of the later ones is nearer than by more than b / 2.

#include <optional>
#include <vector>

#include "haptics/device/damped_spring.h"
#include "haptics/device/mapping.h"
#include "haptics/effects/guidance/guidance_record.h"
#include "haptics/effects/guidance/guidance_way.h"
#include "haptics/math/mirror.h"
#include "haptics/signal/ramp.h"
#include "haptics/tick/command.h"

namespace fulcrum {

struct GuidanceDesc {
  std::vector<GuidancePose> way{};    // the expert's; at least one pose
  double dead_band = 2e-3;            // m in the scene, b
  std::optional<double> window{};     // m in the scene, w; without it ten dead bands
  std::optional<double> stiffness{};  // N/m at the device, K; without it what suits the device
  std::optional<double> max_force{};  // N at the device, f_max; without it a fifth of the device's
  double ahead = 0.5;                 // s, by which the tool that is shown is ahead
  double gain = 0;                    // at the start; 0: off, and a person can switch it on
};

inline void mirror(GuidanceDesc& desc) {
  for (GuidancePose& pose : desc.way) mirror(pose.X_WT);
}

// The nearest of places that are told in their order along a way, as it is said above.
class NearestOnWay {
public:
  NearestOnWay(const GuidanceWay::Place& first, double margin) : best_(first), margin_(margin) {}

  // end: the part up to which its piece was looked at. Only there does the next piece go on from it.
  void note(const GuidanceWay::Place& place, double end) noexcept {
    const bool nearer =
        (goes_on_ && place.distance <= best_.distance) || place.distance < best_.distance - margin_;
    if (nearer) best_ = place;
    goes_on_ = nearer && place.part >= end;
  }
  const GuidanceWay::Place& best() const { return best_; }

private:
  GuidanceWay::Place best_;
  double margin_;  // m
  bool goes_on_ = true;
};

class Guidance {
public:
  static constexpr double kForceShare = 0.2;      // of the device's largest force, where none is given
  static constexpr double kMostForceShare = 0.5;  // the rest is the scene's
  static constexpr double kRamp = 0.5;            // s, from nothing to the whole
  static constexpr double kBandsOfWindow = 10;
  static constexpr double kMarginOfBand = 0.5;  // by which a place behind a farther one must be nearer
  static constexpr double kBandsToWhole = 5;    // beyond the dead band, where no stiffness is given
  static constexpr std::size_t kSearched = 16;  // pieces a tick, once it is switched on

  struct Surroundings {
    Vec3 p_TH = Vec3::Zero();  // (3) m, the handle on the tool
    MappingDesc mapping{};
    const DeviceDesc& device;
    double tick_s = 1e-3;
  };
  Guidance(const GuidanceDesc& desc, const Surroundings& of);

  void apply(const Command& command) noexcept;

  struct Tick {
    Vec3 p_WH = Vec3::Zero();        // (3) m, of the handle as the hand has it
    Vec3 per_tick_D = Vec3::Zero();  // (3) m per tick, its motion at the device
    bool engaged = true;             // false while clutched: the hand feels nothing
  };
  // On the handle (3) N, in D.
  Vec3 process(const Tick& tick) noexcept;
  // J at the device, that the spring holds beyond what was let in.
  double stored() const noexcept { return record_.level * spring_energy_ - let_in_; }

  const GuidanceWay& way() const { return way_; }
  // Null: the device does not push.
  const DampedSpring* spring() const { return spring_ ? &*spring_ : nullptr; }
  double window() const { return window_; }  // m
  const GuidanceDesc& desc() const { return desc_; }
  const GuidanceRecord& record() const { return record_; }

private:
  void watch_rests(const Vec3& p_WH) noexcept;
  bool search(const Vec3& p_WH) noexcept;
  void follow(const Vec3& p_WH) noexcept;
  void pull(const Tick& tick) noexcept;

  GuidanceDesc desc_;
  GuidanceWay way_;
  MappingDesc mapping_;
  double window_, tick_s_;
  std::optional<DampedSpring> spring_;
  Ramp ramp_;

  GuidanceWay::Place place_;
  std::size_t next_rest_ = 0;
  std::optional<NearestOnWay> found_{};  // while it looks through the way
  std::size_t searched_ = 0;             // pieces, up to which it has looked
  bool follows_ = false;                 // it knows where on the way the handle is
  double spring_energy_ = 0;             // J, at the device, of the whole spring
  double let_in_ = 0;                    // J
  GuidanceRecord record_;
};

}  // namespace fulcrum
