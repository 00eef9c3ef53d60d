#include "engine/headset/headset_run.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "engine/app/cli/interrupt.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/picture/target_view.h"
#include "engine/app/run/headless_run.h"
#include "engine/render/picture.h"
#include "engine/ui/look.h"

namespace fulcrum::headset {
namespace {

constexpr auto kNoFrames = std::chrono::milliseconds(5);  // between looks at a headset that shows nothing
constexpr XrDuration kBetweenWords = 100'000'000;         // ns, between two writings of the panel
// s, after which the force goes: in a call that OpenXR sets no limit to; and of a whole picture, which a slow
// machine may take long for, but less than ticks can wait for this thread.
constexpr double kLongestWait = 1, kLongestFrame = 5;
constexpr double kPartOfFrame = 0.8;  // of the time between two pictures, that drawing may take

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// The force is stopped, and has gone.
bool is_off(const TickRecord& record) {
  return record.stopped && record.device_F_H_D.is_zero();
}

}  // namespace

HeadsetRun::HeadsetRun(HeadsetStage& stage, const app::Prepared& prepared,
                       const scenario::VisualAssembly& visual, const app::RunOptions& options,
                       const app::Settings& settings, app::RunSession& attempt, std::unique_ptr<Panel> panel)
    : stage_(stage),
      prepared_(prepared),
      options_(options),
      settings_(settings),
      attempt_(attempt),
      loop_(attempt.world(), *attempt.device().device),
      view_(visual.desc.camera),
      placement_(place_scene(view_, options.headset)),
      panel_place_(place_panel(view_, placement_)),
      panel_(std::move(panel)),
      bridge_(visual.desc, prepared.scenario, attempt.world().desc()),
      grasp_(attempt.world().desc().tool.X_WT_start * attempt.world().desc().tool.X_HT.inverse()),
      device_buttons_(attempt.device().stop_buttons, attempt.device().go_buttons),
      sound_(options, static_cast<double>(settings.volume)) {}

bool HeadsetRun::goes_on() const {
  const ui::Window* const window = stage_.window();
  return !closing_ && error_.empty() && !app::interrupted() && (window == nullptr || !window->closing());
}

void HeadsetRun::run() {
  audio::Player* const player = attempt_.player();
  if (player != nullptr) loop_.also_tell(player->ticks());
  sound_.begin(player);
  listen();
  try {
    while (goes_on()) {
      if (stage_.window() != nullptr) stage_.window()->poll();
      take_ticks();
      if (attempt_.faults().gpu_lost()) stage_.gpu().lose();
      if (!show()) std::this_thread::sleep_for(kNoFrames);
    }
  } catch (const xr::Failure& failure) {
    error_ = failure.what();
  }
  loop_.stop();
  worn_.reset();
  if (stage_.window() != nullptr) stage_.window()->set_events({});
  if (!error_.empty()) app::complain(error_);
  app::report_grant(loop_);
}

void HeadsetRun::listen() {
  if (stage_.window() == nullptr) return;
  ui::WindowEvents events;
  events.key = [this](int key, int action, int) {
    if (action != GLFW_PRESS) return;
    if (key == GLFW_KEY_ESCAPE) ask_for(Command{Command::Kind::stop});
    if (key == GLFW_KEY_ENTER) ask_for(Command{Command::Kind::acknowledge});
  };
  stage_.window()->set_events(std::move(events));
}

void HeadsetRun::ask_for(const std::optional<Command>& command) {
  if (!command || !began_ || resting_) return;
  // Who goes on has to see it.
  if (command->kind == Command::Kind::acknowledge && !is_seen()) return;
  paused_ = false;
  loop_.send(*command);
}

void HeadsetRun::take_ticks() {
  app::RunSink& sink = attempt_.sink();
  TickEvent event;
  const bool was_held_up = std::exchange(held_up_, false);
  while (loop_.next(event)) {
    const std::optional<Command> pressed = device_buttons_.pressed(event.sample.buttons);
    if (!was_held_up || (pressed && pressed->kind == Command::Kind::stop)) ask_for(pressed);
    if (sink.end() != app::RunSink::End::running) continue;
    sink.take(event);
    sound_.note(sink.task());
  }
  sink.flush_if_due();
  if (sink.end() != app::RunSink::End::running) come_to_rest();
}

// The force goes as after a stop; then the session is ended in its own order.
void HeadsetRun::come_to_rest() {
  sound_.rest();
  if (!resting_) resting_ = loop_.send({Command::Kind::stop});
  if (!is_off(loop_.newest())) return;
  loop_.stop();
  if (worn_ && worn_->session().runs())
    worn_->session().end();
  else
    closing_ = true;
}

bool HeadsetRun::show() {
  try {
    if (worn_) loop_.expect_word_within(kLongestWait);
    look_after_session();
    take_stop();
    if (!worn_ || !worn_->session().runs()) return false;
    draw();
    take_stop();
    return true;
  } catch (const xr::Lost&) {
    take_stop();
    lose_session();
    return false;
  }
}

// The haptic thread has stopped the force, for the headset's runtime did not answer: as a pause, during which
// nothing was seen, so that what was squeezed or pressed meanwhile does not go on.
void HeadsetRun::take_stop() {
  if (loop_.gives_word() || !began_) return;
  grasp_.let_go();
  unseen_ = kBlink;
  held_up_ = true;
  paused_ = !resting_;
  if (paused_)
    app::complain("the headset's runtime did not answer in time: the force is off, and the trial rests.");
}

void HeadsetRun::look_after_session() {
  if (!worn_) {
    if (!stage_.runtime().find_headset()) return;
    const bool stage_space = options_.headset.space == app::kStageSpace;
    worn_ = std::make_unique<Worn>(stage_, stage_space ? xr::Space::stage : xr::Space::local);
    unseen_ = kBlink;
  }
  xr::Session& session = worn_->session();
  session.take_events();
  closing_ = closing_ || session.is_over();
  if (closing_) return;
  if (is_seen() && !began_) {
    began_ = true;
    loop_.start();
  }
  if (!is_seen()) pause();
  // A simulated hand has nobody who could go on.
  if (is_seen() && paused_ && is_simulated(options_.device) && is_off(loop_.newest()))
    ask_for(Command{Command::Kind::acknowledge});
  if (session.is_lost()) lose_session();
}

void HeadsetRun::lose_session() {
  pause();
  if (worn_) app::complain("the headset is lost: the force is off, and the trial rests until it is back.");
  worn_.reset();
}

// A headset may have the focus and show nothing: its runtime wants no picture, or does not know where the
// head is.
bool HeadsetRun::is_seen() const {
  return worn_ && worn_->session().is_focused() && unseen_ < kBlink;
}

void HeadsetRun::pause() {
  grasp_.let_go();
  if (began_ && !paused_ && !resting_) paused_ = loop_.send({Command::Kind::stop});
}

// The newest tick; the sink's where there is none yet, and its last one after the end.
const TickRecord& HeadsetRun::shown_record() {
  const app::RunSink& sink = attempt_.sink();
  const TickRecord& newest = loop_.newest();
  const bool running = sink.end() == app::RunSink::End::running;
  return running && newest.tick > sink.last().tick ? newest : sink.last();
}

void HeadsetRun::draw() {
  loop_.expect_word_within(kLongestWait);
  const std::optional<xr::Frame> frame = worn_->begin_frame();
  take_stop();
  if (!frame) return;
  loop_.expect_word_within(kLongestFrame);
  if (!quality_ && !settings_.picture && frame->period > 0)
    quality_.emplace(kPartOfFrame * 1e-9 * static_cast<double>(frame->period));
  move_hands(*frame);
  const std::optional<std::array<xr::EyeView, 2>> eyes = worn_->eyes(*frame);
  if (!eyes || worn_->session().is_lost()) {
    show_nothing(*frame);
    return;
  }
  eyes_ = {eye_camera(eyes->front(), placement_, view_.layers),
           eye_camera(eyes->back(), placement_, view_.layers)};
  sound_.hear_from(eyes_->front());
  const bool live = attempt_.sink().end() == app::RunSink::End::running &&
                    loop_.newest_timed().sampled_ns > 0;  // the first tick has ended
  const TickRecord& record = shown_record();
  if (const auto error = say(record, *frame)) {
    error_ = error->sentence;
    return;
  }
  const render::FrameState state = frame_of(record);
  render::LatePoses late;
  if (live) late = late_tool_.poses(loop_, bridge_, attempt_.sink().afterglow(), state.time_s);
  const Result<bool> shown = worn_->show(*frame, *eyes, state, panel_place_, late);
  if (!shown) {
    error_ = shown.error().sentence;
    return;
  }
  if (!*shown) {
    show_nothing(*frame);
    return;
  }
  unseen_ = 0;
  if (live) late_tool_.shown(stage_.renderer().last_submission_s());
  frame_rate_.note(now_s());
  auto error = stage_.mirror();  // before another quality makes another picture
  if (!error && quality_ && quality_->add(stage_.renderer().last_frame_s()))
    error = stage_.renderer().set_quality(quality_->quality());
  if (error) error_ = error->sentence;
}

void HeadsetRun::show_nothing(const xr::Frame& frame) {
  unseen_ = std::min(unseen_ + 1, kBlink);
  worn_->show_nothing(frame);
}

void HeadsetRun::move_hands(const xr::Frame& frame) {
  const std::array<xr::Hand, xr::kHands> hands = worn_->hands(frame);
  take_stop();
  loop_.expect_word_within(kLongestFrame);
  if (worn_->session().was_recentred(frame)) grasp_.let_go();
  std::array<input::GraspingHand, xr::kHands> grasping;
  std::uint32_t down = 0;
  for (std::size_t i = 0; i < hands.size(); ++i) {
    if (hands[i].X_LG) grasping[i].X_WG = placement_.in_world(*hands[i].X_LG);
    grasping[i].holds = hands[i].holds;
    down |= (hands[i].holds ? kHoldButton : 0U) | (hands[i].stops ? kStopButton : 0U);
  }
  // A squeeze that began, or went on, while nobody saw the scene asks for nothing: it has to end first.
  if (!is_seen()) down |= kHoldButton;
  ask_for(hand_buttons_.pressed(down));
  const std::shared_ptr<Controllers>& controllers = attempt_.device().controllers;
  if (!controllers) return;
  // A stop is a pause: what a hand does then moves nothing.
  const bool rests = !began_ || loop_.newest().stopped;
  controllers->move(grasp_.follow(grasping, rests));
  const std::array<double, kHands> strengths = controllers->strengths();
  for (std::size_t i = 0; i < kHands; ++i) worn_->vibrate(i, strengths[i], controllers->carrier_Hz());
}

render::FrameState HeadsetRun::frame_of(const TickRecord& record) {
  const app::RunSink& sink = attempt_.sink();
  render::FrameState frame = bridge_.frame(record, sink.afterglow(), sink.task(), view_, sink.time());
  frame.eyes = eyes_;
  frame.marker_colours = ui::marker_colours(settings_.look);
  if (options_.overlay == app::kNoOverlay) {
    frame.markers = {};
    frame.ghosts = {};
  }
  return frame;
}

std::optional<Error> HeadsetRun::say(const TickRecord& record, const xr::Frame& frame) {
  if (!panel_ || frame.display_time - said_ < kBetweenWords) return std::nullopt;
  said_ = frame.display_time;
  const app::RunSink& sink = attempt_.sink();
  const SceneDesc& scene = attempt_.world().desc();
  ui::OverlayState state = app::overlay_state(prepared_, scene, record, sink.afterglow(), sink.task());
  state.look = settings_.look;
  if (state.trial) state.trial->limit_s = sink.limit();
  const DeviceWords words = device_words(options_.device);
  if (state.force == ui::Force::stopped)
    state.message.append("To go on: ").append(words.go_on).append(".");
  else
    state.message = app::advice(prepared_.haptic.task, sink.task(), words);
  return worn_->say(*panel_, state);
}

Result<std::filesystem::path> HeadsetRun::save_picture(const std::filesystem::path& file) {
  if (auto error = stage_.renderer().frame(frame_of(attempt_.sink().last()))) return *error;
  const auto picture = stage_.renderer().read_back();
  if (!picture) return picture.error();
  if (auto error = render::write_png(file, *picture)) return *error;
  return file;
}

}  // namespace fulcrum::headset
