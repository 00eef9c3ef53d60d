#include "engine/app/device_test/latency.h"

#include <algorithm>
#include <cmath>

#include "haptics/math/linear.h"

namespace fulcrum::app::device_test {
namespace {

using Column = Eigen::VectorXd;

constexpr double kBefore = 0.03;         // s before it is pushed harder, that are looked at
constexpr double kSlides = 0.3;          // of its highest speed: slower, it may stick
constexpr std::size_t kOver = 5;         // ticks, over which a speed is taken
constexpr double kFinest = 1e-4;         // s, of the latencies that are tried
constexpr double kSoonest = -2e-3;       // s: a simulated device moves half a tick early
constexpr double kMostUncertain = 1e-3;  // s
constexpr Eigen::Index kParameters = 7;  // of the fit, k and L among them
constexpr Eigen::Index kFewestTicks = 20;

// H: the way of a mass of 1 that the commands push from the first tick on.
class PushedMass {
public:
  explicit PushedMass(const Kick& kick) : kick_(kick), at_(kick.time.size()) {
    for (std::size_t i = 1; i < at_.size(); ++i) at_[i] = after(i - 1, kick.time[i] - kick.time[i - 1]);
  }
  double way(double time) const {
    const auto later = std::ranges::upper_bound(kick_.time, time);
    if (later == kick_.time.begin()) return 0;
    const auto i = static_cast<std::size_t>(later - kick_.time.begin()) - 1;
    return after(i, time - kick_.time[i]).way;
  }

private:
  struct At {
    double speed = 0, way = 0;
  };
  At after(std::size_t i, double h) const {
    const double force = kick_.commanded[i];
    return {at_[i].speed + force * h, at_[i].way + at_[i].speed * h + force * h * h / 2};
  }

  const Kick& kick_;
  std::vector<At> at_;  // at each tick
};

// The ticks [begin, end) in which the handle slides.
struct Window {
  std::size_t begin = 0, end = 0;
};

Window window_of(const Kick& kick) {
  const auto began =
      static_cast<std::size_t>(std::ranges::lower_bound(kick.time, kick.began) - kick.time.begin());
  Window window{began, began};
  if (began <= kOver) return window;
  const auto speed = [&](std::size_t i) {  // m/s, up to tick i
    return (kick.moved[i] - kick.moved[i - kOver]) / (kick.time[i] - kick.time[i - kOver]);
  };
  double highest = 0;
  for (std::size_t i = began; i < kick.time.size(); ++i) {
    if (!(speed(i) > highest)) continue;
    highest = speed(i);
    window.end = i;
  }
  while (window.end < kick.time.size() && speed(window.end) > kSlides * highest) ++window.end;
  while (window.begin > kOver && kick.began - kick.time[window.begin - 1] < kBefore &&
         speed(window.begin - 1) > 0)
    --window.begin;
  return window;
}

// Columns of length 1 that are orthogonal to each other.
class Base {
public:
  void add(const Column& column) { columns_.emplace_back(without(without(column)).normalized()); }
  // What is left of a column.
  Column without(Column column) const {
    for (const Column& each : columns_) column -= each.dot(column) * each;
    return column;
  }

private:
  std::vector<Column> columns_;
};

Column integral(const Column& of, const Column& time) {
  Column sum = Column::Zero(of.size());
  for (Eigen::Index i = 1; i < of.size(); ++i)
    sum[i] = sum[i - 1] + (time[i] - time[i - 1]) * (of[i] + of[i - 1]) / 2;
  return sum;
}

struct Fit {
  double latency = 0;  // s
  double k = 0;        // 1/kg
  double squares = 0;  // m^2
};

}  // namespace

std::optional<Latency> latency_of(const Kick& kick) {
  const Window window = window_of(kick);
  const auto rows = static_cast<Eigen::Index>(window.end - window.begin);
  if (rows < kFewestTicks) return std::nullopt;
  const auto column = [&](const std::vector<double>& of) -> Column {
    return Eigen::Map<const Column>(of.data() + window.begin, rows);
  };
  const Column time = (column(kick.time).array() - kick.time[window.begin]).matrix();
  const Column moved = column(kick.moved);
  Base base;
  base.add(Column::Ones(rows));
  base.add(time);
  base.add(time.cwiseAbs2());
  base.add(integral(moved, time));
  base.add(integral(integral(moved, time), time));
  const Column rest = base.without(moved);

  const PushedMass mass(kick);
  std::vector<Fit> fits;
  const auto tries = std::lround((kLargestLatency - kSoonest) / kFinest);
  for (int i = 0; i <= tries; ++i) {
    Fit fit{.latency = kSoonest + i * kFinest};
    Column way(rows);
    for (Eigen::Index j = 0; j < rows; ++j)
      way[j] = mass.way(kick.time[window.begin] + time[j] - fit.latency);
    way = base.without(way);
    fit.k = way.dot(rest) / way.squaredNorm();
    fit.squares = (rest - fit.k * way).squaredNorm();
    fits.push_back(fit);
  }
  const auto best = std::ranges::min_element(fits, {}, &Fit::squares);
  if (!(best->k > 0) || best == fits.begin() || best + 1 == fits.end()) return std::nullopt;
  const double bound = best->squares * (1 + 4 / static_cast<double>(rows - kParameters));
  const auto is_as_good = [&](const Fit& fit) { return fit.squares <= bound; };
  const auto first = std::ranges::find_if(fits, is_as_good);
  const auto last = std::find_if(fits.rbegin(), fits.rend(), is_as_good);
  const double uncertainty = (last->latency - first->latency) / 2;
  if (!(uncertainty <= kMostUncertain)) return std::nullopt;
  return Latency{best->latency, std::max(kFinest, uncertainty)};
}

}  // namespace fulcrum::app::device_test
