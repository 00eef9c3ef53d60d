#pragma once
// OpenAL Soft with one context: on the machine's sound device, or without one, rendering when it is told to
// (ALC_SOFT_loopback) by the same library and the same mixing.
//
// OpenAL's context is one of each thread here (ALC_EXT_thread_local_context): who uses it says so first, and
// lets go of it in the end.

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "haptics/math/result.h"

struct ALCdevice_struct;
struct ALCcontext_struct;

namespace fulcrum::audio {

// Before the process has threads: OpenAL Soft writes nothing to stderr, and mixes in periods of 5 ms, 4 of
// them ahead, in place of 23 ms and 3. Both by its environment (ALSOFT_LOGLEVEL, ALSOFT_CONF), and only where
// the person has not set that.
void settle_library();

class Output {
public:
  // The device that is the library's default; ALSOFT_DRIVERS says by which system. With a head's filters
  // (HRTF) where the library has them. Errors: there is none.
  static Result<Output> open();
  // Stereo. hrtf: with a head's filters.
  static Result<Output> offline(bool hrtf);
  Output(Output&& other) noexcept;
  Output& operator=(Output&&) = delete;
  ~Output();

  // OpenAL's calls of this thread are of this context from here on.
  void use() const;
  static void let_go();  // of any

  // Offline: the next frames. interleaved (2 n), left first.
  void render(std::span<float> interleaved) const;

  bool is_connected() const;  // false: the device was unplugged
  bool has_hrtf() const;
  std::string name() const;

private:
  Output(ALCdevice_struct* device, ALCcontext_struct* context) : device_(device), context_(context) {}
  static Result<Output> with_context(ALCdevice_struct* device, std::span<const int> attributes);

  ALCdevice_struct* device_;
  ALCcontext_struct* context_;
};

}  // namespace fulcrum::audio
