#pragma once
// An overlay over an empty scene, and a state of it that has something at every edge.

#include <gtest/gtest.h>

#include <memory>
#include <optional>

#include "engine/ui/overlay.h"
#include "test_scene.h"

namespace fulcrum::ui {

inline OverlayState full_state() {
  OverlayState state;
  state.scenario = "Piping";
  state.force_N = {4.0, 8.0};
  state.torque_Nm = {0.05, 0.2};
  state.checkpoints = {
      {"Reach", {render::MarkerState::Show::done, 1.0F}},
      {"Turn, and a name that is much too long for its line", {render::MarkerState::Show::dwelling, 0.5F}}};
  state.device = "Simulated hand";
  state.message = "Hold still.";
  state.keys = {{"Esc", "Stop all force"}};
  state.mapping = {"The mouse moves the tool."};
  return state;
}

class OverlayTest : public testing::Test {
protected:
  void TearDown() override {
    for (const std::string& message : gpu_.instance.messages()) ADD_FAILURE() << message;
  }

  render::Picture draw(const OverlayState& state) {
    const std::optional<vulkan::Error> error = overlay_->prepare(state, renderer_->plan().picture);
    EXPECT_FALSE(error) << error->sentence;
    render::FrameState frame;
    frame.overlay = overlay_.get();
    EXPECT_FALSE(renderer_->frame(frame));
    return *renderer_->read_back();
  }

  test::Gpu gpu_ = test::make_gpu();
  render::RenderOptions options_{{640, 360}, {1, 0, 1.0F}, {}};
  std::unique_ptr<render::Renderer> renderer_ =
      std::move(*render::Renderer::create(*gpu_.device, {}, options_));
  std::unique_ptr<Overlay> overlay_ = std::move(*Overlay::create(*gpu_.device));
};

}  // namespace fulcrum::ui
