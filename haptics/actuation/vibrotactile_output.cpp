#include "haptics/actuation/vibrotactile_output.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

ChannelOutput::ChannelOutput(const ChannelDesc& channel, const VibrotactileSignal& signal, double tick_s)
    : kind_(channel.kind),
      rate_Hz_(channel.kind == ChannelKind::pcm ? channel.rate_Hz : 1 / tick_s),
      tick_s_(tick_s),
      full_(signal.largest),
      drive_per_level_(1 / (channel.largest * actuator_response(channel, signal.carrier_Hz))) {
  if (kind_ == ChannelKind::pcm) carrier_.emplace(signal.carrier_Hz, 1 / channel.rate_Hz);
  drives_.resize(static_cast<std::size_t>(std::ceil(tick_s * rate_Hz_)) + 1);
}

std::span<const double> ChannelOutput::process(double level, const VibrotactileCommand& command) noexcept {
  if (!(level > 0)) level = 0;  // of an effect that asks for less than nothing, or for what is not a number
  if (command.stopping) level = std::min(level, envelope_);  // it may still be on its way up
  if (kind_ != ChannelKind::pcm) {
    envelope_ = level;
    drives_[0] = std::min(1.0, level * drive_per_level_);
    return {drives_.data(), 1};
  }
  if (level != level_ || command.stopping) {
    level_ = level;
    step_ = std::abs(level_ - envelope_) / std::max(1.0, command.glide * rate_Hz_);
    if (!command.stopping) step_ = std::min(step_, kStep * full_);
  }
  constexpr double rounding = 1e-6;  // of a sample
  const auto due =
      static_cast<std::int64_t>(std::floor(static_cast<double>(++ticks_) * tick_s_ * rate_Hz_ + rounding));
  std::size_t count = 0;
  for (; samples_ < due && count < drives_.size(); ++samples_) drives_[count++] = next();
  return {drives_.data(), count};
}

double ChannelOutput::next() noexcept {
  envelope_ += std::clamp(level_ - envelope_, -step_, step_);
  if (envelope_ == 0) {
    carrier_->restart();
    return 0;
  }
  return std::clamp(envelope_ * drive_per_level_ * carrier_->next(), -1.0, 1.0);
}

}  // namespace fulcrum
