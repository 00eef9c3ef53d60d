#include "drivers/hid/hid_link.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include "haptics/loop/age_clock.h"
#include "haptics/loop/real_time.h"

namespace fulcrum::hid {
namespace {

constexpr int kReadWait_ms = 5;  // how long the reader waits: so old is what is known of a silent device
constexpr std::int64_t kShortestTurn_ns = 500'000;  // of the reader; USB brings at most a report each ms
constexpr std::int64_t kKept_ns = 50'000'000;       // of drives that are not renewed
constexpr int kLookAgain_ms = 250;                  // between two looks for a device that is away
constexpr double kLetGo = 0.1;                      // s, of silence
constexpr int kMostWaiting = 64;                    // reports; hidraw keeps 63 and drops what is newer

void greet(HidOpened& opened) {
  for (const HidProtocol::Feature& feature : opened.protocol->features()) {
    std::array<std::uint8_t, HidProtocol::kLongestReport> bytes{};
    bytes[0] = feature.number;
    const int count = opened.port->read_feature(std::span(bytes).first(feature.length));
    if (count > 0) opened.protocol->learn(std::span(bytes).first(static_cast<std::size_t>(count)));
  }
}

}  // namespace

HidLink::HidLink(HidOpened opened, Open open)
    : open_(std::move(open)), opened_(std::make_shared<HidOpened>(std::move(opened))) {
  greet(*opened_);
  state_.draft() = {
      .told_ns = AgeClock::now_ns(), .seen_ns = AgeClock::now_ns(), .streams = opened_->protocol->streams()};
  state_.publish();
  reader_ = std::thread([this] { read_on(); });
  writer_ = std::thread([this] { write_on(); });
}

HidLink::~HidLink() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  ended_.notify_all();
  reader_.join();
  writer_.join();
}

// A device that streams is as old as its last word. One that says nothing at rest is as old as its bus; while
// it is pushed it speaks, and where it falls silent it has been let go.
AxesReading HidLink::read() noexcept {
  const State& state = state_.newest();
  const std::int64_t now = AgeClock::now_ns();
  const auto since = [now](std::int64_t then) {
    return 1e-9 * static_cast<double>(std::max(then, now) - then);
  };
  if (state.streams) return {state.axes, since(state.told_ns), state.connected};
  AxesReading reading{state.axes, since(state.seen_ns), state.connected};
  if (since(state.told_ns) > kLetGo) reading.axes.way = reading.axes.turn = Vec3::Zero();
  return reading;
}

void HidLink::drive(const ChannelDrives& drives) noexcept {
  told_.draft() = {drives, AgeClock::now_ns()};
  told_.publish();
}

// What nobody renews, because the haptic thread stands still or has ended, vibrates no longer.
ChannelDrives HidLink::due() {
  const Told& told = told_.newest();
  return AgeClock::now_ns() - told.at_ns <= kKept_ns ? told.drives : ChannelDrives();
}

std::shared_ptr<HidOpened> HidLink::opened() {
  const std::lock_guard lock(mutex_);
  return opened_;
}

void HidLink::set_opened(std::shared_ptr<HidOpened> opened) {
  const std::lock_guard lock(mutex_);
  opened_ = std::move(opened);
}

bool HidLink::rest(int ms) {
  std::unique_lock lock(mutex_);
  return !ended_.wait_for(lock, std::chrono::milliseconds(ms), [this] { return ends_; });
}

bool HidLink::take_reports(HidOpened& opened, State& state) {
  std::array<std::uint8_t, HidProtocol::kLongestReport> bytes{};
  int wait = kReadWait_ms;
  for (int count = 0; count < kMostWaiting; ++count) {
    const int length = opened.port->read(bytes, wait);
    if (length < 0) return false;
    if (length == 0) break;
    wait = 0;
    const auto report = std::span(bytes).first(static_cast<std::size_t>(length));
    const bool good = opened.protocol->decode(report, state.axes);
    (good ? reports_ : refused_).fetch_add(1, std::memory_order_relaxed);
    if (good) state.told_ns = AgeClock::now_ns();
  }
  state.seen_ns = AgeClock::now_ns();
  return true;
}

// A read that returns at once, whatever the reason, must not keep a processor busy that nothing else may
// have.
void HidLink::read_on() {
  ask_for_scheduling(kReaderPriority);  // where it is refused, the haptic thread has said so
  const auto begun = [](const HidProtocol& protocol) {
    return State{.told_ns = AgeClock::now_ns(), .seen_ns = AgeClock::now_ns(), .streams = protocol.streams()};
  };
  State state = begun(*opened()->protocol);
  std::int64_t last_ns = 0;
  const auto pause_ms = [&] {
    const std::int64_t now = AgeClock::now_ns();
    return now - std::exchange(last_ns, now) < kShortestTurn_ns ? 1 : 0;
  };
  while (rest(pause_ms())) {
    if (const std::shared_ptr<HidOpened> at = opened()) {
      if (!take_reports(*at, state)) {
        state.connected = false;
        set_opened(nullptr);
      }
    } else {
      if (!rest(kLookAgain_ms)) return;
      HidOpened found = open_();
      if (!found.port) continue;
      greet(found);
      state = begun(*found.protocol);
      set_opened(std::make_shared<HidOpened>(std::move(found)));
    }
    state_.draft() = state;
    state_.publish();
  }
}

void HidLink::write_on() {
  HidProtocol::Report report{};
  ChannelDrives sent{};
  int since_ms = 0;
  const auto send = [&](HidOpened& at, const ChannelDrives& drives) {
    const std::size_t length = at.protocol->encode(drives, report);
    if (length == 0 || !at.port->write(std::span(report).first(length))) return;
    sent = drives;
    since_ms = 0;
  };
  const auto pace = [this] {
    const std::shared_ptr<HidOpened> at = opened();
    return at ? at->protocol->pace() : HidProtocol::Pace();
  };
  for (HidProtocol::Pace now = pace(); rest(now.write_ms); now = pace()) {
    since_ms += now.write_ms;
    const ChannelDrives wanted = due();
    const std::shared_ptr<HidOpened> at = opened();
    if (!at) continue;
    if (const std::size_t length = at->protocol->ask(report)) {
      at->port->write(std::span(report).first(length));
      continue;
    }
    const bool vibrates = std::ranges::any_of(wanted, [](double drive) { return drive > 0; });
    if (wanted != sent || (vibrates && since_ms >= now.repeat_ms)) send(*at, wanted);
  }
  const std::shared_ptr<HidOpened> at = opened();
  if (at && sent != ChannelDrives{}) send(*at, {});
}

}  // namespace fulcrum::hid
