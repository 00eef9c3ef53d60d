#include "engine/headset/headset_run.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "engine/app/cli/interrupt.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/run/headless_run.h"
#include "engine/headset/panel_words.h"

namespace fulcrum::headset {
namespace {

constexpr auto kNoFrames = std::chrono::milliseconds(5);  // between looks at a headset that shows nothing
constexpr auto kUntilCard = std::chrono::seconds(5);
constexpr XrDuration kBetweenWords = 100'000'000;  // ns, between two writings of the panel
// s, after which the force goes: in a call that OpenXR sets no limit to; and of a whole picture, which a slow
// machine may take long for, but less than ticks can wait for this thread.
constexpr double kLongestWait = 1, kLongestFrame = 5;
constexpr const char* kMirror = "the display of the mirror";

// The force is stopped, and has gone.
bool is_off(const TickRecord& record) {
  return record.stopped && record.device_F_H_D.is_zero();
}

}  // namespace

HeadsetRun::HeadsetRun(HeadsetStage& stage, const app::Prepared& prepared,
                       const scenario::VisualAssembly& visual, const app::RunOptions& options,
                       const app::Settings& settings, app::RunSession& attempt, std::unique_ptr<Panel> panel,
                       std::unique_ptr<Colocated> colocated, const app::Comparison& with)
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
      colocated_(std::move(colocated)),
      pictures_(stage, prepared, visual, settings, attempt),
      tool_(attempt.world().desc().tool.X_WT_start * attempt.world().desc().tool.X_HT.inverse()),
      device_buttons_(attempt.device().stop_buttons, attempt.device().go_buttons),
      sound_(options, static_cast<double>(settings.volume)),
      with_(with) {}

bool HeadsetRun::goes_on() const {
  const ui::Window* const window = stage_.window();
  return !closing_ && error_.empty() && !app::interrupted() && (window == nullptr || !window->closing());
}

void HeadsetRun::run(std::function<void()> ended) {
  ended_ = std::move(ended);
  audio::Player* const player = attempt_.player();
  if (player != nullptr) loop_.also_tell(player->ticks());
  sound_.begin(player);
  listen();
  try {
    while (goes_on()) {
      hear_mirror();
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
  if (stage_.window() != nullptr && stage_.window()->lost())
    app::complain(
        "the mirror's window is gone, for its X server ended or another program closed it: the run ends "
        "here, and what it recorded is kept.");
  else if (!error_.empty())
    app::complain(error_);
  app::report_grant(loop_);
}

// What shows the mirror may not answer, as a headset's runtime may not.
void HeadsetRun::hear_mirror() {
  if (stage_.window() == nullptr) return;
  if (worn_) loop_.expect_word_within(kLongestFrame);
  stage_.window()->poll();
  take_stop(kMirror);
}

void HeadsetRun::keep_pace() {
  loop_.expect_word_within(kLongestFrame);
  if (const auto error = pictures_.keep_pace()) error_ = error->sentence;
  take_stop("the graphics card");
}

void HeadsetRun::show_in_mirror() {
  loop_.expect_word_within(kLongestFrame);
  if (const auto error = stage_.mirror()) error_ = error->sentence;
  take_stop(kMirror);
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
  if (!command || !began_) return;
  if (resting_) {
    leaves_ = leaves_ || card_said_;
    return;
  }
  // Who goes on has to see it.
  if (command->kind == Command::Kind::acknowledge && (!is_seen() || (colocated_ && colocated_->is_asked())))
    return;
  paused_ = false;
  stopped_by_.clear();
  loop_.send(*command);
}

void HeadsetRun::take_ticks() {
  app::RunSink& sink = attempt_.sink();
  TickEvent event;
  const bool was_held_up = std::exchange(held_up_, false);
  while (loop_.next(event)) {
    const std::optional<Command> pressed = device_buttons_.pressed(event.sample.buttons);
    if (colocated_) colocated_->note(event);
    if (!was_held_up || (pressed && pressed->kind == Command::Kind::stop)) ask_for(pressed);
    if (sink.end() != app::RunSink::End::running) continue;
    sink.take(event);
    sound_.note(sink.task());
  }
  was_stopped_ = loop_.newest().stopped;
  sink.flush_if_due();
  if (sink.end() != app::RunSink::End::running) come_to_rest();
}

// The force goes as after a stop. What came of the trial is shown until whoever sees it puts it away, or sees
// nothing any more; without a panel, the last moment is shown once. Then the session is ended in its own
// order.
void HeadsetRun::come_to_rest() {
  sound_.rest();
  if (!resting_) resting_ = loop_.send({Command::Kind::stop});
  if (!is_off(loop_.newest())) return;
  if (const std::function<void()> ended = std::exchange(ended_, nullptr)) {
    ended();
    ended_at_ = std::chrono::steady_clock::now();
  }
  if (panel_ && !card_) card_ = headset_card(prepared_, options_, attempt_.sink(), with_);
  // While all was written no picture was shown, and a runtime may have taken the scene away for that: it has
  // time to show the card.
  const bool has_time = !card_said_ && std::chrono::steady_clock::now() < ended_at_ + kUntilCard;
  leaves_ = leaves_ || (card_ ? !is_seen() && !has_time : !is_seen() || end_shown_);
  if (!leaves_) return;
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
    if (!worn_ || !worn_->session().runs()) {
      pictures_.rest();
      return false;
    }
    const bool drawn = draw();
    take_stop();
    if (!drawn) return true;
    show_in_mirror();
    keep_pace();
    return true;
  } catch (const xr::Lost&) {
    take_stop();
    lose_session();
    return false;
  }
}

// The haptic thread has stopped the force, for something did not answer: as a pause, during which nothing was
// seen, so that what was squeezed or pressed meanwhile does not go on.
void HeadsetRun::take_stop(const char* silent) {
  if (loop_.gives_word() || !began_) return;
  tool_.let_go();
  unseen_ = kBlink;
  held_up_ = true;
  if (resting_) return;
  paused_ = paused_ || !was_stopped_;
  app::complain(std::string(silent) + " did not answer in time: the force is off, and the trial rests.");
}

void HeadsetRun::look_after_session() {
  if (!worn_) {
    if (!stage_.runtime().find_headset()) return;
    const bool stage_space = options_.headset.space == app::kStageSpace;
    worn_ = std::make_unique<Worn>(
        stage_, stage_space ? xr::Space::stage : xr::Space::local,
        Worn::Asked{colocated_ && colocated_->is_asked(), tracks_hands(options_.device)});
    unseen_ = kBlink;
  }
  xr::Session& session = worn_->session();
  session.take_events();
  closing_ = closing_ || session.is_over();
  if (closing_) return;
  if (is_seen() && !began_) {
    began_ = true;
    // Points are touched while nothing pushes; who has touched them goes on as after any other stop.
    if (colocated_ && colocated_->is_asked() && loop_.send({Command::Kind::stop}))
      stopped_by_ = "the device was laid onto the headset's space";
    loop_.start();
  }
  if (!is_seen()) pause("the headset did not show the scene");
  // A simulated hand has nobody who could go on.
  if (is_seen() && paused_ && !resting_ && is_simulated(options_.device) && is_off(loop_.newest()))
    ask_for(Command{Command::Kind::acknowledge});
  if (session.is_lost()) lose_session();
}

void HeadsetRun::lose_session() {
  pause("the headset was lost");
  pictures_.rest();
  if (!worn_) return;
  app::complain("the headset is lost: the force is off, and the trial rests until it is back.");
  worn_.reset();
  // Another session may have another space, and says nothing of it.
  if (!colocated_) return;
  if (colocated_->is_asked())
    colocated_->touch_anew();
  else if (colocated_->placement() && options_.headset.space == app::kLocalSpace)
    app::complain("local space may be elsewhere then: see that the tool is at the hand before you go on.");
}

// A headset may have the focus and show nothing: its runtime wants no picture, or does not know where the
// head is.
bool HeadsetRun::is_seen() const {
  return worn_ && worn_->session().is_focused() && unseen_ < kBlink;
}

void HeadsetRun::pause(const char* why) {
  tool_.let_go();
  const bool was_stopped = loop_.newest().stopped;
  if (!began_ || resting_ || (paused_ && was_stopped)) return;
  // Sent in any case: who had stopped may just have gone on. A stop that somebody asked for stays theirs.
  if (!loop_.send({Command::Kind::stop}) || was_stopped) return;
  paused_ = true;
  stopped_by_ = why;
}

// The newest tick; the sink's where there is none yet, and its last one after the end.
const TickRecord& HeadsetRun::shown_record() {
  const app::RunSink& sink = attempt_.sink();
  const TickRecord& newest = loop_.newest();
  const bool running = sink.end() == app::RunSink::End::running;
  return running && newest.tick > sink.last().tick ? newest : sink.last();
}

bool HeadsetRun::draw() {
  loop_.expect_word_within(kLongestWait);
  const std::optional<xr::Frame> frame = worn_->begin_frame();
  take_stop();
  if (!frame) return false;
  loop_.expect_word_within(kLongestFrame);
  move_hands(*frame);
  place();
  const std::optional<std::array<xr::EyeView, 2>> eyes = worn_->eyes(*frame);
  if (!eyes || worn_->session().is_lost()) {
    show_nothing(*frame);
    return false;
  }
  sound_.hear_from(pictures_.look_from(*eyes, placement_));
  const TickRecord& record = shown_record();
  if (const auto error = say(record, *frame)) {
    error_ = error->sentence;
    return false;
  }
  const Result<bool> shown = pictures_.show(*worn_, *frame, *eyes, panel_place_, record, loop_);
  if (!shown)
    error_ = shown.error().sentence;
  else if (!*shown)
    show_nothing(*frame);
  if (!shown || !*shown) return false;
  unseen_ = 0;
  end_shown_ = resting_;
  return true;
}

void HeadsetRun::show_nothing(const xr::Frame& frame) {
  unseen_ = std::min(unseen_ + 1, kBlink);
  pictures_.rest();
  worn_->show_nothing(frame);
}

void HeadsetRun::place() {
  const std::optional<Placement> placement = colocated_ ? colocated_->placement() : std::nullopt;
  if (!placement) return;
  placement_ = *placement;
  panel_place_ = place_panel(view_, placement_);
}

// Nobody feels what is seen elsewhere: where the space moves, a device that was laid onto it is let go of.
void HeadsetRun::follow_space(const xr::Frame& frame) {
  if (!worn_->session().was_recentred(frame)) return;
  tool_.let_go();
  if (!colocated_) return;
  if (colocated_->placement()) {
    pause("the headset's space has moved");
    unseen_ = kBlink;  // a squeeze now is by who has not seen yet where the scene is: it asks for nothing
  }
  colocated_->space_moved();
  placement_ = place_scene(view_, options_.headset);
  panel_place_ = place_panel(view_, placement_);
}

void HeadsetRun::move_hands(const xr::Frame& frame) {
  const std::array<xr::Hand, xr::kHands> hands = worn_->hands(frame);
  take_stop();
  loop_.expect_word_within(kLongestFrame);
  follow_space(frame);
  // A stop is a pause: what a hand does then moves nothing.
  const bool rests = !began_ || loop_.newest().stopped;
  const std::optional<Command> pressed = tool_.follow(hands, placement_, is_seen(), rests);
  // Before a hand goes on: what a tick takes of both is of this picture.
  if (const std::shared_ptr<Controllers>& controllers = attempt_.device().controllers) {
    controllers->move(tool_.wanted());
    const std::array<double, kHands> strengths = controllers->strengths();
    for (std::size_t i = 0; i < kHands; ++i) worn_->vibrate(i, strengths[i], controllers->carrier_Hz());
  }
  take_stop();
  loop_.expect_word_within(kLongestFrame);
  const bool is_old = held_up_ && pressed && pressed->kind != Command::Kind::stop;  // asked before that stop
  if (colocated_ && colocated_->is_asked())
    touch(frame, hands);
  else if (!is_old)
    ask_for(pressed);
}

// What nobody sees is no touch.
void HeadsetRun::touch(const xr::Frame& frame, const std::array<xr::Hand, xr::kHands>& hands) {
  if (is_seen())
    colocated_->touch(1e-9 * static_cast<double>(frame.display_time), hands);
  else
    colocated_->look_away();
}

app::PictureFigures HeadsetRun::figures() const {
  return pictures_.figures(colocated_ ? colocated_->figures() : std::nullopt);
}

std::optional<Error> HeadsetRun::say(const TickRecord& record, const xr::Frame& frame) {
  if (!panel_ || frame.display_time - said_ < kBetweenWords) return std::nullopt;
  said_ = frame.display_time;
  const PanelMoment moment{record, colocated_.get(), stopped_by_, tool_.is_hand_in_sight(), card_};
  card_said_ = card_.has_value();
  return worn_->say(*panel_, panel_words(prepared_, options_, settings_, attempt_, moment));
}

}  // namespace fulcrum::headset
