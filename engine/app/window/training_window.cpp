#include "engine/app/window/training_window.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "drivers/registry.h"
#include "engine/app/cli/interrupt.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/picture/target_view.h"
#include "engine/app/run/debrief.h"
#include "engine/app/run/headless_run.h"
#include "engine/app/window/key_help.h"
#include "engine/record/percentiles.h"
#include "engine/scenario/to_glm.h"

namespace fulcrum::app {
namespace {

constexpr std::size_t kCostWindow = 1000;  // ticks that the shown percentiles are of
constexpr double kAboutShown = 20;         // s of the trial, at the most
// s, of a picture and the window's events, after which the force goes: a slow machine may take long, but less
// than ticks can wait for this thread.
constexpr double kLongestTurn = 5;
constexpr glm::vec3 kExpertColour{1.0F, 0.52F, 0.04F};  // linear, of lines: no scene's ghost has it
constexpr render::Extent kSecondView{1600, 1000};       // px, that marks in it are placed in

// m: what the trainee has to hit most exactly; where there is no task, a twentieth of the tool.
double finest_detail(const Prepared& prepared) {
  double finest = tool_radius(prepared.haptic.scene) / 20;
  const std::vector<scenario::Checkpoint>& checkpoints = prepared.haptic.task.checkpoints;
  if (!checkpoints.empty()) finest = std::ranges::min(checkpoints, {}, &scenario::Checkpoint::radius).radius;
  return finest;
}

}  // namespace

TrainingWindow::TrainingWindow(WindowStage& stage, const Prepared& prepared,
                               const scenario::VisualAssembly& visual, const RunOptions& options,
                               const ExpertRun* expert, bool has_start_page)
    : stage_(stage),
      prepared_(prepared),
      visual_(visual),
      camera_(visual.desc.camera),
      bridge_(visual.desc, prepared.scenario, prepared.haptic.scene),
      tool_mouse_(input::mouse_steps(finest_detail(prepared))),
      sound_(options, static_cast<double>(stage.settings().volume)),
      expert_(expert),
      has_start_page_(has_start_page) {}

Result<std::unique_ptr<TrainingWindow>> TrainingWindow::create(WindowStage& stage, const Prepared& prepared,
                                                               const scenario::VisualAssembly& visual,
                                                               const RunOptions& options,
                                                               const ExpertRun* expert, bool has_start_page) {
  std::unique_ptr<TrainingWindow> self(
      new TrainingWindow(stage, prepared, visual, options, expert, has_start_page));
  self->circle_ = options.circle;
  self->words_ = device_words(options.device);
  self->is_held_ = !is_simulated(options.device);
  const auto named = std::ranges::find(visual.views, options.view, &scenario::View::name);
  if (named != visual.views.end()) self->view_ = static_cast<std::size_t>(named - visual.views.begin());
  if (auto error = stage.set_scene(visual.desc, stage.settings().first_quality())) return *error;
  return self;
}

void TrainingWindow::begin(const World& world, OpenDevice& device, const RunSink& sink) {
  scene_ = &world.desc();
  sink_ = &sink;
  mouse_ = device.mouse;
  rate_ = device.rate;
  keys_ = device.keys.get();
  gamepad_ = device.gamepad.get();
  pad_device_ = {};
  tool_keys_.let_go();
  buttons_ = ButtonCommands(device.stop_buttons, device.go_buttons);
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
  late_tool_ = {};
  held_up_ = stop_told_ = stop_seen_ = resting_ = ended_ = releases_ = edits_ = false;
  if (editor_ != nullptr) editor_->let_go();
  touches_.clear();
  touch_finder_.reset();  // it was of the world before
  review_ = Review(scene_->tick_s);
  debrief_.reset();
  tool_mouse_.reset(scene_->tool.X_WT_start * scene_->tool.X_HT.inverse());
  ui::learn_pads(gamepad_mappings());
  pad_presses_ = input::PadPresses(repeating_pad_buttons());
  take_pads();
}

TrainingWindow::Leave TrainingWindow::run(World& world, OpenDevice& device, RunSink& sink,
                                          const ProgramFaults& faults, audio::Player* player,
                                          const std::function<bool()>& ended) {
  LiveLoop loop(world, *device.device);
  loop_ = &loop;
  if (player != nullptr) loop.also_tell(player->ticks());
  begin(world, device, sink);
  sound_.begin(player);
  listen();
  draw(sink, loop);  // the first frame takes long, and its picture is where all begins: before the clock runs
  loop.start();
  while (!stage_.window().closing() && !leave_ && !interrupted() && error_.empty()) {
    is_held_up();  // the last picture's
    // What the hand does from here on can be in the next picture, as soon as the screen has a place for one.
    if (const auto error = stage_.wait()) error_ = error->sentence;
    stage_.window().poll_or_wait();
    take_pads();
    TickEvent event;
    while (loop.next(event)) {
      send(buttons_.pressed(event.sample.buttons));
      if (sink.end() != RunSink::End::running) continue;
      note_cost(event);
      sink.take(event);
      sound_.note(sink.task());
      review_.add(event.record, sink.time());
    }
    take_stop(sink);
    if (!ended_) sink.flush_if_due();
    if (faults.gpu_lost()) stage_.gpu().lose();
    bool rests = false;
    if (sink.end() != RunSink::End::running) {
      sound_.rest();
      if (!debrief_)
        debrief_ = debrief(prepared_, sink, {expert_ ? &expert_->metrics : nullptr, earlier_},
                           has_start_page_, pad_is_there_);
      rests = come_to_rest(loop);
    } else {
      late_ = loop.late_ticks();
      lost_ = loop.lost_ticks();
      trouble_.note(static_cast<std::uint64_t>(loop.newest().tick), late_, lost_);
    }
    if (editor_ != nullptr) edit_on(loop);
    if (error_.empty()) draw(sink, loop);
    if (rests && !ended_ && error_.empty()) {
      ended_ = true;
      if (!ended())
        debrief_->rows.push_back(
            {"Kept", "not all of it", {}, "Make room on the disk, and see that you may write there."});
    }
  }
  loop.stop();
  left_X_WT_ = loop.newest().X_WT;
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

bool TrainingWindow::is_held_up() {
  if (!is_held_) return false;
  held_up_ = !loop_->gives_word() || held_up_;
  loop_->expect_word_within(kLongestTurn);
  return held_up_;
}

void TrainingWindow::take_stop(const RunSink& sink) {
  if (!is_held_up()) return;
  if (!std::exchange(stop_told_, true) && sink.end() == RunSink::End::running)
    complain("the display did not answer in time: the force is off, and the trial rests until you go on.");
  releases_ = false;  // for a scene that takes over: whoever goes on brings that force back, too
  if (stop_seen_) held_up_ = stop_told_ = stop_seen_ = false;
}

void TrainingWindow::restart() {
  if (!is_held_up()) leave_ = Leave::restart;
}

bool TrainingWindow::come_to_rest(LiveLoop& loop) {
  if (!resting_) resting_ = loop.send({Command::Kind::stop});
  const TickRecord& newest = loop.newest();
  const bool rests = newest.stopped && newest.device_F_H_D.is_zero();
  if (rests) loop.stop();
  return rests;
}

void TrainingWindow::note_cost(const TickEvent& event) {
  if (cpu_ns_.size() < kCostWindow)
    cpu_ns_.push_back(event.cpu_ns);
  else
    cpu_ns_[cpu_at_] = event.cpu_ns;
  cpu_at_ = (cpu_at_ + 1) % kCostWindow;
}

std::string TrainingWindow::message(const RunSink& sink) const {
  if (editor_ != nullptr) return editor_->message(seen_by_author());
  if (sink.end() != RunSink::End::running) return {};
  if (sink.handle_is_still()) return StillHandle::kSentence;
  if (sink.recording_failed())
    return "Recording has stopped, and the rest of this trial is lost: make room on the disk.";
  std::string what = advice(prepared_.haptic.task, sink.task(), words_);
  const auto after = [&what](const std::string& first) { return what.empty() ? first : first + '\n' + what; };
  if (sink.guided()) return after("Guided: this trial will have no points.");
  const bool begins = sink.task().step == 0 && sink.time() < kAboutShown;
  return begins ? after(prepared_.scenario.about) : what;
}

scenario::TaskState TrainingWindow::task_shown(const RunSink& sink) const {
  return review_.is_shown() ? review_.task(sink, prepared_.haptic.task) : sink.task();
}

ui::OverlayState TrainingWindow::overlay_of(const TickRecord& record, const RunSink& sink,
                                            render::Extent size) const {
  ui::OverlayState state = overlay_state(prepared_, *scene_, record, sink.afterglow(), task_shown(sink));
  if (state.trial) state.trial->limit_s = sink.limit();
  state.tool = lost_tool(seen(), size, record, prepared_.haptic.task);
  const double limit = force_limit_W(*scene_);
  state.touches = touch_marks(seen(), size, touches_, limit);
  if (second_view_)
    state.second_view = {
        second_view_->name,
        in_fractions(touch_marks(second_view_->camera, kSecondView, touches_, limit), kSecondView)};
  if (sink.end() != RunSink::End::running) {
    state.timeline = review_.timeline(sink, plot_limits(*scene_, prepared_.haptic.task),
                                      shows_expert() ? expert_ : nullptr);
    state.timeline->has_expert = expert_ != nullptr && !expert_->way.empty();
    if (!review_.is_shown()) state.debrief = debrief_;
    state.force = ui::Force::on;  // what was stopped then is no stop now
    state.stop_reason.clear();
  } else if (guides_)
    state.target = target_view(seen(), size, record, prepared_.haptic.task, sink.task());
  state.look = stage_.settings().look;
  state.figures_visible = figures_visible_;
  state.ticks = tick_health();
  if (sound_.is_there()) state.muted = sound_.is_muted();
  state.hint = state.muted.value_or(false) ? "F1: keys, F4: sound on" : "F1: keys";
  if (view_ < visual_.views.size()) state.view = view_name(visual_.views[view_]);
  state.message = message(sink);
  state.keys_visible = keys_visible_;
  state.keys_page = keys_page_;
  state.keys = key_lines(state, visual_.views, circle_, has_start_page_);
  if (editor_ != nullptr) {
    add_edit_keys(state.keys);
    if (control_) state.handles = editor_->marks(seen_by_author());
  }
  state.pad = pad_is_there_;
  if (pad_is_there_) {
    const std::vector<ui::KeyLine> pad = pad_lines(pad_phase(), visual_.views.size() > 1, has_start_page_);
    state.keys.insert(state.keys.end(), pad.begin(), pad.end());
  }
  if (mouse_ != nullptr) {
    for (const char* line : input::mouse_help()) state.mapping.emplace_back(line);
    return state;
  }
  if (keys_ != nullptr) state.mapping = ToolKeys::help();
  if (gamepad_ != nullptr) state.mapping = pad_device_help();
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
  if (rate_ != nullptr) rate_->look(seen_frame(seen(), record.X_WT.p, tool_rests() || resting_));
}

const Afterglow& TrainingWindow::seen_afterglow(const RunSink& sink) const {
  static const Afterglow nothing;
  return circle_shown_ ? sink.afterglow() : nothing;
}

render::FrameState TrainingWindow::frame_of(const TickRecord& record, const RunSink& sink) {
  render::FrameState frame =
      bridge_.frame(record, seen_afterglow(sink), task_shown(sink), camera_.camera(), shown_.time_s);
  if (editor_ != nullptr && editor_->held()) {
    markers_.assign(frame.markers.begin(), frame.markers.end());
    const Handle& held = *editor_->held();
    if (held.kind == Handle::Kind::checkpoint && held.index < markers_.size())
      markers_[held.index] = {render::MarkerState::Show::next, 0.0F, scenario::narrowed(held.p_W)};
    frame.markers = markers_;
  }
  frame.marker_colours = ui::marker_colours(stage_.settings().look);
  frame.overlay = &stage_.overlay();
  if (has_expert_ghost_) {
    ghosts_.assign(frame.ghosts.begin(), frame.ghosts.end());
    ghosts_.emplace_back();
    if (shows_expert())
      ghosts_.back() = {1.0F, scenario::to_glm(tool_at(*expert_, review_.same_part_s(sink, *expert_))),
                        kExpertColour};
    frame.ghosts = ghosts_;
  }
  if (const auto& place = stage_.overlay().second_view(); place && second_view_)
    frame.inset = {second_view_->camera, place->x, place->y, place->width, place->height};
  return frame;
}

void TrainingWindow::look_for_touches(const TickRecord& record) {
  touches_.clear();
  if (!touches_shown_) return;
  if (!touch_finder_) touch_finder_.emplace(*scene_);
  touches_ = touch_finder_->find(record);
}

bool TrainingWindow::shows_expert() const {
  return expert_shown_ && review_.is_shown() && expert_ != nullptr && !expert_->way.empty();
}

void TrainingWindow::choose_second_view() {
  second_view_ = second_view(camera_.camera(), visual_.views);
}

// The scene gets one ghost more, the last, when the expert's tool is first to be seen.
std::optional<Error> TrainingWindow::make_room_for_expert() {
  if (!shows_expert() || has_expert_ghost_) return std::nullopt;
  render::VisualDesc desc = visual_.desc;
  desc.ghosts.emplace_back();
  std::optional<Error> error = stage_.renderer().set_ghosts(desc);
  has_expert_ghost_ = !error;
  return error;
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
  if (const bool minimised = size.width == 0 || size.height == 0; minimised != minimised_) {
    minimised_ = minimised;
    // Nobody holds on to what nobody sees: out of sight the trial rests, until its trainee goes on.
    if (minimised && sink.end() == RunSink::End::running) loop.send({Command::Kind::stop});
  }
  if (minimised_) {
    frame_rate_.rest();
    return;
  }
  // The newest tick; the sink's where there is none yet, and its last one after the end.
  const TimedTick newest = loop.newest_timed();
  const bool running = sink.end() == RunSink::End::running;
  const TickRecord& record = review_.is_shown()                                 ? review_.record()
                             : running && newest.record.tick > sink.last().tick ? newest.record
                                                                                : sink.last();
  const bool live = running && !review_.is_shown() && newest.sampled_ns > 0;  // the first tick has ended
  look_for_touches(record);
  shown_ = overlay_of(record, sink, size);
  show_to_device(record);
  sound_.hear_from(camera_.camera());
  if (const auto error = stage_.overlay().prepare(shown_, size)) {
    error_ = error->sentence;
    return;
  }
  if (const auto error = make_room_for_expert()) {
    error_ = error->sentence;
    return;
  }
  const render::FrameState frame = frame_of(record, sink);
  render::LatePoses late;
  if (live) late = late_tool_.poses(loop, bridge_, seen_afterglow(sink), frame.time_s);
  const auto drawn = stage_.renderer().frame(frame, stage_.swapchain(), size, late);
  const bool chooses = !stage_.settings().picture;
  if (!drawn) {
    // A window that has grown may need more graphics memory at its level than there is.
    const bool is_short = chooses && stage_.renderer().is_short_of_memory() && quality_.refuse();
    if (!is_short || render::take_quality(stage_.renderer(), quality_)) error_ = drawn.error().sentence;
    return;
  }
  stop_seen_ = stop_told_ && *drawn;
  if (*drawn && live) late_tool_.shown(stage_.renderer().last_submission_s());
  if (*drawn && running)
    frame_rate_.note(
        std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count());
  if (*drawn && chooses && quality_.add(stage_.renderer().last_frame_s())) {
    if (const auto error = render::take_quality(stage_.renderer(), quality_)) error_ = error->sentence;
  }
}

}  // namespace fulcrum::app
