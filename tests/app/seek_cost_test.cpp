// What looking back costs: to go to a moment of a trial of 90 s and to have all that a frame shows of it,
// against drawing that frame, in processor time of the same run.

#include <gtest/gtest.h>

#include <ctime>

#include "engine/app/picture/bridge.h"
#include "engine/app/prepare/chosen_view.h"
#include "engine/app/window/review.h"
#include "engine/render/renderer.h"
#include "engine/vulkan/device.h"
#include "engine/vulkan/instance.h"

namespace fulcrum::app {
namespace {

// Of all threads: llvmpipe draws in several. s.
double processor_s() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

TEST(SeekCost, IsAtMostAFrameAndMemoryIsBounded) {
  const std::optional<Prepared> stick = prepare("stick", std::vector<std::string>());
  ASSERT_TRUE(stick);
  const SceneDesc& scene = stick->haptic.scene;
  const double tick_s = scene.tick_s;
  RunSink sink(*stick, std::nullopt, 90);
  Review review(tick_s);
  // Touched and left again twice a second: as many events as a restless hand makes.
  for (std::int64_t tick = 0; sink.end() == RunSink::End::running; ++tick) {
    TickEvent event;
    event.record.tick = tick;
    event.record.X_WT.p = Vec3(0.1 * static_cast<double>(tick % 1000) * tick_s, 0.2, 0);
    const bool touches = static_cast<std::int64_t>(static_cast<double>(tick) * tick_s * 4) % 2 == 0;
    event.record.contact_F_T_W.force = Vec3(0, touches ? 1 : 0, 0);
    sink.take(event);
    review.add(event.record, sink.time());
  }
  ASSERT_NEAR(sink.time(), 90, 0.01);
  ASSERT_GT(review.events(sink).size(), 100U);
  // By construction: so many frames of one tick's record each, however long the trial.
  EXPECT_LE(Film::kMost * sizeof(TickRecord), 16U << 20);

  const auto visual = assemble_view(*stick, scene, "");
  ASSERT_TRUE(visual);
  const auto instance = vulkan::Instance::create({});
  ASSERT_TRUE(instance) << instance.error().sentence;
  const auto device = vulkan::Device::create(*instance, "llvmpipe");
  ASSERT_TRUE(device) << device.error().sentence;
  const auto renderer = render::Renderer::create(**device, visual->desc, {{640, 360}, {1, 0, 1.0F}, {}});
  ASSERT_TRUE(renderer) << renderer.error().sentence;
  FrameBridge bridge(visual->desc, stick->scenario, scene);

  double seek_s = 0, draw_s = 0;
  constexpr int kSeeks = 40;
  for (int i = 0; i < kSeeks; ++i) {
    const double begun = processor_s();
    review.go_to(90.0 * ((i * 17) % kSeeks) / kSeeks, sink);
    const ui::Timeline timeline = review.timeline(sink, plot_limits(scene, stick->haptic.task));
    const ui::OverlayState overlay = overlay_state(*stick, scene, review.record(), sink.afterglow(),
                                                   review.task(sink, stick->haptic.task));
    const render::FrameState frame =
        bridge.frame(review.record(), sink.afterglow(), review.task(sink, stick->haptic.task),
                     visual->desc.camera, overlay.time_s);
    const double sought = processor_s();
    ASSERT_EQ(timeline.plots.size(), 4U);
    ASSERT_FALSE((*renderer)->frame(frame));
    if (i < 4) continue;  // the driver compiles shaders while it draws the first ones
    seek_s += sought - begun;
    draw_s += processor_s() - sought;
  }
  EXPECT_LT(seek_s, draw_s);
  RecordProperty("seek_over_frame", std::to_string(seek_s / draw_s));
}

}  // namespace
}  // namespace fulcrum::app
