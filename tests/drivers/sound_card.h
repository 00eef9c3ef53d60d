#pragma once
// A sound card whose clock the test moves.

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <vector>

#include "drivers/sound/pcm.h"

namespace fulcrum::test {

// What is in the socket, whoever has it open.
struct SoundCard {
  std::mutex mutex;
  bool plugged = true;
  bool runs = true;  // its clock
  bool dry = false;
  std::int64_t period = 96, buffer = 4096;
  double ahead = 0;                   // frames
  std::vector<sound::Frame> written;  // since the beginning
  std::atomic<int> opened{0}, closed{0};

  // It plays as many frames.
  void pass(double frames) {
    const std::lock_guard lock(mutex);
    if (!runs || dry || written.empty()) return;
    ahead -= frames;
    if (ahead >= 0) return;
    dry = true;
    ahead = 0;
  }
  void plug(bool in) {
    const std::lock_guard lock(mutex);
    plugged = in;
    dry = false;
    ahead = 0;
  }
  std::vector<sound::Frame> all_written() {
    const std::lock_guard lock(mutex);
    return written;
  }
};

class SoundCardPcm final : public sound::Pcm {
public:
  explicit SoundCardPcm(SoundCard& card) : card_(card), figures_{"a card", card.period, card.buffer} {
    ++card_.opened;
  }
  ~SoundCardPcm() override {
    const std::lock_guard lock(card_.mutex);
    ++card_.closed;
  }
  Fill fill() override {
    const std::lock_guard lock(card_.mutex);
    if (!card_.plugged) return {.state = State::lost};
    if (card_.dry) return {.state = State::dry};
    const auto ahead = static_cast<std::int64_t>(card_.ahead);
    return {State::plays, ahead, card_.buffer - ahead};
  }
  void write(std::span<const sound::Frame> frames) override {
    const std::lock_guard lock(card_.mutex);
    if (!card_.plugged || card_.dry) return;
    if (static_cast<double>(frames.size()) > static_cast<double>(card_.buffer) - card_.ahead) ++too_many_;
    card_.written.insert(card_.written.end(), frames.begin(), frames.end());
    card_.ahead += static_cast<double>(frames.size());
  }
  bool restart() override {
    const std::lock_guard lock(card_.mutex);
    card_.dry = false;
    card_.ahead = 0;
    return card_.plugged;
  }
  const sound::PcmFigures& figures() const override { return figures_; }
  int too_many() const { return too_many_; }  // writes that were larger than its room

private:
  SoundCard& card_;
  sound::PcmFigures figures_;
  int too_many_ = 0;
};

}  // namespace fulcrum::test
