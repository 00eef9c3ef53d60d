#include "engine/app/window/training_window.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <utility>

#include "engine/app/cli/interrupt.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/picture/holding_controls.h"
#include "engine/app/picture/target_view.h"
#include "engine/app/run/debrief.h"
#include "engine/app/run/headless_run.h"
#include "engine/app/window/key_help.h"
#include "engine/record/percentiles.h"
#include "engine/ui/cue_panel.h"
#include "engine/ui/holding_panel.h"

namespace fulcrum::app {
namespace {

constexpr std::size_t kCostWindow = 1000;  // ticks that the shown percentiles are of
constexpr double kAboutShown = 20;         // s of the trial, at the most

// What a key asks of the panel of the holding point.
std::optional<HoldingKey> holding_key(int key) {
  switch (key) {
    case GLFW_KEY_LEFT_BRACKET:
      return HoldingKey::nearer;
    case GLFW_KEY_RIGHT_BRACKET:
      return HoldingKey::farther;
    case GLFW_KEY_MINUS:
      return HoldingKey::softer;
    case GLFW_KEY_EQUAL:
      return HoldingKey::stiffer;
    case GLFW_KEY_N:
      return HoldingKey::method;
    case GLFW_KEY_H:
      return HoldingKey::measured;
    default:
      return std::nullopt;
  }
}

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
  resting_ = false;
  review_ = Review(scene_->tick_s);
  debrief_.reset();
  tool_mouse_.reset(scene_->tool.X_WT_start * scene_->tool.X_HT.inverse());
}

void TrainingWindow::listen() {
  ui::WindowEvents events;
  events.key = [this](int key, int action, int modifiers) {
    shift_ = (modifiers & GLFW_MOD_SHIFT) != 0;
    control_ = (modifiers & GLFW_MOD_CONTROL) != 0;
    on_key(key, action);
  };
  events.button = [this](int button, int action, int modifiers) {
    shift_ = (modifiers & GLFW_MOD_SHIFT) != 0;
    button_ = action == GLFW_PRESS ? button : -1;
    slides_ = scrubs_ = false;
    if (button_ == GLFW_MOUSE_BUTTON_LEFT) on_press();
    stage_.window().hold_pointer(button_ >= 0);
  };
  events.cursor = [this](double x, double y) { on_cursor(x, y); };
  events.scroll = [this](double, double steps) { on_scroll(steps); };
  stage_.window().set_events(std::move(events));
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

void TrainingWindow::on_buttons(std::uint32_t down) {
  const std::uint32_t pressed = down & ~std::exchange(buttons_, down);
  if ((pressed & stop_buttons_) != 0) loop_->send({Command::Kind::stop});
  if ((pressed & go_buttons_) != 0) loop_->send({Command::Kind::acknowledge});
}

void TrainingWindow::on_press() {
  scrub(false);
  if (scrubs_) return;
  const std::optional<Command> pressed = cues_.press(shown_, stage_.window().pixels(), cursor_x_, cursor_y_);
  send(pressed);
  const ui::PanelPoint at = ui::panel_point(stage_.window().pixels(), cursor_x_, cursor_y_);
  const auto held = ui::pressed_holding(shown_, at.width, at.x, at.y);
  if (held) send(holding_commands(*shown_.holding, *held));
  slides_ = held && held->part == ui::HoldingPress::Part::place;
  if (pressed || held) button_ = -1;  // a press on a panel drags nothing in the scene
}

bool TrainingWindow::look_back(int key) {
  if (!resting_) return false;
  const auto pressed = [&]() -> std::optional<Review::Key> {
    switch (key) {
      case GLFW_KEY_LEFT:
        return Review::Key::back;
      case GLFW_KEY_RIGHT:
        return Review::Key::on;
      case GLFW_KEY_PAGE_UP:
        return Review::Key::before;
      case GLFW_KEY_PAGE_DOWN:
        return Review::Key::after;
      case GLFW_KEY_SPACE:
        return Review::Key::card;
      default:
        return std::nullopt;
    }
  }();
  if (pressed) review_.press(*pressed, *sink_, shift_);
  return pressed.has_value();
}

void TrainingWindow::scrub(bool dragged) {
  const auto time =
      ui::timeline_time(shown_, stage_.window().pixels(), cursor_x_, cursor_y_, dragged && scrubs_);
  scrubs_ = time.has_value();
  if (time) review_.go_to(*time, *sink_);
}

void TrainingWindow::on_key(int key, int action) {
  // A modifier's own event comes with the state before it.
  if (key == GLFW_KEY_LEFT_SHIFT || key == GLFW_KEY_RIGHT_SHIFT) shift_ = action != GLFW_RELEASE;
  if (key == GLFW_KEY_LEFT_CONTROL || key == GLFW_KEY_RIGHT_CONTROL) control_ = action != GLFW_RELEASE;
  if (keys_ != nullptr) {
    const bool moves = tool_keys_.note(key, action);
    keys_->push(tool_keys_.axes(shift_));
    if (moves) return;
  }
  if (action != GLFW_RELEASE && look_back(key)) return;
  if (action != GLFW_PRESS) return;
  switch (key) {
    case GLFW_KEY_ESCAPE:
      loop_->send({Command::Kind::stop});
      break;
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
      loop_->send({Command::Kind::acknowledge});
      break;
    case GLFW_KEY_R:
      leave_ = Leave::restart;
      break;
    case GLFW_KEY_F10:
      if (has_start_page_) leave_ = Leave::start_page;
      break;
    case GLFW_KEY_C:
      circle_shown_ = !circle_shown_;
      break;
    case GLFW_KEY_F1:
      keys_visible_ = !keys_visible_;
      break;
    case GLFW_KEY_F2:
      guides_ = !guides_;
      break;
    case GLFW_KEY_F3:
      figures_visible_ = !figures_visible_;
      break;
    case GLFW_KEY_HOME:
      camera_.reset();
      break;
    default:
      if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z)
        send(cues_.toggle(static_cast<char>('A' + (key - GLFW_KEY_A)), shown_));
      if (const auto holding = holding_key(key); holding && shown_.holding)
        send(holding_commands(*shown_.holding, *holding));
      if (key >= GLFW_KEY_1 && key <= GLFW_KEY_9) {
        const auto view = static_cast<std::size_t>(key - GLFW_KEY_1);
        if (view < visual_.views.size()) {
          camera_ = render::OrbitCamera(visual_.views[view].camera);
          view_ = view;
        }
      }
  }
}

void TrainingWindow::send(const std::optional<Command>& command) {
  if (command) loop_->send(*command);
}

void TrainingWindow::send(const std::vector<Command>& commands) {
  for (const Command& command : commands) loop_->send(command);
}

void TrainingWindow::on_cursor(double x, double y) {
  const double dx = x - std::exchange(cursor_x_, x), dy = y - std::exchange(cursor_y_, y);
  if (slides_ && shown_.holding) {
    const ui::PanelPoint at = ui::panel_point(stage_.window().pixels(), cursor_x_, cursor_y_);
    send(holding_commands(*shown_.holding,
                          {ui::HoldingPress::Part::place, ui::dragged_place(shown_, at.width, at.x)}));
  }
  if (scrubs_) scrub(true);
  if (button_ < 0 || scrubs_) return;
  const bool moves_tool = mouse_ != nullptr && button_ != GLFW_MOUSE_BUTTON_MIDDLE && !resting_;
  if (moves_tool && tool_rests()) return;
  if (moves_tool) {
    const input::ViewAxes view = view_axes(camera_.camera(), tool_mouse_.X_WH().p);
    if (button_ == GLFW_MOUSE_BUTTON_LEFT)
      tool_mouse_.slide(view, dx, dy);
    else if (shift_)
      tool_mouse_.roll(view, dx);
    else
      tool_mouse_.turn(view, dx, dy);
    mouse_->aim(tool_mouse_.X_WH());
  } else if (shift_) {
    camera_.pan(static_cast<float>(dx), static_cast<float>(dy));
  } else {
    camera_.orbit(static_cast<float>(dx), static_cast<float>(dy));
  }
}

void TrainingWindow::on_scroll(double steps) {
  if (control_ || mouse_ == nullptr || resting_) {
    camera_.zoom(static_cast<float>(steps));
    return;
  }
  if (tool_rests()) return;
  const input::ViewAxes view = view_axes(camera_.camera(), tool_mouse_.X_WH().p);
  tool_mouse_.reach(view, steps, shift_ ? input::Step::fine : input::Step::whole);
  mouse_->aim(tool_mouse_.X_WH());
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
  if (*drawn && quality_.add(stage_.renderer().last_frame_s())) {
    if (const auto error = stage_.renderer().set_quality(quality_.quality())) error_ = error->sentence;
  }
}

}  // namespace fulcrum::app
