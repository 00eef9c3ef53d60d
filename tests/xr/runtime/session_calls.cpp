#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <utility>

#include "engine/xr/pose.h"
#include "tests/xr/runtime/calls.h"
#include "tests/xr/runtime/headset.h"
#include "tests/xr/runtime/log.h"

namespace runtime {
namespace {

Session& session() {
  return *headset->session;
}

XrResult out_of_order(const char* what) {
  wrong(what);
  return XR_ERROR_CALL_ORDER_INVALID;
}

XrResult XRAPI_CALL create_session(XrInstance, const XrSessionCreateInfo* info, XrSession* made) {
  log("xrCreateSession");
  if (!headset->has_vulkan) {
    wrong("a session is made before Vulkan's requirements were asked for");
    return XR_ERROR_GRAPHICS_REQUIREMENTS_CALL_MISSING;
  }
  if (headset->session) return XR_ERROR_LIMIT_REACHED;
  headset->session = std::make_unique<Session>();
  session().vulkan = *static_cast<const XrGraphicsBindingVulkan2KHR*>(info->next);
  const VkDevice device = session().vulkan.device;
  vkGetDeviceQueue(device, session().vulkan.queueFamilyIndex, session().vulkan.queueIndex, &session().queue);
  VkCommandPoolCreateInfo pool{};
  pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
  pool.queueFamilyIndex = session().vulkan.queueFamilyIndex;
  if (vkCreateCommandPool(device, &pool, nullptr, &session().pool) != VK_SUCCESS)
    return XR_ERROR_RUNTIME_FAILURE;
  *made = handle_of<XrSession>(headset->session.get());
  go_to(XR_SESSION_STATE_IDLE);
  go_to(XR_SESSION_STATE_READY);
  return XR_SUCCESS;
}

XrResult XRAPI_CALL destroy_session(XrSession) {
  log("xrDestroySession");
  if (!session().swapchains.empty()) wrong("a session goes before its pictures");
  if (!session().trackers.empty()) wrong("a session goes before its trackers of hands");
  vkDestroyCommandPool(session().vulkan.device, session().pool, nullptr);
  headset->session.reset();
  headset->events.clear();
  headset->has_vulkan = false;
  return XR_SUCCESS;
}

XrResult XRAPI_CALL begin_session(XrSession, const XrSessionBeginInfo*) {
  log("xrBeginSession");
  if (session().lost) return XR_ERROR_SESSION_LOST;
  if (session().begun) return XR_ERROR_SESSION_RUNNING;
  if (session().state != XR_SESSION_STATE_READY) {
    wrong("a session begins before it is ready");
    return XR_ERROR_SESSION_NOT_READY;
  }
  session().begun = true;
  session().frames = 0;
  return XR_SUCCESS;
}

XrResult XRAPI_CALL end_session(XrSession) {
  log("xrEndSession");
  if (session().lost) return XR_ERROR_SESSION_LOST;
  if (session().state != XR_SESSION_STATE_STOPPING) {
    wrong("a session ends before it is to stop");
    return XR_ERROR_SESSION_NOT_STOPPING;
  }
  session().begun = false;
  go_to(XR_SESSION_STATE_IDLE);
  if (session().exits) go_to(XR_SESSION_STATE_EXITING);
  if (session().rests) go_to(XR_SESSION_STATE_READY);
  session().rests = false;
  return XR_SUCCESS;
}

XrResult XRAPI_CALL request_exit(XrSession) {
  log("xrRequestExitSession");
  if (session().lost) return XR_ERROR_SESSION_LOST;
  if (!session().begun) return XR_ERROR_SESSION_NOT_RUNNING;
  session().exits = true;
  go_to(XR_SESSION_STATE_STOPPING);
  return XR_SUCCESS;
}

XrResult XRAPI_CALL enumerate_spaces(XrSession, std::uint32_t capacity, std::uint32_t* count,
                                     XrReferenceSpaceType* types) {
  constexpr std::array all{XR_REFERENCE_SPACE_TYPE_VIEW, XR_REFERENCE_SPACE_TYPE_LOCAL,
                           XR_REFERENCE_SPACE_TYPE_STAGE};
  return give(std::span<const XrReferenceSpaceType>(all), capacity, count, types);
}

XrResult XRAPI_CALL create_space(XrSession, const XrReferenceSpaceCreateInfo* info, XrSpace* made) {
  const Space::Kind kind = info->referenceSpaceType == XR_REFERENCE_SPACE_TYPE_VIEW    ? Space::Kind::view
                           : info->referenceSpaceType == XR_REFERENCE_SPACE_TYPE_STAGE ? Space::Kind::stage
                                                                                       : Space::Kind::local;
  log("xrCreateReferenceSpace " + std::to_string(info->referenceSpaceType));
  session().spaces.push_back(
      std::make_unique<Space>(Space{kind, 0, fulcrum::xr::pose_of(info->poseInReferenceSpace)}));
  *made = handle_of<XrSpace>(session().spaces.back().get());
  return XR_SUCCESS;
}

XrResult XRAPI_CALL bounds(XrSession, XrReferenceSpaceType, XrExtent2Df* extent) {
  *extent = {};
  return XR_SPACE_BOUNDS_UNAVAILABLE;
}

XrResult XRAPI_CALL destroy_space(XrSpace space) {
  std::erase_if(session().spaces, [&](const auto& one) { return handle_of<XrSpace>(one.get()) == space; });
  return XR_SUCCESS;
}

XrResult XRAPI_CALL locate_space(XrSpace space, XrSpace base, XrTime time, XrSpaceLocation* location) {
  if (session().lost) return XR_ERROR_SESSION_LOST;
  if (time <= 0) return XR_ERROR_TIME_INVALID;
  const Space& wanted = *reinterpret_cast<const Space*>(space);
  location->locationFlags = 0;
  if (wanted.kind == Space::Kind::grip && !headset->in_hand[wanted.hand]) return XR_SUCCESS;
  location->locationFlags = XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT;
  if (wanted.kind != Space::Kind::grip || !headset->guessed[wanted.hand])
    location->locationFlags |=
        XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT | XR_SPACE_LOCATION_POSITION_TRACKED_BIT;
  location->pose =
      fulcrum::xr::to_xr(pose_of(*reinterpret_cast<const Space*>(base)).inverse() * pose_of(wanted));
  return XR_SUCCESS;
}

XrResult XRAPI_CALL locate_views(XrSession, const XrViewLocateInfo* info, XrViewState* state,
                                 std::uint32_t capacity, std::uint32_t* count, XrView* views) {
  if (session().lost) return XR_ERROR_SESSION_LOST;
  if (info->displayTime != headset->time) wrong("eyes are asked for at a time that no frame is for");
  state->viewStateFlags =
      headset->blind ? 0 : XR_VIEW_STATE_ORIENTATION_VALID_BIT | XR_VIEW_STATE_POSITION_VALID_BIT;
  const std::array<XrView, 2> all = views_in(*reinterpret_cast<const Space*>(info->space));
  return give(std::span<const XrView>(all), capacity, count, views);
}

void hang_in(const std::string& call) {
  if (headset->hangs_for.empty() || headset->hangs_in != call) return;
  const std::string file = std::exchange(headset->hangs_for, {});
  log(call + " hangs for " + file);
  while (!std::filesystem::exists(file)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

XrResult XRAPI_CALL wait_frame(XrSession, const XrFrameWaitInfo*, XrFrameState* state) {
  if (session().lost) return XR_ERROR_SESSION_LOST;
  if (!session().begun) return out_of_order("a frame is waited for while the session does not run");
  if (session().waited) return out_of_order("a frame is waited for before the last one began");
  std::this_thread::sleep_until(headset->newest_frame + std::chrono::milliseconds(headset->script.pace_ms));
  headset->newest_frame = std::chrono::steady_clock::now();
  advance();
  if (session().lost) {
    log("the session is lost");
    return XR_ERROR_SESSION_LOST;
  }
  session().waited = true;
  hang_in("xrWaitFrame");
  state->predictedDisplayTime = headset->time;
  state->predictedDisplayPeriod = 11'111'111;
  state->shouldRender = headset->dark ? XR_FALSE : XR_TRUE;
  log("xrWaitFrame " + std::to_string(headset->frame));
  return XR_SUCCESS;
}

XrResult XRAPI_CALL begin_frame(XrSession, const XrFrameBeginInfo*) {
  if (session().lost) return XR_ERROR_SESSION_LOST;
  if (!session().waited) return out_of_order("a frame begins that was not waited for");
  if (session().drawing) wrong("a frame begins before the last one has ended");
  session().waited = false;
  session().drawing = true;
  log("xrBeginFrame");
  return XR_SUCCESS;
}

XrResult XRAPI_CALL end_frame(XrSession, const XrFrameEndInfo* info) {
  if (session().lost) return XR_ERROR_SESSION_LOST;
  if (!session().drawing) return out_of_order("a frame ends that has not begun");
  hang_in("xrEndFrame");
  session().drawing = false;
  log("xrEndFrame");
  const XrResult code = judge_frame(*info);
  if (session().frames == 1) go_to(XR_SESSION_STATE_SYNCHRONIZED);
  if (session().frames == 1) go_to(XR_SESSION_STATE_VISIBLE);
  if (session().frames == headset->script.focus) go_to(XR_SESSION_STATE_FOCUSED);
  return code;
}

}  // namespace

std::span<const Call> session_calls() {
  static const std::array calls{Call{"xrCreateSession", erased(create_session)},
                                Call{"xrDestroySession", erased(destroy_session)},
                                Call{"xrBeginSession", erased(begin_session)},
                                Call{"xrEndSession", erased(end_session)},
                                Call{"xrRequestExitSession", erased(request_exit)},
                                Call{"xrEnumerateReferenceSpaces", erased(enumerate_spaces)},
                                Call{"xrCreateReferenceSpace", erased(create_space)},
                                Call{"xrGetReferenceSpaceBoundsRect", erased(bounds)},
                                Call{"xrDestroySpace", erased(destroy_space)},
                                Call{"xrLocateSpace", erased(locate_space)},
                                Call{"xrLocateViews", erased(locate_views)},
                                Call{"xrWaitFrame", erased(wait_frame)},
                                Call{"xrBeginFrame", erased(begin_frame)},
                                Call{"xrEndFrame", erased(end_frame)}};
  return calls;
}

}  // namespace runtime
