#include <algorithm>
#include <cmath>

#include "engine/app/device_test/parts.h"
#include "haptics/math/number_text.h"

namespace fulcrum::app::device_test {
namespace {

constexpr double kSettles = 0.6;     // s, in which the force ramps in, too
constexpr double kListens = 2;       // s
constexpr double kEnoughRate = 0.8;  // of the table's
constexpr double kTrembles = 3;      // encoder steps, rms

// share: 0 to 1 of the values are smaller.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, values.begin() + at);
  return values[static_cast<std::size_t>(at)];
}

// (6) m and rad rms about the mean of each.
Vec6 tremble(const std::vector<Vec6>& ways) {
  if (ways.empty()) return Vec6::Zero();
  Vec6 mean = Vec6::Zero(), square = Vec6::Zero();
  for (const Vec6& way : ways) mean += way / static_cast<double>(ways.size());
  for (const Vec6& way : ways) square += (way - mean).cwiseAbs2() / static_cast<double>(ways.size());
  return square.cwiseSqrt();
}

struct Heard {
  double rate_Hz = 0;
  Vec6 noise = Vec6::Zero();    // (6) m and rad rms
  std::uint32_t buttons = ~0U;  // that were down all the time
};

Heard hear(TestBench& bench, std::vector<double>& ages) {
  Heard heard;
  std::vector<Vec6> ways;
  const BenchTick begun = bench.tick();
  double time = begun.time;
  while (!bench.over() && time - begun.time < kListens) {
    const BenchTick& now = bench.tick();
    time = now.time;
    if (bench.stopped()) break;  // such a sample may be no number
    ages.push_back(now.sample.age);
    heard.buttons &= now.sample.buttons;
    if (now.fresh) ways.push_back(way_between(begun.sample.X_DH, now.sample.X_DH));
  }
  heard.rate_Hz = static_cast<double>(ways.size()) / std::max(time - begun.time, bench.tick_s());
  heard.noise = tremble(ways);
  return heard;
}

Part samples_part(const TestBench& bench, const Heard& heard, const std::vector<double>& ages) {
  const double own = bench.desc().sample_rate_Hz, ticks = 1 / bench.tick_s();
  const double expected = own > 0 ? std::min(own, ticks) : ticks;
  const double median = quantile(ages, 0.5), p99 = quantile(ages, 0.99);
  Part part{.name = "samples"};
  part.says = number_text(heard.rate_Hz, 4) + " new samples a second, as ticks see them; they are " +
              number_text(1e3 * median, 2) + " ms old in the median and " + number_text(1e3 * p99, 2) +
              " ms at most in 99 of 100 ticks.";
  part.outcome = Outcome::good;
  if (heard.rate_Hz <= 0) {
    part.outcome = Outcome::bad;
    part.says = "It is connected, and says nothing new: switch it off and on.";
  } else if (heard.rate_Hz < kEnoughRate * expected) {
    part.outcome = Outcome::odd;
    part.says +=
        " Its table has " + number_text(own, 4) + ": see `fulcrum doctor`, and use another USB port.";
  }
  part.measures = {{"rate", heard.rate_Hz, "Hz"},
                   {"rate in the table", own, "Hz"},
                   {"age, median", 1e3 * median, "ms"},
                   {"age, 99 %", 1e3 * p99, "ms"}};
  return part;
}

Part noise_part(const DeviceDesc& device, const Vec6& noise) {
  const double way = noise.head<3>().maxCoeff(), turn = noise.tail<3>().maxCoeff();
  Part part{.name = "noise at rest"};
  part.says = "At rest it trembles by " + number_text(1e6 * way, 3) + " um rms";
  if (device.senses_rotation) part.says += " and " + number_text(1e3 * turn, 3) + " mrad";
  part.says += " on its worst axis.";
  const bool quiet = way <= kTrembles * device.encoder_step &&
                     (!device.senses_rotation || turn <= kTrembles * device.encoder_step_rad);
  part.outcome = quiet ? Outcome::good : Outcome::odd;
  if (!quiet)
    part.says +=
        " That is more than three steps of its encoders: was it held? Otherwise look for a loose cable, or a "
        "table that shakes.";
  const char* const axes[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis)
    part.measures.push_back({std::string("rms ") + axes[axis], 1e6 * noise[axis], "um"});
  for (int axis = 0; device.senses_rotation && axis < 3; ++axis)
    part.measures.push_back({std::string("rms about ") + axes[axis], 1e3 * noise[3 + axis], "mrad"});
  part.measures.push_back({"encoder step in the table", 1e6 * device.encoder_step, "um"});
  return part;
}

}  // namespace

void listen(TestBench& bench, Person& person, Findings& findings) {
  if (answer_of(bench, person, "Let go of it, so that it rests for three seconds. Go on?") == Answer::no) {
    if (!bench.over()) findings.parts.push_back({"samples", Outcome::unknown, "Left out."});
    return;
  }
  pause(bench, kSettles);
  const Heard heard = hear(bench, findings.ages);
  findings.parts.push_back(samples_part(bench, heard, findings.ages));
  findings.parts.push_back(noise_part(bench.desc(), heard.noise));
  if (heard.buttons != 0 && !bench.over())
    findings.parts.push_back({"buttons at rest",
                              Outcome::odd,
                              "A button is down though nobody presses it: see whether it sticks.",
                              {{"buttons down", static_cast<double>(heard.buttons), "bits"}}});
}

}  // namespace fulcrum::app::device_test
