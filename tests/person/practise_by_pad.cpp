#include "tests/person/practise_by_pad.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "tests/person/clock.h"

namespace fulcrum::person {
namespace {

constexpr double kPadPatience = 60;  // s, for one checkpoint
constexpr double kAhead = 0.6;       // s, in which the tool would be there
constexpr double kFull = 0.5;  // heights of the picture in a second, of a stick that is pushed all the way
constexpr double kGone = 1;    // s, of a picture without ring and mark

// Half a push is a quarter of the speed.
double push_for(double way, double height) {
  const double part = std::min(1.0, std::abs(way) / (kAhead * kFull * height));
  return std::copysign(std::sqrt(part), way);
}

}  // namespace

void practise_by_pad(Trainee& trainee, Pad& pad, std::size_t checkpoints) {
  Sight seen = trainee.wait_for_scene();
  const auto began = Clock::now();
  auto here = began, seen_last = began;
  auto done = static_cast<std::size_t>(seen.done);
  while (done < checkpoints) {
    if (since(here) > kPadPatience)
      throw GaveUp("checkpoint " + std::to_string(done + 1) + " was not reached");
    if (seen.ring || seen.touch) seen_last = Clock::now();
    if (since(seen_last) > kGone) return;  // a card hides what is left of it
    PadPush push;
    // On to the middle of a ring that is orange already: at its rim nothing need be touched yet.
    if (seen.ring && seen.touch) {
      const Place way = seen.ring->middle - *seen.touch;
      push = {push_for(way.x, trainee.height()), push_for(-way.y, trainee.height()),
              push_for(seen.farther, trainee.height())};
    }
    pad.push(push);
    seen = trainee.look_on(0.02);
    if (static_cast<std::size_t>(seen.done) <= done) continue;
    done = static_cast<std::size_t>(seen.done);
    here = Clock::now();
    std::printf("checkpoint %zu after %.1f s\n", done, since(began));
    std::fflush(stdout);
  }
  pad.push({});
}

}  // namespace fulcrum::person
