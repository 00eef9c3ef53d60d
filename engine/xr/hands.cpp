#include "engine/xr/hands.h"

#include <cstring>
#include <span>
#include <string>
#include <vector>

namespace fulcrum::xr {
namespace {

constexpr std::array<const char*, kHands> kHandPaths{"/user/hand/left", "/user/hand/right"};
constexpr XrDuration kVibrates = 100'000'000;  // ns
constexpr double kLeastFelt = 0.005;           // of the whole

// One make of controllers, as the specification has their parts; null: that hand has none such.
struct Profile {
  const char* name;
  std::array<const char*, kHands> hold;
  std::array<const char*, kHands> stop;
};
constexpr Profile kProfiles[] = {
    {"/interaction_profiles/khr/simple_controller",
     {"/input/select/click", "/input/select/click"},
     {"/input/menu/click", "/input/menu/click"}},
    {"/interaction_profiles/oculus/touch_controller",
     {"/input/squeeze/value", "/input/squeeze/value"},
     {"/input/y/click", "/input/b/click"}},
    {"/interaction_profiles/valve/index_controller",
     {"/input/squeeze/value", "/input/squeeze/value"},
     {"/input/b/click", "/input/b/click"}},
    {"/interaction_profiles/htc/vive_controller",
     {"/input/squeeze/click", "/input/squeeze/click"},
     {"/input/menu/click", "/input/menu/click"}},
    {"/interaction_profiles/microsoft/motion_controller",
     {"/input/squeeze/click", "/input/squeeze/click"},
     {"/input/menu/click", "/input/menu/click"}},
};

}  // namespace

Hands::Hands(Session& session, bool tips) : session_(session) {
  const Instance& instance = session.instance();
  for (std::size_t hand = 0; hand < kHands; ++hand) paths_[hand] = instance.path(kHandPaths[hand]);
  auto info = structure<XrActionSetCreateInfo>(XR_TYPE_ACTION_SET_CREATE_INFO);
  std::strcpy(info.actionSetName, "tool");
  std::strcpy(info.localizedActionSetName, "The tool");
  check(xrCreateActionSet(instance.get(), &info, &set_), "name what hands do");
  try {
    grip_ = make_action(XR_ACTION_TYPE_POSE_INPUT, "grip", "Where the hand is");
    hold_ = make_action(XR_ACTION_TYPE_BOOLEAN_INPUT, "hold", "Take the tool");
    stop_ = make_action(XR_ACTION_TYPE_BOOLEAN_INPUT, "stop", "Stop the force");
    vibrate_ = make_action(XR_ACTION_TYPE_VIBRATION_OUTPUT, "vibrate", "Vibration");
    if (tips) aim_ = make_action(XR_ACTION_TYPE_POSE_INPUT, "aim", "What it points from");
    suggest_bindings();
    auto attaches = structure<XrSessionActionSetsAttachInfo>(XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO);
    attaches.countActionSets = 1;
    attaches.actionSets = &set_;
    check(xrAttachSessionActionSets(session.get(), &attaches), "listen to hands");
    for (std::size_t hand = 0; hand < kHands; ++hand) {
      grips_[hand] = make_space(grip_, hand);
      if (tips) aims_[hand] = make_space(aim_, hand);
    }
  } catch (const Failure&) {
    xrDestroyActionSet(set_);
    throw;
  }
}

Hands::~Hands() {
  for (const auto& spaces : {grips_, aims_})
    for (const XrSpace space : spaces)
      if (space != XR_NULL_HANDLE) xrDestroySpace(space);
  // The set would take them along, and layers between here and the runtime would not know.
  for (const XrAction action : {grip_, hold_, stop_, vibrate_, aim_})
    if (action != XR_NULL_HANDLE) xrDestroyAction(action);
  xrDestroyActionSet(set_);
}

XrSpace Hands::make_space(XrAction action, std::size_t hand) {
  auto info = structure<XrActionSpaceCreateInfo>(XR_TYPE_ACTION_SPACE_CREATE_INFO);
  info.action = action;
  info.subactionPath = paths_[hand];
  info.poseInActionSpace.orientation.w = 1;
  XrSpace made = XR_NULL_HANDLE;
  check(xrCreateActionSpace(session_.get(), &info, &made), "say where hands are");
  return made;
}

XrAction Hands::make_action(XrActionType type, const char* name, const char* shown) {
  auto info = structure<XrActionCreateInfo>(XR_TYPE_ACTION_CREATE_INFO);
  info.actionType = type;
  std::strcpy(info.actionName, name);
  std::strcpy(info.localizedActionName, shown);
  info.countSubactionPaths = static_cast<std::uint32_t>(paths_.size());
  info.subactionPaths = paths_.data();
  XrAction made = XR_NULL_HANDLE;
  check(xrCreateAction(set_, &info, &made), "name what hands do");
  return made;
}

void Hands::suggest_bindings() {
  const Instance& instance = session_.instance();
  for (const Profile& profile : kProfiles) {
    std::vector<XrActionSuggestedBinding> bindings;
    for (std::size_t hand = 0; hand < kHands; ++hand) {
      const auto bind = [&](XrAction action, const char* part) {
        const std::string name = std::string(kHandPaths[hand]) + part;
        bindings.push_back({action, instance.path(name.c_str())});
      };
      bind(grip_, "/input/grip/pose");
      if (aim_ != XR_NULL_HANDLE) bind(aim_, "/input/aim/pose");
      bind(hold_, profile.hold[hand]);
      bind(stop_, profile.stop[hand]);
      bind(vibrate_, "/output/haptic");
    }
    auto suggested =
        structure<XrInteractionProfileSuggestedBinding>(XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING);
    suggested.interactionProfile = instance.path(profile.name);
    suggested.countSuggestedBindings = static_cast<std::uint32_t>(bindings.size());
    suggested.suggestedBindings = bindings.data();
    const XrResult code = xrSuggestInteractionProfileBindings(instance.get(), &suggested);
    // A runtime need not know every make.
    if (code != XR_ERROR_PATH_UNSUPPORTED) check(code, "learn what hands do");
  }
}

std::optional<bool> Hands::is_down(XrAction action, std::size_t hand) {
  auto info = structure<XrActionStateGetInfo>(XR_TYPE_ACTION_STATE_GET_INFO);
  info.action = action;
  info.subactionPath = paths_[hand];
  auto state = structure<XrActionStateBoolean>(XR_TYPE_ACTION_STATE_BOOLEAN);
  const bool is_told =
      session_.goes_on(xrGetActionStateBoolean(session_.get(), &info, &state), "say what is pressed") &&
      state.isActive == XR_TRUE;
  return is_told ? std::optional(state.currentState == XR_TRUE) : std::nullopt;
}

std::array<Hand, kHands> Hands::read(const Frame& frame) {
  const XrActiveActionSet active{set_, XR_NULL_PATH};
  auto info = structure<XrActionsSyncInfo>(XR_TYPE_ACTIONS_SYNC_INFO);
  info.countActiveActionSets = 1;
  info.activeActionSets = &active;
  std::array<Hand, kHands> hands;
  const XrResult code = xrSyncActions(session_.get(), &info);
  if (!session_.goes_on(code, "listen to hands") || code == XR_SESSION_NOT_FOCUSED) return hands;
  for (std::size_t hand = 0; hand < kHands; ++hand) {
    hands[hand].X_LG = session_.locate(grips_[hand], frame);
    if (aim_ != XR_NULL_HANDLE)
      if (const auto X_LA = session_.locate(aims_[hand], frame, Session::Sight::now))
        hands[hand].tip_L = X_LA->p;
    const std::optional<bool> holds = is_down(hold_, hand);
    hands[hand].is_known = holds.has_value();
    hands[hand].holds = holds.value_or(false);
    hands[hand].stops = is_down(stop_, hand).value_or(false);
  }
  return hands;
}

void Hands::vibrate(std::size_t hand, double strength, double frequency_Hz) {
  auto info = structure<XrHapticActionInfo>(XR_TYPE_HAPTIC_ACTION_INFO);
  info.action = vibrate_;
  info.subactionPath = paths_[hand];
  const bool felt = strength >= kLeastFelt;
  if (felt) {
    auto vibration = structure<XrHapticVibration>(XR_TYPE_HAPTIC_VIBRATION);
    vibration.amplitude = static_cast<float>(strength);
    vibration.frequency = static_cast<float>(frequency_Hz);
    vibration.duration = kVibrates;
    session_.goes_on(
        xrApplyHapticFeedback(session_.get(), &info, reinterpret_cast<const XrHapticBaseHeader*>(&vibration)),
        "let a hand feel");
  } else if (vibrates_[hand]) {
    session_.goes_on(xrStopHapticFeedback(session_.get(), &info), "let a hand rest");
  }
  vibrates_[hand] = felt;
}

}  // namespace fulcrum::xr
