#include "engine/app/window/training_window.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "engine/app/cli/interrupt.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/picture/target_view.h"
#include "engine/app/run/debrief.h"
#include "engine/app/run/headless_run.h"
#include "engine/app/window/key_help.h"
#include "engine/record/percentiles.h"

namespace fulcrum::app {
namespace {

constexpr std::size_t kCostWindow = 1000;  // ticks that the shown percentiles are of
constexpr double kAboutShown = 20;         // s of the trial, at the most

// m: what the trainee has to hit most exactly; where there is no task, a twentieth of the tool.
double finest_detail(const Prepared& prepared) {
  double finest = prepared.haptic.scene.tool_shell->max_radius_m / 20;
  const std::vector<scenario::Checkpoint>& checkpoints = prepared.haptic.task.checkpoints;
  if (!checkpoints.empty()) finest = std::ranges::min(checkpoints, {}, &scenario::Checkpoint::radius).radius;
  return finest;
}

}  // namespace

TrainingWindow::TrainingWindow(WindowStage& stage, const Prepared& prepared,
                               const scenario::VisualAssembly& visual, const session::TrialMetrics* expert,
                               bool has_start_page)
    : stage_(stage),
      prepared_(prepared),
      visual_(visual),
      camera_(visual.desc.camera),
      bridge_(visual.desc, prepared.scenario, prepared.haptic.scene),
      tool_mouse_(input::mouse_steps(finest_detail(prepared))),
      expert_(expert),
      has_start_page_(has_start_page) {}

Result<std::unique_ptr<TrainingWindow>> TrainingWindow::create(WindowStage& stage, const Prepared& prepared,
                                                               const scenario::VisualAssembly& visual,
                                                               const RunOptions& options,
                                                               const session::TrialMetrics* expert,
                                                               bool has_start_page) {
  std::unique_ptr<TrainingWindow> self(new TrainingWindow(stage, prepared, visual, expert, has_start_page));
  self->circle_ = options.circle;
  const auto named = std::ranges::find(visual.views, options.view, &scenario::View::name);
  if (named != visual.views.end()) self->view_ = static_cast<std::size_t>(named - visual.views.begin());
  if (auto error = stage.set_scene(visual.desc, self->quality_.quality())) return *error;
  return self;
}

void TrainingWindow::begin(const World& world, OpenDevice& device, const RunSink& sink) {
  scene_ = &world.desc();
  sink_ = &sink;
  mouse_ = device.mouse;
  rate_ = device.rate;
  keys_ = device.keys.get();
  tool_keys_.let_go();
  stop_buttons_ = device.stop_buttons;
  go_buttons_ = device.go_buttons;
  buttons_ = 0;
  leave_.reset();
  slides_ = scrubs_ = false;
  button_ = -1;  // a release while no window listened is not told
  shown_ = {};
  cues_ = CueSwitches(*scene_);
  cpu_ns_.clear();
  cpu_at_ = 0;
  late_ = lost_ = 0;
  trouble_ = TickTrouble(scene_->tick_s);
  frame_rate_ = {};
  resting_ = false;
  review_ = Review(scene_->tick_s);
  debrief_.reset();
  tool_mouse_.reset(scene_->tool.X_WT_start * scene_->tool.X_HT.inverse());
}

TrainingWindow::Leave TrainingWindow::run(World& world, OpenDevice& device, RunSink& sink,
                                          const ProgramFaults& faults) {
  LiveLoop loop(world, *device.device);
  loop_ = &loop;
  begin(world, device, sink);
  listen();
  draw(sink, loop);  // the first frame takes long, and its picture is where all begins: before the clock runs
  loop.start();
  while (!stage_.window().closing() && !leave_ && !interrupted() && error_.empty()) {
    stage_.window().poll();
    TickEvent event;
    while (loop.next(event)) {
      on_buttons(event.sample.buttons);
      if (sink.end() != RunSink::End::running) continue;
      note_cost(event);
      sink.take(event);
      review_.add(event.record, sink.time());
    }
    sink.flush_if_due();
    if (faults.gpu_lost()) stage_.gpu().lose();
    if (sink.end() != RunSink::End::running) {
      if (!debrief_) debrief_ = debrief(prepared_, sink, expert_, has_start_page_);
      come_to_rest(loop);
    } else {
      late_ = loop.late_ticks();
      lost_ = loop.lost_ticks();
      trouble_.note(static_cast<std::uint64_t>(loop.newest().tick), late_, lost_);
    }
    draw(sink, loop);
  }
  loop.stop();
  if (review_.is_shown()) {  // the attempt's picture is of its last moment
    review_.press(Review::Key::card, sink, false);
    shown_ = overlay_of(sink.last(), sink, stage_.window().pixels());
  }
  stage_.window().hold_pointer(false);
  stage_.window().set_events({});
  if (stage_.window().lost())
    complain(
        "the window is gone, for its X server ended or another program closed it: the run ends here, "
        "and what it recorded is kept.");
  else if (!error_.empty())
    complain(error_);
  report_grant(loop);
  return leave_.value_or(Leave::closed);
}

void TrainingWindow::come_to_rest(LiveLoop& loop) {
  if (!resting_) resting_ = loop.send({Command::Kind::stop});
  const TickRecord& newest = loop.newest();
  if (newest.stopped && newest.device_F_H_D.is_zero()) loop.stop();
}

void TrainingWindow::note_cost(const TickEvent& event) {
  if (cpu_ns_.size() < kCostWindow)
    cpu_ns_.push_back(event.cpu_ns);
  else
    cpu_ns_[cpu_at_] = event.cpu_ns;
  cpu_at_ = (cpu_at_ + 1) % kCostWindow;
}

std::string TrainingWindow::message(const RunSink& sink) const {
  if (sink.end() != RunSink::End::running) return {};
  if (sink.handle_is_still()) return StillHandle::kSentence;
  const bool begins = sink.task().step == 0 && sink.time() < kAboutShown;
  return begins ? prepared_.scenario.about : std::string();
}

scenario::TaskState TrainingWindow::task_shown(const RunSink& sink) const {
  return review_.is_shown() ? review_.task(sink) : sink.task();
}

ui::OverlayState TrainingWindow::overlay_of(const TickRecord& record, const RunSink& sink,
                                            render::Extent size) const {
  ui::OverlayState state = overlay_state(prepared_, *scene_, record, sink.afterglow(), task_shown(sink));
  if (state.trial) state.trial->limit_s = sink.limit();
  if (sink.end() != RunSink::End::running) {
    state.timeline = review_.timeline(sink);
    if (!review_.is_shown()) state.debrief = debrief_;
  } else if (guides_)
    state.target = target_view(camera_.camera(), size, record, prepared_.haptic.task, sink.task());
  state.figures_visible = figures_visible_;
  state.ticks = tick_health();
  state.hint = "F1: keys";
  if (view_ < visual_.views.size()) state.view = view_name(visual_.views[view_]);
  state.message = message(sink);
  state.keys_visible = keys_visible_;
  state.keys = key_lines(state, visual_.views, circle_, has_start_page_);
  if (mouse_ != nullptr) {
    for (const char* line : input::mouse_help()) state.mapping.emplace_back(line);
    return state;
  }
  if (keys_ != nullptr) state.mapping = ToolKeys::help();
  for (const char* line : {"Drag: look around", "Shift + drag: move the view", "Wheel: zoom"})
    state.mapping.emplace_back(line);
  return state;
}

ui::TickHealth TrainingWindow::tick_health() const {
  ui::TickHealth ticks{.rate_Hz = 1.0 / scene_->tick_s,
                       .frames_per_s = frame_rate_.of_late(),
                       .late = late_,
                       .lost = lost_,
                       .trouble = trouble_.is_there() && !resting_};
  if (figures_visible_ && !cpu_ns_.empty()) {
    std::vector<std::int64_t> sorted = cpu_ns_;
    const record::TickCpu cpu = record::tick_cpu_percentiles(sorted);
    ticks.cpu_p50_us = cpu.p50;
    ticks.cpu_p99_us = cpu.p99;
  }
  return ticks;
}

void TrainingWindow::show_to_device(const TickRecord& record) {
  if (rate_ != nullptr) rate_->look(seen_frame(camera_.camera(), record.X_WT.p, tool_rests() || resting_));
}

render::FrameState TrainingWindow::frame_of(const TickRecord& record, const RunSink& sink) {
  render::FrameState frame = bridge_.frame(record, circle_shown_ ? sink.afterglow() : Afterglow(),
                                           task_shown(sink), camera_.camera(), shown_.time_s);
  frame.overlay = &stage_.overlay();
  return frame;
}

Result<std::filesystem::path> TrainingWindow::save_picture(const RunSink& sink,
                                                           const std::filesystem::path& file) {
  if (auto error = stage_.overlay().prepare(shown_, stage_.renderer().plan().picture)) return *error;
  if (auto error = stage_.renderer().frame(frame_of(sink.last(), sink))) return *error;
  const auto picture = stage_.renderer().read_back();
  if (!picture) return picture.error();
  if (auto error = render::write_png(file, *picture)) return *error;
  return file;
}

void TrainingWindow::draw(const RunSink& sink, LiveLoop& loop) {
  const render::Extent size = stage_.window().pixels();
  if (size.width == 0 || size.height == 0) return;
  // The newest tick; the sink's where there is none yet, and its last one after the end.
  const TickRecord& newest = loop.newest();
  const bool running = sink.end() == RunSink::End::running;
  const TickRecord& record = review_.is_shown()                          ? review_.record()
                             : running && newest.tick > sink.last().tick ? newest
                                                                         : sink.last();
  shown_ = overlay_of(record, sink, size);
  show_to_device(record);
  if (const auto error = stage_.overlay().prepare(shown_, size)) {
    error_ = error->sentence;
    return;
  }
  const auto drawn = stage_.renderer().frame(frame_of(record, sink), stage_.swapchain(), size);
  if (!drawn) {
    error_ = drawn.error().sentence;
    return;
  }
  if (*drawn && running)
    frame_rate_.note(
        std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count());
  if (*drawn && quality_.add(stage_.renderer().last_frame_s())) {
    if (const auto error = stage_.renderer().set_quality(quality_.quality())) error_ = error->sentence;
  }
}

}  // namespace fulcrum::app
