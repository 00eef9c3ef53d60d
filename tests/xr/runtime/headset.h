#pragma once
// The headset that the tests' runtime has, and what its program has made of it.

#include <array>
#include <chrono>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptics/math/pose.h"
#include "tests/xr/runtime/script.h"

namespace runtime {

using fulcrum::Pose;

struct Space {
  enum class Kind { view, local, stage, grip };
  Kind kind = Kind::local;
  std::size_t hand = 0;  // of a grip
  Pose offset;           // of the space in what it is made of
};

// A picture's images. Not in use, acquired, waited for, and then released.
struct Swapchain {
  std::uint32_t width = 0, height = 0;
  VkFormat format = VK_FORMAT_UNDEFINED;
  std::vector<VkImage> images;
  std::vector<VkDeviceMemory> memory;
  std::size_t next = 0;
  std::optional<std::size_t> acquired, released;  // the newest
  bool waited = false;
};

struct Action {
  std::string name;
  XrActionType type = XR_ACTION_TYPE_BOOLEAN_INPUT;
  // (hands) the binding under the one profile that this headset's controllers are.
  std::array<std::string, 2> parts;
};

// A hand without a controller. Its palm is in local space as that is at first.
struct BareHand {
  bool there = false, covered = false;
  Pose X_LP;
  double to_index = 0.08, to_little = 0.08;  // m, from the thumb's tip
  std::string spoilt;                        // how its palm's place is none; empty: it is one
};

// Of one hand, 0 for the left one.
struct HandTracker {
  std::size_t hand = 0;
};

struct Session {
  XrGraphicsBindingVulkan2KHR vulkan{};
  VkQueue queue = VK_NULL_HANDLE;
  VkCommandPool pool = VK_NULL_HANDLE;
  XrSessionState state = XR_SESSION_STATE_UNKNOWN, told = XR_SESSION_STATE_UNKNOWN;  // its program
  bool begun = false, lost = false, attached = false, exits = false, rests = false, breaks = false;
  bool waited = false, drawing = false;  // a frame was
  std::uint64_t frames = 0;
  std::vector<std::unique_ptr<Space>> spaces;
  std::vector<std::unique_ptr<Swapchain>> swapchains;
  std::vector<std::unique_ptr<HandTracker>> trackers;
};

struct Headset {
  Script script = read_script();
  std::size_t next_event = 0;
  std::uint64_t frame = 0;
  std::string waits_for, hangs_for;  // a file; empty: nothing
  std::string hangs_in;              // a call
  int handle_told_by = 0;            // turns of the library's scheduler; 0: no handle has been moved
  XrTime time = 1'000'000'000;
  std::chrono::steady_clock::time_point newest_frame{};  // when the program went on with it
  int gone = 0;                                          // so many times it is not found
  bool blind = false, dark = false, dead = false, stalls = false;
  bool has_vulkan = false;
  bool tracks_hands = false;  // its program has asked for that extension

  Pose X_LH;                 // head, in local space as it is at first: as all of these are
  std::array<Pose, 2> X_LG;  // grips
  std::array<bool, 2> in_hand{}, guessed{}, sleeps{};
  std::array<BareHand, 2> bare;
  Pose X_LL;       // local space now
  Pose X_LL_next;  // from then on
  std::optional<XrTime> moves_at;
  std::array<std::map<std::string, bool>, 2> pressed;

  std::deque<XrEventDataBuffer> events;
  std::vector<std::string> paths{""};
  std::vector<std::unique_ptr<Action>> actions;
  std::unique_ptr<Session> session;

  // Of all that was shown.
  std::uint64_t shown = 0, written[2]{}, differing = 0;
};

extern std::unique_ptr<Headset> headset;  // while there is an instance

template <class Handle, class T>
Handle handle_of(T* object) {
  return reinterpret_cast<Handle>(object);
}

void go_to(XrSessionState state);
// The session is lost, and its headset gone for a while.
void lose();
// A frame is waited for: what the script has for it happens.
void advance();
// Of the space, in local space as it is at first.
Pose pose_of(const Space& space);
// Left, right: as xrLocateViews has them in that space.
std::array<XrView, 2> views_in(const Space& space);

// Images of a swapchain (swapchain.cpp).
void make_images(Swapchain& swapchain);
void destroy_images(Swapchain& swapchain);
// Fills it with kUnwritten, and leaves it as a program is to find it.
void spoil(const Swapchain& swapchain, std::size_t image);
// Of the image that was released last: (height x width x 4).
std::vector<std::uint8_t> read(const Swapchain& swapchain);
inline constexpr std::array<std::uint8_t, 3> kUnwritten{255, 0, 255};

// What is shown of a frame, judged (shown.cpp).
XrResult judge_frame(const XrFrameEndInfo& info);

}  // namespace runtime
