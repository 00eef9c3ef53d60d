#pragma once
// What Haply's service says of an Inverse3 and of the handle on it, and what it is told, as JSON. Source: the
// service's manual, docs.haply.co/inverseSDK/service, pages "WebSocket Protocol", "Control Commands" and
// "Simulation Channel", of its versions 3.4 and 3.5. S is the service's own frame: x right, y away from the
// person, z up; m and N.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "haptics/math/pose.h"

namespace fulcrum::inverse3 {

// A message that is longer, or nested deeper, is refused. Of each device there are some 2000 bytes.
inline constexpr std::size_t kMostBytes = 65536;
inline constexpr int kMostDepth = 16;

// What the service calls the devices that a run goes on with, whatever others are plugged in.
struct Chosen {
  std::string arm;
  std::string handle;  // a VerseGrip, which says how it is turned; empty: there was none
};

struct ServiceSays {
  Chosen of;                   // of.arm is empty: there is no such Inverse3 (any more)
  Vec3 p_SH = Vec3::Zero();    // m
  std::optional<Quat> q_SH{};  // of the handle; none: there is none, or it says nothing of its turn
  std::uint32_t buttons = 0;   // of the handle
  bool calibrated = true, powered = true;
  // Told in the first message of a connection alone.
  bool since_3_5 = false;  // by the sessions that this version numbers; assumed of the wording of commands
  std::string unusable{};  // why its configuration is none that can be used, and what would; empty: it can
};

// chosen: none yet takes the first of each. None: it is not such a message, or a number in it is none.
std::optional<ServiceSays> decode(std::string_view message, const std::optional<Chosen>& chosen);

// The force (N, in S) for one turn: the service forgets it after that. What is no number is nought.
std::string encode_force(const std::string& arm, const Vec3& force_S, bool since_3_5);

}  // namespace fulcrum::inverse3
