#include <algorithm>

#include "engine/app/device_test/parts.h"
#include "haptics/math/number_text.h"

namespace fulcrum::app::device_test {
namespace {

constexpr double kStrength = 0.5;    // of a channel's largest
constexpr double kGlide = 0.02;      // s
constexpr double kLastsFor = 0.5;    // s
constexpr double kCarrier_Hz = 233;  // of a channel that has no resonance to be driven at

void drive(TestBench& bench, const VibrotactileCommand& command, double seconds) {
  const double begun = bench.tick({}, command).time;
  while (!bench.over() && bench.tick({}, command).time - begun < seconds) {
  }
}

}  // namespace

VibrotactileSignal signal_of_test(const VibrotactileDesc& vibrators) {
  VibrotactileSignal signal{.carrier_Hz = kCarrier_Hz, .largest = 0};
  for (const ChannelDesc& channel : vibrators.channels) {
    if (channel.resonance_Hz > 0) signal.carrier_Hz = channel.resonance_Hz;
    signal.largest = std::max(signal.largest, kStrength * channel.largest);
  }
  return signal;
}

void vibrate(TestBench& bench, Person& person, Findings& findings) {
  if (!bench.desc().vibrotactile) {
    findings.parts.push_back({"vibration", Outcome::unknown, "It has no channels."});
    return;
  }
  const std::vector<ChannelDesc> channels = bench.desc().vibrotactile->channels;
  for (std::size_t i = 0; i < channels.size() && !bench.over(); ++i) {
    Part part{.name = "vibration " + channels[i].name, .says = "Left out."};
    if (answer_of(bench, person, "It is going to vibrate on '" + channels[i].name + "'. Go on?") ==
        Answer::yes) {
      VibrotactileCommand command{.glide = kGlide};
      command.level[i] = kStrength * channels[i].largest;
      drive(bench, command, kLastsFor);
      drive(bench, {.glide = kGlide}, 5 * kGlide);
      part.says = "It was driven for half a second; nobody was there to feel it.";
      part.measures = {{"level", kStrength * channels[i].largest, "m/s^2"}};
      if (person.there()) {
        const Answer felt = answer_of(bench, person, "Did it vibrate there, and nowhere else?");
        part.outcome = felt == Answer::yes ? Outcome::good : Outcome::bad;
        part.says = felt == Answer::yes ? "It was felt." : "It was not felt where it should be.";
      }
    }
    findings.parts.push_back(std::move(part));
  }
}

}  // namespace fulcrum::app::device_test
