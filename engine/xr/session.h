#pragma once
// What a headset shows and senses from here on, until its runtime ends it or loses it.
//
// The order of calls is that of the specification, "Session Lifecycle" and "Frame Synchronization"
// (The OpenXR Specification 1.0, 9 and 10). All from one thread.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/vulkan/device.h"
#include "engine/xr/instance.h"
#include "haptics/math/pose.h"

namespace fulcrum::xr {

// Where poses are told in, frame L: its y axis is up.
enum class Space {
  local,  // its origin is where the head was when it was recentred, its -z axis ahead of it
  stage   // its origin is on the floor, in the middle of the room that there is
};

// One eye's place and what it sees from there.
struct EyeView {
  Pose X_LE;  // the eye looks along its -z
  XrFovf fov{};
};

struct Frame {
  XrTime display_time = 0;  // ns of the runtime's clock: when it will be seen
  XrDuration period = 0;    // ns
  bool should_render = false;
};

class Session {
public:
  // Waits for the runtime to be ready: take_events() begins it. Throws Failure, such as where the headset
  // has no stage.
  Session(Instance& instance, vulkan::Device& gpu, Space space);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  // What has happened since; begins and ends frames as the runtime asks for. Throws Failure where the runtime
  // itself is gone.
  void take_events();
  bool runs() const { return runs_; }                                     // frames are to be drawn
  bool is_focused() const { return state_ == XR_SESSION_STATE_FOCUSED; }  // it is seen, and hands count
  bool is_lost() const { return lost_; }  // another one may be made once the headset is found again
  bool is_over() const { return over_; }  // whoever wears the headset has ended it, or the runtime has
  // Once after each time that L has moved in the room: from that frame on.
  bool was_recentred(const Frame& frame);
  // How often pictures have begun to be shown: each time they may be of another size.
  int times_begun() const { return times_begun_; }

  // Asks the runtime to end it, once.
  void end();

  // Waits until it is time to draw; none: the session has been lost.
  std::optional<Frame> begin_frame();
  // layers: from the back to the front; none: nothing is shown.
  void end_frame(const Frame& frame, std::span<const XrCompositionLayerBaseHeader* const> layers);

  // Left, right; none: nobody knows where the head is.
  std::optional<std::array<EyeView, 2>> eyes(const Frame& frame);
  // What a place is known by: it may be guessed where it is out of sight, or is seen as it is.
  enum class Sight { any, now };
  // In L; none: nobody knows where it is.
  std::optional<Pose> locate(XrSpace space, const Frame& frame, Sight sight = Sight::any);

  XrSession get() const { return session_; }
  XrSpace space() const { return space_; }
  Instance& instance() const { return instance_; }
  // What a call said: false: the session is lost. Throws Failure where it is any other error.
  bool goes_on(XrResult code, const char* doing);

private:
  void go_to(XrSessionState state);

  Instance& instance_;
  XrSession session_ = XR_NULL_HANDLE;
  XrReferenceSpaceType type_;  // of L
  XrSpace space_ = XR_NULL_HANDLE;
  XrEnvironmentBlendMode blend_mode_;
  XrSessionState state_ = XR_SESSION_STATE_UNKNOWN;
  bool runs_ = false, lost_ = false, over_ = false, ends_ = false;
  int times_begun_ = 0;
  std::vector<XrTime> recentrings_;  // that have been announced, and are not told yet
};

}  // namespace fulcrum::xr
