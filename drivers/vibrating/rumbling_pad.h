#pragma once
// A pad's motors: of each channel the amplitude, as its link takes it.

#include <memory>
#include <vector>

#include "drivers/rate/axes_source.h"
#include "drivers/vibrating/vibrator.h"
#include "haptics/actuation/vibrotactile_output.h"

namespace fulcrum {

class RumblingPad final : public Vibrator {
public:
  // channels: the pad's, all of rumble. signal: what they are to render.
  RumblingPad(std::shared_ptr<AxesSource> pad, const VibrotactileDesc& channels,
              const VibrotactileSignal& signal, double tick_s);

  bool connected() noexcept override { return pad_->read().connected; }
  void drive(const VibrotactileCommand& command) noexcept override;

private:
  std::shared_ptr<AxesSource> pad_;
  std::vector<ChannelOutput> outputs_;
};

}  // namespace fulcrum
