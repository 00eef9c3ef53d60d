#include "drivers/falcon/falcon_bus.h"

#include <array>
#include <utility>

namespace fulcrum::falcon {
namespace {

constexpr int kTurnWait_ms = 5;
// For each further answer where one was late or is lost: they come in order, and no farther apart than the
// packets that they answer. What is silent for so long has been lost.
constexpr int kLateWait_ms = 8;
constexpr int kMostWaiting = 64;  // packets of the port
// After so long a silence it may have lost its power, and its firmware with it: it is to be started anew.
constexpr std::chrono::seconds kSilence{2};

}  // namespace

FalconBus::FalconBus(std::unique_ptr<usb::UsbPort> port, FalconBoot::Firmware firmware)
    : port_(std::move(port)), line_(*port_), boot_(std::move(firmware)) {}

// What it still says to those packets that asked whether it runs is no answer to the first one of the run.
ForceBus::Turn FalconBus::start() {
  const FalconBoot::State state = boot_.advance(line_);
  if (state == FalconBoot::State::done) {
    std::array<std::uint8_t, FalconLine::kMostRead> bytes{};
    for (int count = 0; count < kMostWaiting && line_.read(bytes, kLateWait_ms) > 0; ++count) {
    }
  }
  return state == FalconBoot::State::failed ? Turn::lost : Turn::none;
}

// Byte by byte, since each answer is one to the oldest packet that has none.
void FalconBus::take(std::span<const std::uint8_t> bytes, std::optional<FalconSays>& says) {
  for (const std::uint8_t& byte : bytes) {
    const std::optional<FalconSays> next = packets_.feed({&byte, 1});
    if (!next) continue;
    says = next;
    if (unanswered_.empty()) continue;
    asked_ = unanswered_.front();
    unanswered_.pop_front();
  }
}

// Its answers so far are older than the one to the next packet.
void FalconBus::drop() {
  std::array<std::uint8_t, FalconLine::kMostRead> bytes{};
  std::optional<FalconSays> old;
  for (int count = 0; count < kMostWaiting; ++count) {
    const int length = line_.read(bytes, 0);
    if (length <= 0) return;
    take(std::span(bytes).first(static_cast<std::size_t>(length)), old);
  }
}

bool FalconBus::listen(std::optional<FalconSays>& says) {
  std::array<std::uint8_t, FalconLine::kMostRead> bytes{};
  for (int count = 0; count < kMostWaiting; ++count) {
    const int length = line_.read(bytes, !says ? kTurnWait_ms : unanswered_.empty() ? 0 : kLateWait_ms);
    if (length < 0) return false;
    if (length == 0) break;
    take(std::span(bytes).first(static_cast<std::size_t>(length)), says);
  }
  if (says) unanswered_.clear();
  return true;
}

// A packet without an answer is followed by one without force: who cannot be seen is not pushed.
ForceBus::Turn FalconBus::exchange(const DeviceCommand& command, DeviceSample& sample) {
  if (boot_.state() != FalconBoot::State::done) return start();
  drop();
  const std::array<int, 3> motors =
      stance_ ? motors_for(*stance_, command.F_H_D.force) : std::array<int, 3>{};
  const AgeClock::time_point sent = AgeClock::now();
  const bool told = line_.write(encode(motors, homed_ ? kGreen : kHoming | kRed));
  if (told) unanswered_.push_back(sent);
  stance_.reset();
  std::optional<FalconSays> says;
  if (!listen(says)) return Turn::lost;
  answered_ = says.has_value();
  const auto now = AgeClock::now();
  if (answered_ || heard_ == AgeClock::time_point()) heard_ = now;
  if (now - heard_ > kSilence) return Turn::lost;
  if (!says || !told) return Turn::none;
  homed_ = says->homed;
  if (!homed_) return Turn::none;
  stance_ = stance_at(says->counts);
  impossible_ = !stance_;
  if (!stance_) return Turn::none;
  sample.X_DH = {Quat::Identity(), stance_->p_DH};
  sample.age = std::chrono::duration<double>(now - asked_).count();
  sample.buttons = says->buttons;
  return Turn::fresh;
}

std::string FalconBus::trouble() const {
  if (boot_.state() == FalconBoot::State::failed) return boot_.why();
  if (boot_.state() == FalconBoot::State::going || !answered_) return {};
  if (!homed_)
    return "it does not know yet where its grip is: pull the grip out as far as it goes, push it in as far "
           "as it goes, let it come back to the middle, and start again. Its ring is red until then.";
  if (impossible_)
    return "its legs are where none of its kind can have them: switch it off and on, pull its grip out and "
           "push it in, and start again.";
  return {};
}

}  // namespace fulcrum::falcon
