#include "drivers/vibrating/rumbling_pad.h"

#include <utility>

namespace fulcrum {

RumblingPad::RumblingPad(std::shared_ptr<AxesSource> pad, const VibrotactileDesc& channels,
                         const VibrotactileSignal& signal, double tick_s)
    : pad_(std::move(pad)) {
  for (const ChannelDesc& channel : channels.channels) outputs_.emplace_back(channel, signal, tick_s);
}

void RumblingPad::drive(const VibrotactileCommand& command) noexcept {
  ChannelDrives drives{};
  for (std::size_t i = 0; i < outputs_.size(); ++i) {
    const auto rendered = outputs_[i].process(command.level[i], command);
    if (!rendered.empty()) drives[i] = rendered.back();
  }
  pad_->drive(drives);
}

}  // namespace fulcrum
