#pragma once
// A headset as long as one session of its runtime lasts: when to draw, for which eyes, and what hands do.

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "engine/headset/headset_stage.h"
#include "engine/headset/panel.h"
#include "engine/xr/credible.h"
#include "engine/xr/hand_tracking.h"
#include "engine/xr/hands.h"
#include "engine/xr/pinch.h"
#include "engine/xr/session.h"
#include "engine/xr/swapchain.h"

namespace fulcrum::headset {

class Worn {
public:
  // What is asked for of hands beside what controllers do.
  struct Asked {
    bool tips = false;   // where the controllers' tips are
    bool hands = false;  // without controllers: what they do is what counts, but for controllers' stops
  };

  // The stage has a scene, and outlives it. Throws xr::Failure.
  Worn(HeadsetStage& stage, xr::Space space, Asked asked);

  xr::Session& session() { return session_; }

  // Waits until it is time to draw. None: the session has been lost.
  std::optional<xr::Frame> begin_frame();
  // Of that frame. None: nobody knows where the head is.
  std::optional<std::array<xr::EyeView, 2>> eyes(const xr::Frame& frame);
  std::array<xr::Hand, xr::kHands> hands(const xr::Frame& frame);
  void vibrate(std::size_t hand, double strength, double frequency_Hz) {
    hands_.vibrate(hand, strength, frequency_Hz);
  }

  // Writes anew what a panel says, which is shown from then on.
  std::optional<Error> say(Panel& panel, const ui::OverlayState& state);

  // Draws what the eyes see, and shows it, and over it the panel. state: with those eyes' cameras. late: the
  // scene's poses as late as may be. False: the runtime took no picture, and the frame has not ended.
  Result<bool> show(const xr::Frame& frame, const std::array<xr::EyeView, 2>& eyes,
                    const render::FrameState& state, const PanelPlace& panel, const render::LatePoses& late);
  // Shows nothing.
  void show_nothing(const xr::Frame& frame) { session_.end_frame(frame, {}); }

private:
  // The pictures are as large as the runtime would have them whenever it begins to show some.
  std::optional<Error> fit();

  HeadsetStage& stage_;
  xr::Session session_;
  xr::Hands hands_;
  std::unique_ptr<xr::HandTracking> tracking_;  // null: not asked for
  std::array<xr::Pinch, xr::kHands> pinches_;
  std::array<xr::Sighting, xr::kHands> sightings_;
  std::unique_ptr<xr::Swapchain> pictures_;  // both eyes side by side; null before the first
  std::unique_ptr<xr::Swapchain> sheet_;     // null: nothing is said
  int fitted_ = 0;                           // Session::times_begun() that they are of
};

}  // namespace fulcrum::headset
