#pragma once
// Places that somebody touches with a device's handle and with the tip of a controller at once, so that the
// device can be laid onto the headset's space. One squeeze of the controller takes one place.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/headset/rigid_fit.h"
#include "engine/xr/hands.h"

namespace fulcrum::headset {

// What there is to see of hands and handle for one picture.
struct TouchMoment {
  double time = 0;  // s, of the headset's clock
  std::array<xr::Hand, xr::kHands> hands;
  std::optional<Vec3> p_DH;  // (3) m, of the handle; none: the device says nothing
};

class TouchedPoints {
public:
  static constexpr double kHeldFor = 0.3;   // s, that a touch is held still and averaged over
  static constexpr double kStill = 0.002;   // m, that either may be from its mean meanwhile
  static constexpr std::size_t kMost = 12;  // points

  // limit: m, the largest residual (RMS) that is taken.
  explicit TouchedPoints(double limit) : limit_(limit) {}

  // A squeeze of either hand that begins takes a point. A stop button that is pressed takes what there is,
  // where that is good enough; forgets it where its residual is too large.
  void note(const TouchMoment& moment);
  // A picture in which nobody sees what is asked: a touch that is being held counts no more, and a squeeze
  // has to begin after it.
  void look_away();
  // What was touched is where it was no longer: why, as a sentence.
  void forget(std::string why);

  // From then on nothing is noted.
  bool is_taken() const { return taken_; }
  // None: there are fewer than three points.
  const std::optional<RigidFit>& fit() const { return fit_; }
  // What to do now, and what came of it: sentences, a line each.
  std::string text() const;

private:
  struct Touch {
    std::size_t hand = 0;
    double since = 0;  // s
    std::vector<PointPair> seen;
  };

  void begin(const TouchMoment& moment);
  void hold(const TouchMoment& moment);
  void add(const Touch& touch);
  void take();

  double limit_;
  std::vector<PointPair> points_;
  std::optional<RigidFit> fit_;
  std::optional<Touch> touch_;                                               // that is being held
  std::array<bool, xr::kHands> squeezed_{true, true}, pressed_{true, true};  // in the picture before
  bool taken_ = false;
  std::string said_;  // what became of the last one; empty: all is well
};

}  // namespace fulcrum::headset
