#pragma once
// The controllers of a headset: where each hand is, what it presses, and how it is made to vibrate.

#include <array>
#include <cstddef>
#include <optional>

#include "engine/xr/session.h"

namespace fulcrum::xr {

inline constexpr std::size_t kHands = 2;  // left, right

struct Hand {
  std::optional<Pose> X_LG;  // of its grip, as the specification has it; none: nobody knows where it is
  // (3) m in L, what it points from: the origin of its aim; none: the headset does not see it now, or nobody
  // asked.
  std::optional<Vec3> tip_L;
  bool holds = false;  // it is squeezed, or where nothing can be, its select button is down
  bool stops = false;  // its menu button is down, or what stands for it
  // Somebody says whether it holds: of a controller that sleeps, or is not bound yet, nobody does.
  bool is_known = false;
};

class Hands {
public:
  // The session outlives it. tips: asked for. Throws Failure.
  Hands(Session& session, bool tips);
  ~Hands();
  Hands(const Hands&) = delete;
  Hands& operator=(const Hands&) = delete;

  // Where they are when the frame will be seen. Hands that are out of use are nowhere and press nothing.
  std::array<Hand, kHands> read(const Frame& frame);

  // strength: 0, for it to be still, to 1; what nobody would feel is still, too. Until the next call, or a
  // tenth of a second where there is none.
  void vibrate(std::size_t hand, double strength, double frequency_Hz);

private:
  XrSpace make_space(XrAction action, std::size_t hand);
  XrAction make_action(XrActionType type, const char* name, const char* shown);
  void suggest_bindings();
  // None: nobody says.
  std::optional<bool> is_down(XrAction action, std::size_t hand);

  Session& session_;
  std::array<XrPath, kHands> paths_;
  XrActionSet set_ = XR_NULL_HANDLE;
  XrAction aim_ = XR_NULL_HANDLE;  // null: tips are not asked for
  XrAction grip_ = XR_NULL_HANDLE, hold_ = XR_NULL_HANDLE, stop_ = XR_NULL_HANDLE, vibrate_ = XR_NULL_HANDLE;
  std::array<XrSpace, kHands> grips_{}, aims_{};
  std::array<bool, kHands> vibrates_{};
};

}  // namespace fulcrum::xr
