#pragma once
// A simulated hand: an impedance about a scripted path, with tremor. It stands in for a person in headless
// runs.
//
// Impedance of a hand on a stylus: stiffness 100 to 1000 N/m, damping 1 to 10 N s/m, growing with grip force
// (Hajian and Howe 1997, J. Biomech. Eng. 119; Kuchenbecker, Park and Niemeyer 2003, IMECE). Physiological
// tremor: 8 to 12 Hz, about 50 um rms at the tip of a hand-held instrument (Riviere, Rader and Khosla 1997;
// Singhy and Riviere 2002).

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "haptics/device/yielding.h"
#include "haptics/math/pose.h"

namespace fulcrum {

struct HandDesc {
  double stiffness = 400;          // N/m
  double damping = 4;              // N s/m
  double angular_stiffness = 1.0;  // N m/rad
  double angular_damping = 0.01;   // N m s/rad
  double mass = 0;                 // kg, of the hand, that moves with the handle where it holds it
  double tremor = 50e-6;           // m rms, each axis
  double tremor_rad = 1e-3;        // rad rms, each axis
  double tremor_low_Hz = 8;
  double tremor_high_Hz = 12;
  std::uint64_t seed = 1;
  std::optional<YieldingDesc> yields{};  // without it the hand does what it meant to do, whatever it is told
};

// Where the hand wants the tool, and when. Between two waypoints the hand moves on a minimum-jerk profile
// (Flash and Hogan 1985, J. Neurosci. 5), straight and along the shortest rotation, and rests on each for
// `dwell`. Through some it goes without a rest, at the velocity of the straight way from the waypoint before
// to the one after, and without acceleration.
struct Waypoint {
  Pose X_WT;
  double travel = 1;  // s, from the waypoint before
  double dwell = 0;   // s
  // Of a stick: where it is held from here on, m along it from the handle's origin, and the force on its
  // strip, N. Absent: as at the waypoint before; to begin with at the handle's origin, and 2 N.
  std::optional<double> hold{}, press{};
  // s. Where it is given the hand presses its stop button on arrival and its go button so long after.
  std::optional<double> stop{};
  bool through = false;  // not of the first and the last, and without dwell
};

// Bits of DeviceSample::buttons, above all that a device in a hand has.
inline constexpr std::uint32_t kHandStopButton = 1u << 30, kHandGoButton = 1u << 31;

struct Grip {
  double hold = 0;   // m, along the stick from the handle's origin
  double press = 2;  // N
};

class HandPath {
public:
  explicit HandPath(std::vector<Waypoint> waypoints);  // at least one

  Pose at(double time) const;  // X_WT at s
  // Where and how firmly the stick is held at s: on a straight line in time from waypoint to waypoint.
  Grip grip(double time) const;
  // Those of the two buttons above that are down at s: the one until the stop is over, the other for the rest
  // of the dwell.
  std::uint32_t buttons(double time) const;
  bool slides() const { return slides_; }  // a waypoint says where the stick is held
  double duration() const { return end_.back(); }

private:
  bool passes(std::size_t i) const;

  std::vector<Waypoint> waypoints_;
  std::vector<Twist> twists_;  // of T in W, at each
  std::vector<double> end_;    // s, when each waypoint's dwell ends
  std::vector<Grip> grips_;    // at each
  bool slides_ = false;
};

// Physiological tremor: a sum of tones with seeded frequencies and phases, of the given rms on every axis.
class Tremor {
public:
  explicit Tremor(const HandDesc& desc);

  Vec6 at(double time) const;  // (6) m; rad

private:
  static constexpr std::size_t kTones = 8;
  struct Tone {
    double w = 0, phase = 0, amplitude = 0;  // rad/s; rad; m or rad
  };
  std::array<std::array<Tone, kTones>, 6> tones_;
};

}  // namespace fulcrum
