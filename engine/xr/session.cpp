#include "engine/xr/session.h"

#include <utility>

#include "engine/xr/credible.h"
#include "engine/xr/pose.h"

namespace fulcrum::xr {
namespace {

constexpr XrSpaceLocationFlags kKnown =
    XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT;
constexpr XrSpaceLocationFlags kTracked =
    XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT | XR_SPACE_LOCATION_POSITION_TRACKED_BIT;
constexpr std::size_t kMostRecentrings = 64;  // announced at once: whoever announces more means the last ones
constexpr XrViewStateFlags kSeen = XR_VIEW_STATE_ORIENTATION_VALID_BIT | XR_VIEW_STATE_POSITION_VALID_BIT;

XrSpace make_space(XrSession session, XrReferenceSpaceType type) {
  auto info = structure<XrReferenceSpaceCreateInfo>(XR_TYPE_REFERENCE_SPACE_CREATE_INFO);
  info.referenceSpaceType = type;
  info.poseInReferenceSpace.orientation.w = 1;
  XrSpace made = XR_NULL_HANDLE;
  const XrResult code = xrCreateReferenceSpace(session, &info, &made);
  if (code == XR_ERROR_REFERENCE_SPACE_UNSUPPORTED)
    throw Failure(
        "The headset knows no stage: set its room up in its runtime, or leave out --xr-space stage.");
  check(code, "say where its space is");
  return made;
}

}  // namespace

Session::Session(Instance& instance, vulkan::Device& gpu, Space space)
    : instance_(instance),
      type_(space == Space::stage ? XR_REFERENCE_SPACE_TYPE_STAGE : XR_REFERENCE_SPACE_TYPE_LOCAL),
      blend_mode_(instance.blend_mode()) {
  if (instance.card(gpu.instance()) != gpu.physical())
    throw Failure("The headset is plugged into another graphics card now: start this again.");
  auto binding = structure<XrGraphicsBindingVulkan2KHR>(XR_TYPE_GRAPHICS_BINDING_VULKAN2_KHR);
  binding.instance = gpu.instance();
  binding.physicalDevice = gpu.physical();
  binding.device = gpu.get();
  binding.queueFamilyIndex = gpu.queue_family();
  auto info = structure<XrSessionCreateInfo>(XR_TYPE_SESSION_CREATE_INFO);
  info.next = &binding;
  info.systemId = instance.system();
  check(xrCreateSession(instance.get(), &info, &session_), "begin a session");
  try {
    space_ = make_space(session_, type_);
  } catch (const Failure&) {
    xrDestroySession(session_);
    throw;
  }
}

Session::~Session() {
  if (space_ != XR_NULL_HANDLE) xrDestroySpace(space_);
  if (session_ != XR_NULL_HANDLE) xrDestroySession(session_);
}

void Session::take_events() {
  while (!lost_) {
    auto event = structure<XrEventDataBuffer>(XR_TYPE_EVENT_DATA_BUFFER);
    const XrResult code = xrPollEvent(instance_.get(), &event);
    if (code == XR_EVENT_UNAVAILABLE) return;
    check(code, "say what has happened");
    switch (event.type) {
      case XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED: {
        const auto& changed = reinterpret_cast<const XrEventDataSessionStateChanged&>(event);
        if (changed.session == session_) go_to(changed.state);
        break;
      }
      case XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING: {
        const auto& changed = reinterpret_cast<const XrEventDataReferenceSpaceChangePending&>(event);
        if (changed.session != session_ || changed.referenceSpaceType != type_) break;
        if (recentrings_.size() == kMostRecentrings) recentrings_.pop_back();
        recentrings_.push_back(changed.changeTime);
        break;
      }
      case XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING:
        throw Failure("The headset's runtime ends: start it anew, and this run with it.");
      default:
        break;
    }
  }
}

void Session::go_to(XrSessionState state) {
  state_ = state;
  switch (state) {
    case XR_SESSION_STATE_READY: {
      auto info = structure<XrSessionBeginInfo>(XR_TYPE_SESSION_BEGIN_INFO);
      info.primaryViewConfigurationType = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
      runs_ = goes_on(xrBeginSession(session_, &info), "begin to show pictures");
      ++times_begun_;
      break;
    }
    case XR_SESSION_STATE_STOPPING:
      runs_ = false;
      goes_on(xrEndSession(session_), "end showing pictures");
      break;
    case XR_SESSION_STATE_EXITING:
      over_ = true;
      break;
    case XR_SESSION_STATE_LOSS_PENDING:
      lost_ = true;
      runs_ = false;
      break;
    default:
      break;
  }
}

bool Session::goes_on(XrResult code, const char* doing) {
  if (code == XR_ERROR_SESSION_LOST) {
    lost_ = true;
    runs_ = false;
    state_ = XR_SESSION_STATE_LOSS_PENDING;
    return false;
  }
  check(code, doing);
  return true;
}

bool Session::was_recentred(const Frame& frame) {
  const auto has_come = [&](XrTime time) { return time <= frame.display_time; };
  return std::erase_if(recentrings_, has_come) > 0;
}

void Session::end() {
  if (runs_ && !std::exchange(ends_, true)) goes_on(xrRequestExitSession(session_), "end the session");
}

std::optional<Frame> Session::begin_frame() {
  const auto waits = structure<XrFrameWaitInfo>(XR_TYPE_FRAME_WAIT_INFO);
  auto state = structure<XrFrameState>(XR_TYPE_FRAME_STATE);
  if (!goes_on(xrWaitFrame(session_, &waits, &state), "say when to draw")) return std::nullopt;
  const auto begins = structure<XrFrameBeginInfo>(XR_TYPE_FRAME_BEGIN_INFO);
  if (!goes_on(xrBeginFrame(session_, &begins), "begin a picture")) return std::nullopt;
  return Frame{state.predictedDisplayTime, state.predictedDisplayPeriod, state.shouldRender == XR_TRUE};
}

void Session::end_frame(const Frame& frame, std::span<const XrCompositionLayerBaseHeader* const> layers) {
  auto info = structure<XrFrameEndInfo>(XR_TYPE_FRAME_END_INFO);
  info.displayTime = frame.display_time;
  info.environmentBlendMode = blend_mode_;
  info.layerCount = static_cast<std::uint32_t>(layers.size());
  info.layers = layers.data();
  goes_on(xrEndFrame(session_, &info), "show a picture");
}

std::optional<std::array<EyeView, 2>> Session::eyes(const Frame& frame) {
  auto info = structure<XrViewLocateInfo>(XR_TYPE_VIEW_LOCATE_INFO);
  info.viewConfigurationType = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
  info.displayTime = frame.display_time;
  info.space = space_;
  auto state = structure<XrViewState>(XR_TYPE_VIEW_STATE);
  std::array<XrView, 2> views;
  views.fill(structure<XrView>(XR_TYPE_VIEW));
  std::uint32_t count = 0;
  if (!goes_on(xrLocateViews(session_, &info, &state, static_cast<std::uint32_t>(views.size()), &count,
                             views.data()),
               "say where the eyes are") ||
      (state.viewStateFlags & kSeen) != kSeen)
    return std::nullopt;
  const std::optional<Pose> left = credible(views[0].pose), right = credible(views[1].pose);
  if (!left || !right || !is_credible(views[0].fov) || !is_credible(views[1].fov)) return std::nullopt;
  return std::array{EyeView{*left, views[0].fov}, EyeView{*right, views[1].fov}};
}

std::optional<Pose> Session::locate(XrSpace space, const Frame& frame, Sight sight) {
  const XrSpaceLocationFlags needed = sight == Sight::now ? kKnown | kTracked : kKnown;
  auto location = structure<XrSpaceLocation>(XR_TYPE_SPACE_LOCATION);
  if (!goes_on(xrLocateSpace(space, space_, frame.display_time, &location), "say where a hand is") ||
      (location.locationFlags & needed) != needed)
    return std::nullopt;
  return credible(location.pose);
}

}  // namespace fulcrum::xr
