#include "engine/app/run/still_handle.h"

#include <cmath>

namespace fulcrum::app {

StillHandle::StillHandle(double tick_s) : long_(std::llround(kLong / tick_s)) {}

bool StillHandle::note(const DeviceSample& sample) {
  const bool same =
      sample.connected && sample.X_DH.p == X_DH_.p && sample.X_DH.q.coeffs() == X_DH_.q.coeffs();
  X_DH_ = sample.X_DH;
  ticks_ = same ? ticks_ + 1 : 0;
  return ticks_ == long_;
}

}  // namespace fulcrum::app
