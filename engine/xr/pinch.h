#pragma once
// A hand without a controller that holds a tool between thumb and index finger, and stops the force with
// thumb and little finger.
//
// What it holds is where the two tips met, fixed to its palm. So a turn of the hand is one about the tool, as
// with a pen; the two tips, which cameras see worst behind one another, do not shake it; and letting go,
// which moves both, leaves it where it was.

#include <optional>

#include "engine/xr/hand_tracking.h"
#include "engine/xr/hands.h"

namespace fulcrum::xr {

// m, from one tip's middle to the other's: nearer they are together, and apart again only beyond the second.
// Two fingers that touch are 12 to 16 mm apart, and cameras are taken to see each tip with an error of 10 mm.
inline constexpr double kTogether = 0.020, kApart = 0.035;

class Pinch {
public:
  // joints: none: it is out of sight; what it held or pressed then it does until it is seen again.
  Hand follow(const std::optional<HandJoints>& joints);

private:
  bool was_seen_ = false;
  bool met_unseen_ = false;  // the tips came into sight together: a fist holds nothing until it has opened
  bool holds_ = false, stops_ = false;
  Vec3 p_PG_ = Vec3::Zero();  // (3) m, what it holds, in its palm
};

}  // namespace fulcrum::xr
