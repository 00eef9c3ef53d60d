#include "engine/app/run/penetration.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <queue>

namespace fulcrum::app {
namespace {

constexpr std::size_t kSamples = std::size_t{1} << 19;  // kept at most: 9 minutes at 1 kHz, 50 MB
constexpr std::size_t kSeeds = 128;                     // measured first, spread over the run
constexpr double kTolerance = 1e-6;                     // m
// The work that is done at most: a few seconds. Without a field, most distances only tell of a triangle that
// it is clear, which costs less.
constexpr std::int64_t kPoses = 10'000, kDistances = 500'000, kDistancesWithoutField = 2'000'000,
                       kDistancesAPose = 50'000;

constexpr double kUnmeasured = std::numeric_limits<double>::infinity();

// What bounds the way of a point at distance 1 from T between two poses.
double turn_between(const Quat& a, const Quat& b) {
  return 2 * (a.conjugate() * b).vec().norm();
}

}  // namespace

void PenetrationMeter::note(const TickRecord& record) {
  if (!record.X_WT.is_finite()) return;
  Sample sample{record.tick, record.X_WT, record.depth_max, 0, 0};
  if (!samples_.empty()) {
    sample.moved = last_.moved + (record.X_WT.p - last_.X_WT.p).norm();
    sample.turned = last_.turned + turn_between(last_.X_WT.q, record.X_WT.q);
  }
  last_ = sample;
  // Of a thinned run each interval keeps the tick that was deepest as the tick saw it.
  if (!samples_.empty() && record.tick / every_ticks_ == samples_.back().tick / every_ticks_) {
    if (sample.field_depth > samples_.back().field_depth) samples_.back() = sample;
    return;
  }
  samples_.push_back(sample);
  if (samples_.size() >= kSamples) thin();
}

void PenetrationMeter::thin() {
  every_ticks_ *= 2;
  std::vector<Sample> kept;
  kept.reserve(samples_.size() / 2 + 1);
  for (const Sample& sample : samples_)
    if (kept.empty() || sample.tick / every_ticks_ != kept.back().tick / every_ticks_)
      kept.push_back(sample);
    else if (sample.field_depth > kept.back().field_depth)
      kept.back() = sample;
  samples_ = std::move(kept);
}

namespace {

// The measured ticks of a run and the intervals between them.
template <class Sample>
class DeepestTick {
public:
  // distances: that are computed at most.
  DeepestTick(const std::vector<Sample>& samples, const OverlapDepth& overlap, std::int64_t distances)
      : samples_(samples),
        overlap_(overlap),
        most_distances_(distances),
        bound_(samples.size(), kUnmeasured) {}

  void run(bool every_tick) {
    every_tick_ = every_tick;
    for (const std::size_t seed : seeds()) measure(seed);
    std::optional<std::size_t> before;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      if (bound_[i] == kUnmeasured) continue;
      if (before) push(*before, i);
      before = i;
    }
    while (!waiting_.empty()) {
      const Interval interval = waiting_.top();
      if (interval.bound <= found_.depth + kTolerance || poses_ >= kPoses || distances_ >= most_distances_) {
        left_over(interval.bound);
        return;
      }
      waiting_.pop();
      const std::size_t middle = middle_of(interval);
      measure(middle);
      push(interval.from, middle);
      push(middle, interval.to);
    }
  }

  const DeepestOverlap& found() const { return found_; }
  std::size_t place() const { return place_; }
  double bound() const { return std::max(most_, found_.depth); }

private:
  struct Interval {
    double bound;  // m, of the depth in the ticks between
    std::size_t from, to;
    bool operator<(const Interval& other) const {
      return bound != other.bound ? bound < other.bound : from > other.from;
    }
  };

  // Both ends, and of every part of the run the tick that was deepest by the field; the deepest first.
  std::vector<std::size_t> seeds() const {
    std::vector<std::size_t> seeds{0, samples_.size() - 1};
    const std::size_t part = samples_.size() / kSeeds + 1;
    for (std::size_t begin = 0; begin < samples_.size(); begin += part) {
      std::size_t deepest = begin;
      for (std::size_t i = begin; i < std::min(begin + part, samples_.size()); ++i)
        if (samples_[i].field_depth > samples_[deepest].field_depth) deepest = i;
      seeds.push_back(deepest);
    }
    std::sort(seeds.begin(), seeds.end(), [&](std::size_t a, std::size_t b) {
      return samples_[a].field_depth != samples_[b].field_depth
                 ? samples_[a].field_depth > samples_[b].field_depth
                 : a < b;
    });
    return seeds;
  }

  void measure(std::size_t i) {
    if (bound_[i] != kUnmeasured) return;
    const DeepestOverlap overlap = overlap_.at(
        samples_[i].X_WT, {.above = found_.depth, .tolerance = kTolerance, .distances = kDistancesAPose});
    ++poses_;
    distances_ += overlap.distances;
    bound_[i] = overlap.bound - overlap.clearance;
    left_over(overlap.bound);
    if (!(overlap.depth > found_.depth)) return;
    found_ = overlap;
    place_ = i;
  }

  double way(std::size_t from, std::size_t to) const {
    return samples_[to].moved - samples_[from].moved +
           overlap_.reach() * (samples_[to].turned - samples_[from].turned);
  }
  void push(std::size_t from, std::size_t to) {
    const double bound = (bound_[from] + bound_[to] + way(from, to)) / 2;
    if (to - from > 1)
      waiting_.push({bound, from, to});
    else if (!every_tick_)
      left_over(bound);
  }
  std::size_t middle_of(const Interval& interval) const {
    std::size_t low = interval.from + 1, high = interval.to - 1;
    const double half = way(interval.from, interval.to) / 2;
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      if (way(interval.from, middle) < half)
        low = middle + 1;
      else
        high = middle;
    }
    return low;
  }
  void left_over(double bound) { most_ = std::max(most_, bound); }

  const std::vector<Sample>& samples_;
  const OverlapDepth& overlap_;
  std::int64_t most_distances_;
  std::vector<double> bound_;  // m, of the ticks that were measured: below 0 where the tool was clear
  std::priority_queue<Interval> waiting_;
  DeepestOverlap found_;
  std::size_t place_ = 0;
  double most_ = 0;  // m, no tick was deeper
  bool every_tick_ = true;
  std::int64_t poses_ = 0, distances_ = 0;
};

}  // namespace

Penetration PenetrationMeter::deepest(const Solid& scene_W, const Solid& tool_T,
                                      const DistanceField* field) const {
  if (samples_.empty()) return {};
  const OverlapDepth overlap(scene_W, tool_T, field);
  DeepestTick search(samples_, overlap, field != nullptr ? kDistances : kDistancesWithoutField);
  search.run(every_ticks_ == 1);
  return {.depth = search.found().depth,
          .within = search.bound() - search.found().depth,
          .at = static_cast<double>(samples_[search.place()].tick) * tick_s_,
          .p_W = search.found().p_W};
}

}  // namespace fulcrum::app
