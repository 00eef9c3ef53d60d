// Reference: none; any text as a recorded motion. Invariants: reading it neither crashes nor goes out of
// bounds, and gives a sentence, or samples on a grid of ticks whose poses are finite and whose quaternions
// are of length 1.

#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "engine/record/motion.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const int file = ::memfd_create("trace", 0);
  static const std::string path = "/proc/self/fd/" + std::to_string(file);
  if (::ftruncate(file, 0) != 0 || ::pwrite(file, data, size, 0) != static_cast<ssize_t>(size)) std::abort();
  const auto motion = fulcrum::record::read_motion(path);
  if (!motion) {
    if (!motion.error().sentence.ends_with(".")) std::abort();
    return 0;
  }
  if (motion->samples.empty() || !(motion->tick_s > 0)) std::abort();
  if (motion->space == fulcrum::record::HandleMotion::Space::device) return 0;  // as the device gave it
  for (const fulcrum::DeviceSample& sample : motion->samples)
    if (!sample.X_DH.p.allFinite() || !(std::abs(sample.X_DH.q.norm() - 1) < 1e-8)) std::abort();
  return 0;
}
