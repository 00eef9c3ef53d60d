// Four views of piping against goldens. To look at new ones: run, open tests/failures in the build folder,
// and copy
// *.actual.png over the golden if that is what the change was for; say why in the commit.

#include <gtest/gtest.h>

#include "engine/app/picture.h"
#include "image_compare.h"
#include "tests/piping/piping.h"

namespace fulcrum::test {
namespace {

void expect_golden(const std::string& view_name, const TickRecord& record, const scenario::TaskState& task) {
  const Result<scenario::VisualAssembly> visual =
      scenario::assemble_visual(piping().scenario, piping().models);
  ASSERT_TRUE(visual) << visual.error().sentence;
  app::Moment moment{record, task, visual->desc.camera};
  for (const scenario::View& view : visual->views) {
    if (view.name == view_name) moment.camera = view.camera;
  }
  app::RunOptions options;
  options.size = {640, 360};
  options.gpu = "llvmpipe";
  options.validate = true;
  const std::filesystem::path folder = FULCRUM_FAILURES;
  std::filesystem::create_directories(folder);
  const std::filesystem::path file = folder / (view_name + ".png");
  const auto drawn =
      app::draw_picture(piping(), piping().haptic.scene, *visual, moment, options, file, nullptr);
  ASSERT_TRUE(drawn) << drawn.error().sentence;
  const auto picture = read_png(file);
  ASSERT_TRUE(picture) << picture.error();
  const Comparison comparison =
      compare(picture.value(), std::filesystem::path(FULCRUM_GOLDENS) / (view_name + ".png"),
              {.failure_folder = folder});
  EXPECT_TRUE(comparison.passed) << comparison.sentence;
}

// The tool where the route has it, the task part of the way: pictures that do not depend on a run.
TEST(Picture, Piping) {
  const scenario::HandScript* expert = nullptr;
  for (const scenario::HandScript& hand : piping().haptic.hands) {
    if (hand.name == "expert") expert = &hand;
  }
  ASSERT_NE(expert, nullptr);
  const HandPath path(expert->waypoints);
  scenario::TaskState task;
  task.reached.resize(piping().haptic.task.checkpoints.size());
  task.step = 2;
  task.inside = true;
  task.dwell_progress = 0.6;
  TickRecord record;
  record.tick = 14000;
  record.force_gain = 1;
  record.X_WT = path.at(14.0);
  record.coupling_F_T_W.torque = Vec3(0.02, 0, 0);
  record.device_F_H_D.force = Vec3(0.4, 0.3, 0);
  for (const char* view : {"overview", "slot", "behind", "above"}) expect_golden(view, record, task);
}

}  // namespace
}  // namespace fulcrum::test
