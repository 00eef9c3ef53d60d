#pragma once
// A drive as 16 bits: what a WAV file keeps of it, and what a sound card is given, are the same number.

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace fulcrum {

inline constexpr double kPcmFullScale = 32767;

// drive: from -1 to 1; what is beyond is cut off there.
inline std::int16_t pcm_sample(double drive) noexcept {
  return static_cast<std::int16_t>(std::lround(kPcmFullScale * std::clamp(drive, -1.0, 1.0)));
}

}  // namespace fulcrum
