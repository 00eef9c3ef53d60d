#pragma once
// Both halves of a pair of Joy-Cons as one device: each brings the axes that it has, and vibrates on its
// side.

#include <memory>

#include "drivers/rate/axes_source.h"

namespace fulcrum::joycon {

class JoyConPair final : public AxesSource {
public:
  // Neither is null.
  JoyConPair(std::shared_ptr<AxesSource> left, std::shared_ptr<AxesSource> right);

  // As old as the older of both; lost where one of them is.
  AxesReading read() noexcept override;
  void drive(const ChannelDrives& drives) noexcept override;

private:
  std::shared_ptr<AxesSource> left_, right_;
};

}  // namespace fulcrum::joycon
