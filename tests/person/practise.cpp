#include "tests/person/practise.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <thread>

#include "tests/person/clock.h"

namespace fulcrum::person {
namespace {

constexpr double kPatience = 30;  // s, for one checkpoint

class Practice {
public:
  Practice(Trainee& trainee, const Plan& plan, const Sight& seen)
      : trainee_(trainee), clearance_(plan.clearance * trainee.height()), seen_(seen) {}

  // false: the trial is over, and nothing is left to see of it.
  bool come_to(std::size_t number, const Leg& leg) {
    const auto began = Clock::now();
    const bool sees_way = seen_.ring && seen_.touch;
    if (length(leg.detour) > 0 && sees_way) {
      const Place side = leg.detour * trainee_.height();
      trainee_.slide(side);
      seen_.touch = *seen_.touch + side;
      go(side, 0);
    } else if (leg.roll != 0 && sees_way) {
      go({}, leg.roll * trainee_.height());
    }
    while (static_cast<std::size_t>(seen_.done) <= number) {
      if (since(began) > kPatience)
        throw GaveUp("checkpoint " + std::to_string(number + 1) + " was not reached");
      if (seen_.ring && seen_.ring->filling)
        stay_for(leg);
      else if (seen_.ring && seen_.touch)
        go({}, 0);
      else if (seen_.ring && seen_.lost)
        fetch(*seen_.lost);
      else if (seen_.ring && is_hidden())
        fetch({1, 0});
      else if (is_over())
        return false;
    }
    return true;
  }

private:
  // To the ring, or that far from it, rolled by so long a drag before it goes in. Nearer first and farther
  // last: what is seen can be reached from where it is seen.
  void go(const Place& beside, double roll) {
    const Place way = seen_.ring->middle + beside - *seen_.touch;
    std::printf("  %5.1f s: %.0f, %.0f px to the right and down, %.0f px farther\n", since(began_), way.x,
                way.y, seen_.farther);
    const bool is_near = length(way) < kNear && std::abs(seen_.farther) < kNear;
    const double clearance = is_near ? 0 : clearance_;
    trainee_.push(std::min(seen_.farther, 0.0) - clearance);
    trainee_.slide(way);
    trainee_.roll(roll);
    trainee_.push(std::max(seen_.farther, 0.0) + clearance);
    const Sight before = seen_;
    const Place expected = *before.touch + way;
    seen_ = trainee_.settled(before, expected, 0);
    // Held up by something: back to where nothing is, and from there anew.
    const bool held_up = seen_.done == before.done && seen_.touch && !(seen_.ring && seen_.ring->filling) &&
                         length(*seen_.touch - expected) > kNear;
    if (!held_up) return;
    std::printf("  %5.1f s: held up\n", since(began_));
    const Sight held = seen_;
    const double back = kBack * trainee_.height();
    trainee_.push(-back);
    seen_ = trainee_.settled(held, expected, back);
  }

  // A tool that is out of the picture, into it.
  void fetch(const Place& lost) {
    std::printf("  %5.1f s: out of the picture\n", since(began_));
    trainee_.slide(lost * (-kFetch * trainee_.height()));
    // A picture is older than the hand.
    const auto asked = Clock::now();
    do stay();
    while (since(asked) < 0.4);
  }

  void stay_for(const Leg& leg) {
    if (leg.stops) trainee_.stop_for_a_moment();
    if (leg.touches) trainee_.push(kOnwards);
    const auto asked = Clock::now();
    do stay();
    while ((leg.stops || leg.touches) && since(asked) < 0.6);
  }

  void stay() {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    seen_ = trainee_.look();
  }

  // The mark of the touch point is not told from the knobs of the panels at the right: a tool that stays
  // among them has to be taken out to be seen.
  bool is_hidden() {
    const auto began = Clock::now();
    while (since(began) < 1) {
      stay();
      if (!seen_.ring || seen_.touch || seen_.lost) return false;
    }
    return true;
  }

  // A card hides the list once the trial is over, and nothing shows the way any more.
  bool is_over() {
    const auto began = Clock::now();
    while (since(began) < 1) {
      stay();
      if (seen_.ring || seen_.touch) return false;
    }
    return true;
  }

  static constexpr double kNear = 6;      // px
  static constexpr double kOnwards = 6;   // px, from one look to the next
  static constexpr double kBack = 0.08;   // heights of the picture
  static constexpr double kFetch = 0.25;  // heights of the picture

  Trainee& trainee_;
  double clearance_;  // px
  Sight seen_;
  Clock::time_point began_ = Clock::now();
};

}  // namespace

void practise(Trainee& trainee, const Plan& plan) {
  Sight seen = trainee.wait_for_scene();
  if (plan.view != 0) seen = trainee.go_to_view(plan.view);
  Practice practice(trainee, plan, seen);
  const auto began = Clock::now();
  for (std::size_t i = 0; i < plan.legs.size(); ++i) {
    if (!practice.come_to(i, plan.legs[i])) return;
    std::printf("checkpoint %zu after %.1f s\n", i + 1, since(began));
    std::fflush(stdout);
  }
}

}  // namespace fulcrum::person
