#include <cstdio>

#include "engine/xr/pose.h"
#include "tests/xr/runtime/calls.h"
#include "tests/xr/runtime/headset.h"
#include "tests/xr/runtime/log.h"

namespace runtime {
namespace {

constexpr std::array<const char*, 2> kHands{"/user/hand/left", "/user/hand/right"};
// What this headset's controllers are.
constexpr const char* kProfile = "/interaction_profiles/khr/simple_controller";

const Action& action_of(XrAction action) {
  return *reinterpret_cast<const Action*>(action);
}

// 0: of either hand, the left one first.
std::size_t hand_of(XrPath path) {
  return path != XR_NULL_PATH && headset->paths.at(path) == kHands[1] ? 1 : 0;
}

// And its program knows: no hand counts before.
bool has_focus() {
  const Session& session = *headset->session;
  return session.state == XR_SESSION_STATE_FOCUSED && session.told == XR_SESSION_STATE_FOCUSED;
}

// Of the part that the action is bound to: "/input/select/click" is "select".
bool is_pressed(const Action& action, std::size_t hand) {
  const std::string& part = action.parts[hand];
  constexpr std::string_view input = "/input/";
  if (!part.starts_with(input)) return false;
  const std::string name = part.substr(input.size(), part.find('/', input.size()) - input.size());
  const auto found = headset->pressed[hand].find(name);
  return found != headset->pressed[hand].end() && found->second;
}

XrResult XRAPI_CALL create_action_set(XrInstance, const XrActionSetCreateInfo*, XrActionSet* set) {
  *set = handle_of<XrActionSet>(headset.get());  // there is no need to tell them apart
  return XR_SUCCESS;
}

XrResult XRAPI_CALL destroy_action_set(XrActionSet) {
  headset->actions.clear();
  return XR_SUCCESS;
}

XrResult XRAPI_CALL create_action(XrActionSet, const XrActionCreateInfo* info, XrAction* action) {
  headset->actions.push_back(std::make_unique<Action>(Action{info->actionName, info->actionType, {}}));
  *action = handle_of<XrAction>(headset->actions.back().get());
  return XR_SUCCESS;
}

XrResult XRAPI_CALL destroy_action(XrAction action) {
  std::erase_if(headset->actions, [&](const auto& one) { return handle_of<XrAction>(one.get()) == action; });
  return XR_SUCCESS;
}

XrResult XRAPI_CALL suggest(XrInstance, const XrInteractionProfileSuggestedBinding* suggested) {
  const std::string& profile = headset->paths.at(suggested->interactionProfile);
  log("xrSuggestInteractionProfileBindings " + profile);
  if (headset->session && headset->session->attached) return XR_ERROR_ACTIONSETS_ALREADY_ATTACHED;
  if (profile != kProfile) return XR_SUCCESS;
  for (std::uint32_t i = 0; i < suggested->countSuggestedBindings; ++i) {
    const XrActionSuggestedBinding& binding = suggested->suggestedBindings[i];
    const std::string& path = headset->paths.at(binding.binding);
    for (std::size_t hand = 0; hand < kHands.size(); ++hand)
      if (path.starts_with(kHands[hand]))
        reinterpret_cast<Action*>(binding.action)->parts[hand] =
            path.substr(std::string(kHands[hand]).size());
  }
  return XR_SUCCESS;
}

XrResult XRAPI_CALL attach(XrSession, const XrSessionActionSetsAttachInfo*) {
  log("xrAttachSessionActionSets");
  if (headset->session->attached) return XR_ERROR_ACTIONSETS_ALREADY_ATTACHED;
  headset->session->attached = true;
  return XR_SUCCESS;
}

XrResult XRAPI_CALL create_action_space(XrSession, const XrActionSpaceCreateInfo* info, XrSpace* made) {
  const std::size_t hand = hand_of(info->subactionPath);
  const bool aims = action_of(info->action).parts[hand] == "/input/aim/pose";
  const Pose X_GA = fulcrum::xr::pose_of({{0, 0, 0, 1}, aims ? kAim : XrVector3f{}});
  headset->session->spaces.push_back(std::make_unique<Space>(
      Space{Space::Kind::grip, hand, X_GA * fulcrum::xr::pose_of(info->poseInActionSpace)}));
  *made = handle_of<XrSpace>(headset->session->spaces.back().get());
  return XR_SUCCESS;
}

XrResult XRAPI_CALL current_profile(XrSession, XrPath, XrInteractionProfileState* state) {
  state->interactionProfile = XR_NULL_PATH;
  return XR_SUCCESS;
}

XrResult XRAPI_CALL sync(XrSession, const XrActionsSyncInfo*) {
  if (headset->session->lost) return XR_ERROR_SESSION_LOST;
  if (!headset->session->attached) {
    wrong("hands are asked for before what they do was attached");
    return XR_ERROR_ACTIONSET_NOT_ATTACHED;
  }
  return has_focus() ? XR_SUCCESS : XR_SESSION_NOT_FOCUSED;
}

XrResult XRAPI_CALL get_boolean(XrSession, const XrActionStateGetInfo* info, XrActionStateBoolean* state) {
  if (headset->session->lost) return XR_ERROR_SESSION_LOST;
  const std::size_t hand = hand_of(info->subactionPath);
  state->isActive = has_focus() && !headset->sleeps[hand];
  state->currentState = state->isActive == XR_TRUE && is_pressed(action_of(info->action), hand);
  state->changedSinceLastSync = XR_FALSE;
  state->lastChangeTime = headset->time;
  return XR_SUCCESS;
}

XrResult XRAPI_CALL get_float(XrSession, const XrActionStateGetInfo* info, XrActionStateFloat* state) {
  const bool down = has_focus() && is_pressed(action_of(info->action), hand_of(info->subactionPath));
  state->currentState = down ? 1.0F : 0.0F;
  state->changedSinceLastSync = XR_FALSE;
  state->lastChangeTime = headset->time;
  state->isActive = has_focus();
  return XR_SUCCESS;
}

XrResult XRAPI_CALL get_pose(XrSession, const XrActionStateGetInfo* info, XrActionStatePose* state) {
  state->isActive = has_focus() && headset->in_hand[hand_of(info->subactionPath)];
  return XR_SUCCESS;
}

XrResult XRAPI_CALL bound_sources(XrSession, const XrBoundSourcesForActionEnumerateInfo*, std::uint32_t,
                                  std::uint32_t* count, XrPath*) {
  *count = 0;
  return XR_SUCCESS;
}

XrResult XRAPI_CALL source_name(XrSession, const XrInputSourceLocalizedNameGetInfo*, std::uint32_t capacity,
                                std::uint32_t* count, char* buffer) {
  return give_text("a part of a hand", capacity, count, buffer);
}

XrResult XRAPI_CALL apply_haptics(XrSession, const XrHapticActionInfo* info,
                                  const XrHapticBaseHeader* header) {
  if (headset->session->lost) return XR_ERROR_SESSION_LOST;
  const auto& vibration = *reinterpret_cast<const XrHapticVibration*>(header);
  const std::size_t hand = hand_of(info->subactionPath);
  if (action_of(info->action).parts[hand] != "/output/haptic") wrong("what vibrates is no vibrator");
  if (!(vibration.amplitude >= 0 && vibration.amplitude <= 1))
    wrong("a vibration is stronger than the whole");
  char line[128];
  std::snprintf(line, sizeof line, "xrApplyHapticFeedback %s %.4f %.1f Hz %lld ns", kHands[hand],
                static_cast<double>(vibration.amplitude), static_cast<double>(vibration.frequency),
                static_cast<long long>(vibration.duration));
  log(line);
  return has_focus() ? XR_SUCCESS : XR_SESSION_NOT_FOCUSED;
}

XrResult XRAPI_CALL stop_haptics(XrSession, const XrHapticActionInfo* info) {
  if (headset->session->lost) return XR_ERROR_SESSION_LOST;
  log(std::string("xrStopHapticFeedback ") + kHands[hand_of(info->subactionPath)]);
  return XR_SUCCESS;
}

}  // namespace

std::span<const Call> action_calls() {
  static const std::array calls{Call{"xrCreateActionSet", erased(create_action_set)},
                                Call{"xrDestroyActionSet", erased(destroy_action_set)},
                                Call{"xrCreateAction", erased(create_action)},
                                Call{"xrDestroyAction", erased(destroy_action)},
                                Call{"xrSuggestInteractionProfileBindings", erased(suggest)},
                                Call{"xrAttachSessionActionSets", erased(attach)},
                                Call{"xrCreateActionSpace", erased(create_action_space)},
                                Call{"xrGetCurrentInteractionProfile", erased(current_profile)},
                                Call{"xrSyncActions", erased(sync)},
                                Call{"xrGetActionStateBoolean", erased(get_boolean)},
                                Call{"xrGetActionStateFloat", erased(get_float)},
                                Call{"xrGetActionStatePose", erased(get_pose)},
                                Call{"xrEnumerateBoundSourcesForAction", erased(bound_sources)},
                                Call{"xrGetInputSourceLocalizedName", erased(source_name)},
                                Call{"xrApplyHapticFeedback", erased(apply_haptics)},
                                Call{"xrStopHapticFeedback", erased(stop_haptics)}};
  return calls;
}

}  // namespace runtime
