#include "tests/xr/runtime/headset.h"

#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "engine/xr/pose.h"
#include "tests/drivers_vendor/stand_in.h"
#include "tests/xr/runtime/log.h"

namespace runtime {
namespace {

constexpr double kHeadHeight = 1.5;  // m, of local space over the floor
constexpr int kTimesGone = 4;
constexpr XrTime kTimeToMove = 30'000'000;  // ns: programs are told before local space moves

std::size_t hand_in(const std::vector<std::string>& words) {
  return words.at(0) == "right" ? 1 : 0;
}

template <class T>
void push(const T& event) {
  XrEventDataBuffer buffer{};
  static_assert(sizeof(T) <= sizeof(buffer));
  reinterpret_cast<T&>(buffer) = event;
  headset->events.push_back(buffer);
}

void recenter(const Pose& moved) {
  headset->X_LL_next = headset->X_LL * moved;
  headset->moves_at = headset->time + kTimeToMove;
  auto event = fulcrum::xr::structure<XrEventDataReferenceSpaceChangePending>(
      XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING);
  event.session = handle_of<XrSession>(headset->session.get());
  event.referenceSpaceType = XR_REFERENCE_SPACE_TYPE_LOCAL;
  event.changeTime = *headset->moves_at;
  push(event);
}

// Of the library that the program has loaded.
fulcrum::stand_in::Handle& handle_in_hand() {
  void* const library = dlopen("libHD.so", RTLD_NOW | RTLD_NOLOAD);
  void* const found = library != nullptr ? dlsym(library, "stand_in_handle") : nullptr;
  if (found != nullptr) return *reinterpret_cast<fulcrum::stand_in::Handle* (*)()>(found)();
  std::fprintf(stderr, "The script moves a handle, and the program has none of the tests' own.\n");
  std::_Exit(70);
}

void move_handle(const std::vector<std::string>& words) {
  fulcrum::stand_in::Handle& handle = handle_in_hand();
  const std::lock_guard lock(handle.mutex);
  for (std::size_t i = 0; i < 3; ++i) handle.p[i] = 1e3 * std::stod(words.at(i));  // mm
  headset->handle_told_by = handle.turns + 3;  // one of them began after this
}

bool handle_is_told() {
  if (headset->handle_told_by == 0) return true;
  fulcrum::stand_in::Handle& handle = handle_in_hand();
  const std::lock_guard lock(handle.mutex);
  if (handle.turns < headset->handle_told_by) return false;
  headset->handle_told_by = 0;
  log("the handle is there");
  return true;
}

void happen(const Event& event) {
  const std::vector<std::string>& words = event.words;
  Headset& h = *headset;
  if (event.what == "head") {
    h.X_LH = fulcrum::xr::pose_of(pose_in(words, 0));
  } else if (event.what == "hand") {
    h.X_LG[hand_in(words)] = fulcrum::xr::pose_of(pose_in(words, 1));
    h.in_hand[hand_in(words)] = true;
  } else if (event.what == "guess" || event.what == "track") {
    h.guessed[hand_in(words)] = event.what == "guess";
  } else if (event.what == "bare") {
    h.bare[hand_in(words)].X_LP = fulcrum::xr::pose_of(pose_in(words, 1));
    h.bare[hand_in(words)].there = true;
  } else if (event.what == "tips") {
    h.bare[hand_in(words)].to_index = 1e-3 * std::stod(words.at(1));
    h.bare[hand_in(words)].to_little = 1e-3 * std::stod(words.at(2));
  } else if (event.what == "cover" || event.what == "uncover") {
    h.bare[hand_in(words)].covered = event.what == "cover";
  } else if (event.what == "spoil") {
    h.bare[hand_in(words)].spoilt = words.at(1) == "well" ? "" : words.at(1);
  } else if (event.what == "handle") {
    move_handle(words);
  } else if (event.what == "sleep" || event.what == "wake") {
    h.sleeps[hand_in(words)] = event.what == "sleep";
  } else if (event.what == "press" || event.what == "release") {
    h.pressed[hand_in(words)][words.at(1)] = event.what == "press";
  } else if (event.what == "hide") {
    go_to(XR_SESSION_STATE_VISIBLE);
  } else if (event.what == "show") {
    go_to(XR_SESSION_STATE_FOCUSED);
  } else if (event.what == "blind" || event.what == "sees") {
    h.blind = event.what == "blind";
  } else if (event.what == "dark" || event.what == "light") {
    h.dark = event.what == "dark";
  } else if (event.what == "stall" || event.what == "flow") {
    h.stalls = event.what == "stall";
  } else if (event.what == "recenter") {
    recenter(fulcrum::xr::pose_of(pose_in(words, 0)));
  } else if (event.what == "size") {
    h.script.width = static_cast<std::uint32_t>(std::stoul(words.at(0)));
    h.script.height = static_cast<std::uint32_t>(std::stoul(words.at(1)));
  } else if (event.what == "rest" || event.what == "exit") {
    (event.what == "rest" ? h.session->rests : h.session->exits) = true;
    go_to(XR_SESSION_STATE_STOPPING);
  } else if (event.what == "lose") {
    lose();
  } else if (event.what == "break") {
    h.session->breaks = true;
  } else if (event.what == "pending") {
    h.gone = kTimesGone;
    go_to(XR_SESSION_STATE_LOSS_PENDING);
  } else if (event.what == "ending") {
    auto ending =
        fulcrum::xr::structure<XrEventDataInstanceLossPending>(XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING);
    ending.lossTime = h.time + kTimeToMove;
    push(ending);
  } else if (event.what == "die") {
    h.dead = true;
  } else if (event.what == "wait") {
    h.waits_for = words.at(0);
  } else if (event.what == "hang") {
    h.hangs_for = words.at(0);
    h.hangs_in = words.size() > 1 ? words[1] : "xrWaitFrame";
  }
}

}  // namespace

std::unique_ptr<Headset> headset;

void go_to(XrSessionState state) {
  headset->session->state = state;
  auto event =
      fulcrum::xr::structure<XrEventDataSessionStateChanged>(XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED);
  event.session = handle_of<XrSession>(headset->session.get());
  event.state = state;
  event.time = headset->time;
  push(event);
}

void lose() {
  headset->session->lost = true;
  headset->gone = kTimesGone;
}

void advance() {
  Headset& h = *headset;
  h.time += 11'111'111;
  if (h.moves_at && h.time >= *h.moves_at) {
    h.X_LL = h.X_LL_next;
    h.moves_at.reset();
  }
  ++h.session->frames;
  if (!h.waits_for.empty()) {
    if (!std::filesystem::exists(h.waits_for)) return;
    h.waits_for.clear();
  }
  if (!handle_is_told()) return;
  ++h.frame;
  while (h.next_event < h.script.events.size() && h.script.events[h.next_event].frame <= h.frame)
    happen(h.script.events[h.next_event++]);
}

Pose pose_of(const Space& space) {
  const Headset& h = *headset;
  switch (space.kind) {
    case Space::Kind::view:
      return h.X_LH * space.offset;
    case Space::Kind::local:
      return h.X_LL * space.offset;
    case Space::Kind::grip:
      return h.X_LG[space.hand] * space.offset;
    default:
      return Pose{fulcrum::Quat::Identity(), fulcrum::Vec3(0, -kHeadHeight, 0)} * space.offset;
  }
}

std::array<XrView, 2> views_in(const Space& space) {
  const Script& script = headset->script;
  const auto& [left, right, up, down] = script.fov;
  const Pose X_SH = pose_of(space).inverse() * headset->X_LH;
  std::array<XrView, 2> views;
  for (std::size_t eye = 0; eye < views.size(); ++eye) {
    const double side = (eye == 0 ? -0.5 : 0.5) * static_cast<double>(script.eyes_apart);
    views[eye] = fulcrum::xr::structure<XrView>(XR_TYPE_VIEW);
    views[eye].pose = fulcrum::xr::to_xr(X_SH * Pose{fulcrum::Quat::Identity(), fulcrum::Vec3(side, 0, 0)});
    views[eye].fov = eye == 0 ? XrFovf{left, right, up, down} : XrFovf{-right, -left, up, down};
  }
  return views;
}

}  // namespace runtime
