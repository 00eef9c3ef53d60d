#include "drivers/falcon/falcon_boot.h"

#include <algorithm>
#include <utility>

namespace fulcrum::falcon {
namespace {

constexpr int kAnswerWait_ms = 20;  // for an answer; the chip keeps what is not a full packet for 16
// Tries without an answer: 0.5 s for firmware that runs already, and 2 s for what the boot loader must say.
constexpr int kMostAsked = 25, kMostTries = 100;
constexpr int kHelloEvery = 5;  // tries: one that is said before the last was answered would be firmware
constexpr std::array<std::uint8_t, 3> kHello{0x0A, 0x43, 0x0D};
constexpr std::array<std::uint8_t, 4> kHelloBack{0x0A, 0x44, 0x2C, 0x0D};
constexpr std::uint8_t kSign = 0x41;
constexpr std::size_t kChunk = 62;  // bytes of firmware: its echo fits into one packet of the chip

}  // namespace

FalconBoot::State FalconBoot::advance(FalconLine& line) {
  if (state_ != State::going) return state_;
  if (!begun_) {
    begun_ = true;
    begin(Step::asks, line.to_exchange());
    return state_;
  }
  switch (step_) {
    case Step::asks:
    case Step::asks_again:
      ask(line);
      break;
    case Step::greets:
      greet(line);
      break;
    case Step::signs:
      sign(line);
      break;
    case Step::uploads:
      upload(line);
      break;
  }
  return state_;
}

void FalconBoot::begin(Step step, bool set) {
  step_ = step;
  tries_ = 0;
  matched_ = 0;
  packets_.clear();
  if (!set) fail("it stopped answering while it was started: plug it in again.");
}

void FalconBoot::fail(std::string why) {
  if (state_ == State::failed) return;
  state_ = State::failed;
  why_ = std::move(why);
}

std::span<const std::uint8_t> FalconBoot::hear(FalconLine& line) {
  const int length = line.read(heard_, kAnswerWait_ms);
  if (length < 0) fail("it was unplugged while it was started: plug it in again.");
  return std::span(heard_).first(static_cast<std::size_t>(std::max(length, 0)));
}

// Without any force, and with the light that asks for homing.
void FalconBoot::ask(FalconLine& line) {
  line.write(encode({}, kHoming | kRed));
  if (packets_.feed(hear(line))) {
    state_ = State::done;
    return;
  }
  if (++tries_ < (step_ == Step::asks ? kMostAsked : kMostTries)) return;
  if (step_ == Step::asks)
    read_firmware(line);
  else
    fail(
        "it took its firmware and does not answer: the file may be another device's, or another version; "
        "switch it off and on, and try nvent_firmware.bin of libnifalcon.");
}

void FalconBoot::read_firmware(FalconLine& line) {
  Result<std::vector<std::uint8_t>> firmware = load_();
  if (!firmware) return fail(firmware.error().sentence);
  firmware_ = std::move(*firmware);
  begin(Step::greets, line.to_greet());
}

void FalconBoot::greet(FalconLine& line) {
  if (tries_ % kHelloEvery == 0) line.write(kHello);
  for (const std::uint8_t byte : hear(line)) {
    if (byte != kHelloBack[matched_]) matched_ = 0;
    if (byte == kHelloBack[matched_]) ++matched_;
    if (matched_ == kHelloBack.size()) return begin(Step::signs, line.to_load());
  }
  if (++tries_ >= kMostTries)
    fail("its boot loader does not answer: switch it off and on, and start again; it needs its own power.");
}

void FalconBoot::sign(FalconLine& line) {
  if (!signed_) signed_ = line.write({&kSign, 1});
  const auto heard = hear(line);
  if (std::ranges::find(heard, kSign) != heard.end()) return begin(Step::uploads, true);
  if (++tries_ >= kMostTries)
    fail("its boot loader does not take the firmware: switch it off and on, and start again.");
}

void FalconBoot::send_chunk(FalconLine& line) {
  const std::size_t length = std::min(kChunk, firmware_.size() - sent_);
  if (line.write(std::span(firmware_).subspan(sent_, length))) sent_ += length;
}

// The next chunk goes once all of the one before has come back.
void FalconBoot::upload(FalconLine& line) {
  if (echoed_ == sent_) send_chunk(line);
  const auto heard = hear(line);
  tries_ = heard.empty() ? tries_ + 1 : 0;
  for (const std::uint8_t byte : heard) {
    if (echoed_ == sent_ || byte != firmware_[echoed_])
      return fail("its firmware did not come back as it was sent: switch it off and on, and start again.");
    ++echoed_;
  }
  if (echoed_ == firmware_.size()) return begin(Step::asks_again, line.to_exchange());
  if (tries_ >= kMostTries)
    fail("it fell silent while it took its firmware: switch it off and on, and start again.");
}

}  // namespace fulcrum::falcon
