#define AL_ALEXT_PROTOTYPES
#include "engine/audio/output.h"

#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>
#include <alsa/asoundlib.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "engine/audio/samples.h"

namespace fulcrum::audio {
namespace {

constexpr std::string_view kLibrarySettings =
    "[general]\n"
    "frequency = 48000\n"
    "period_size = 256\n"
    "periods = 4\n";

// ALSA tells of a device that is not there on stderr, in eight lines; a sentence of ours does.
void say_nothing(const char*, int, const char*, int, const char*, ...) {}

class QuietAlsa {
public:
  QuietAlsa() { snd_lib_error_set_handler(say_nothing); }
  ~QuietAlsa() { snd_lib_error_set_handler(nullptr); }
  QuietAlsa(const QuietAlsa&) = delete;
  QuietAlsa& operator=(const QuietAlsa&) = delete;
};

}  // namespace

// NOLINTBEGIN(concurrency-mt-unsafe): no thread runs yet.
void settle_library() {
  setenv("ALSOFT_LOGLEVEL", "0", 0);
  if (std::getenv("ALSOFT_CONF") != nullptr) return;
  const int file = memfd_create("openal", MFD_CLOEXEC);
  if (file < 0) return;  // then by the library's own settings, later
  if (write(file, kLibrarySettings.data(), kLibrarySettings.size()) ==
      static_cast<ssize_t>(kLibrarySettings.size()))
    setenv("ALSOFT_CONF", ("/proc/self/fd/" + std::to_string(file)).c_str(), 0);
}

// NOLINTEND(concurrency-mt-unsafe)

Result<Output> Output::with_context(ALCdevice_struct* device, std::span<const int> attributes) {
  ALCcontext_struct* context = alcCreateContext(device, attributes.data());
  if (context == nullptr) {
    alcCloseDevice(device);
    return Error{"the sound device gives no context"};
  }
  return Output(device, context);
}

Result<Output> Output::open() {
  const QuietAlsa quiet;
  ALCdevice* device = alcOpenDevice(nullptr);
  if (device == nullptr) return Error{"no sound device could be opened"};
  constexpr std::array kAttributes{ALC_FREQUENCY, kRate_Hz, ALC_HRTF_SOFT, ALC_TRUE, 0};
  return with_context(device, kAttributes);
}

Result<Output> Output::offline(bool hrtf) {
  ALCdevice* device = alcLoopbackOpenDeviceSOFT(nullptr);
  if (device == nullptr) return Error{"OpenAL Soft renders nothing without a device"};
  const std::array attributes{ALC_FREQUENCY,
                              kRate_Hz,
                              ALC_FORMAT_CHANNELS_SOFT,
                              ALC_STEREO_SOFT,
                              ALC_FORMAT_TYPE_SOFT,
                              ALC_FLOAT_SOFT,
                              ALC_HRTF_SOFT,
                              hrtf ? ALC_TRUE : ALC_FALSE,
                              ALC_OUTPUT_LIMITER_SOFT,
                              ALC_TRUE,
                              0};
  return with_context(device, attributes);
}

Output::Output(Output&& other) noexcept
    : device_(std::exchange(other.device_, nullptr)), context_(std::exchange(other.context_, nullptr)) {}

Output::~Output() {
  if (context_ != nullptr) alcDestroyContext(context_);
  if (device_ != nullptr) alcCloseDevice(device_);
}

void Output::use() const {
  alcSetThreadContext(context_);
}

void Output::let_go() {
  alcSetThreadContext(nullptr);
}

void Output::render(std::span<float> interleaved) const {
  alcRenderSamplesSOFT(device_, interleaved.data(), static_cast<ALCsizei>(interleaved.size() / 2));
}

bool Output::is_connected() const {
  ALCint connected = ALC_TRUE;
  alcGetIntegerv(device_, ALC_CONNECTED, 1, &connected);
  return connected != ALC_FALSE;
}

bool Output::has_hrtf() const {
  ALCint hrtf = ALC_FALSE;
  alcGetIntegerv(device_, ALC_HRTF_SOFT, 1, &hrtf);
  return hrtf != ALC_FALSE;
}

std::string Output::name() const {
  const ALCchar* name = alcGetString(device_, ALC_ALL_DEVICES_SPECIFIER);
  return name != nullptr ? name : "a sound device";
}

}  // namespace fulcrum::audio
