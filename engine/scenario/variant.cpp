#include "engine/scenario/variant.h"

#include <algorithm>
#include <utility>

#include "haptics/math/split_mix.h"

namespace fulcrum::scenario {
namespace {

// Below `end`.
std::size_t draw(SplitMix& random, std::size_t end) {
  return std::min(end - 1, static_cast<std::size_t>(random.uniform() * static_cast<double>(end)));
}

// Uniform in the unit ball.
Vec3 draw_in_ball(SplitMix& random) {
  Vec3 p;
  do {
    for (double& each : p) each = 2 * random.uniform() - 1;
  } while (p.squaredNorm() > 1);
  return p;
}

void come_after_what_is_there(Checkpoint& checkpoint, const std::vector<Checkpoint>& gone) {
  // Each names an earlier one of the file, so that this ends.
  for (auto before = gone.end();
       (before = std::ranges::find(gone, checkpoint.after, &Checkpoint::name)) != gone.end();)
    checkpoint.after = before->after;
}

}  // namespace

void vary(std::vector<Checkpoint>& checkpoints, const VariantDesc& variant, Order order, std::int64_t seed) {
  SplitMix random(static_cast<std::uint64_t>(seed));
  if (variant.spread > 0) {
    for (Checkpoint& checkpoint : checkpoints) {
      const Vec3 way = variant.spread * draw_in_ball(random);
      checkpoint.position += way;
      for (Vec3& corner : checkpoint.follow) corner += way;
    }
  }
  if (variant.shuffle)
    for (std::size_t i = checkpoints.size(); i > 1; --i)
      std::swap(checkpoints[i - 1], checkpoints[draw(random, i)]);
  if (variant.pick > 0) {
    std::ptrdiff_t left = std::ranges::count(checkpoints, false, &Checkpoint::optional);
    std::ptrdiff_t wanted = variant.pick;
    // Each is taken with the chance that makes any choice of so many as likely as any other.
    std::vector<Checkpoint> gone;
    std::erase_if(checkpoints, [&](const Checkpoint& checkpoint) {
      if (checkpoint.optional) return false;
      const bool taken = random.uniform() * static_cast<double>(left--) < static_cast<double>(wanted);
      if (taken) --wanted;
      if (!taken) gone.push_back(checkpoint);
      return !taken;
    });
    for (Checkpoint& checkpoint : checkpoints) come_after_what_is_there(checkpoint, gone);
  }
  if (order == Order::any) return;
  const auto last = std::ranges::find(checkpoints.rbegin(), checkpoints.rend(), false, &Checkpoint::optional);
  if (last != checkpoints.rend()) std::rotate(last.base() - 1, last.base(), checkpoints.end());
}

}  // namespace fulcrum::scenario
