#include "haptics/contact/shell_walk.h"

#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "haptics/contact/shell_walk.cpp"
#include "hwy/foreach_target.h"  // compiles this file once for each target; before highway.h

#include "haptics/contact/field_lookup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fulcrum::HWY_NAMESPACE {

template <class Value>
class Walker {
public:
  explicit Walker(const ShellWalk& walk) : walk_(walk), nodes_(walk.tree->levels), margin_(walk.margin) {
    for (std::size_t i = 0; i < 9; ++i) turn_[i] = static_cast<float>(walk.turn[i]);
    for (std::size_t i = 0; i < 3; ++i) whole_.rest[i] = static_cast<float>(walk.shift[i]);
  }

  void visit(std::size_t level, std::size_t block) {
    if (level == 0) return visit_patch(block);
    const std::uint32_t near = near_children(nodes_[level - 1][block]);
    for (std::uint32_t left = near; left != 0; left &= left - 1)
      visit(level - 1, block * kBlock + static_cast<std::size_t>(__builtin_ctz(left)));
  }

private:
  // A place in the grid, as a lattice point and what remains.
  struct Origin {
    std::array<std::int32_t, 3> cell{};
    std::array<float, 3> rest{};  // cells
  };

  HWY_INLINE Origin origin_of(std::size_t patch) const {
    const std::array<float, 3>& middle = walk_.tree->middles[patch];
    const double x = static_cast<double>(middle[0]), y = static_cast<double>(middle[1]),
                 z = static_cast<double>(middle[2]);
    Origin origin;
    for (std::size_t r = 0; r < 3; ++r) {
      const double* a = &walk_.turn[3 * r];
      const double place = ((a[0] * x + a[1] * y) + a[2] * z) + walk_.shift[r];
      const double cell = std::abs(place) < kFarCells ? std::floor(place) : 0.0;
      origin.cell[r] = static_cast<std::int32_t>(cell);
      origin.rest[r] = static_cast<float>(place - cell);
    }
    return origin;
  }

  template <class Block>
  HWY_INLINE Place place_of(const Origin& origin, const Block& block, std::size_t i) const {
    const F x = hn::Load(f, &block.x[i]), y = hn::Load(f, &block.y[i]), z = hn::Load(f, &block.z[i]);
    const auto row = [&](std::size_t r) {
      const float* a = &turn_[3 * r];
      const F sum = hn::Add(hn::Add(hn::Mul(hn::Set(f, a[0]), x), hn::Mul(hn::Set(f, a[1]), y)),
                            hn::Mul(hn::Set(f, a[2]), z));
      return hn::Add(sum, hn::Set(f, origin.rest[r]));
    };
    return {row(0), row(1), row(2), origin.cell};
  }

  HWY_INLINE std::uint32_t near_children(const SphereTree::Spheres& block) const {
    const F margin = hn::Set(f, margin_), slack = hn::Set(f, walk_.slack);
    std::uint32_t near = 0;
    for (std::size_t i = 0; i < kBlock; i += hn::Lanes(f)) {
      Terms terms;
      const F distance = look_up<Value>(walk_.field, place_of(whole_, block, i), terms);
      const F radius = hn::Load(f, &block.radius[i]);
      const M of_brick = hn::And(terms.in_grid, hn::Le(radius, hn::Set(f, walk_.brick_edge)));
      const F errs = hn::IfThenElse(of_brick, hn::BitCast(f, gather(walk_.brick_slack, terms.brick)), slack);
      near |= bits_of(hn::Lt(distance, hn::Add(hn::Add(radius, margin), errs))) << i;
    }
    return near;
  }

  HWY_INLINE void visit_patch(std::size_t patch) {
    const SphereTree::Points& block = walk_.tree->patches[patch];
    PatchHit hit;
    hit.first = static_cast<std::uint32_t>(patch * kBlock);
    hit.touching = 0;
    const Origin origin = origin_of(patch);
    for (std::size_t i = 0; i < kBlock; i += hn::Lanes(f)) {
      Terms terms;
      const F distance = look_up<Value>(walk_.field, place_of(origin, block, i), terms);
      hn::Store(distance, f, &hit.distance[i]);
      hit.touching |= bits_of(hn::Lt(distance, hn::Set(f, margin_))) << i;
    }
    if (hit.touching != 0) margin_ = walk_.found(walk_.taker, hit);
  }

  static constexpr double kFarCells = 1e6;  // beyond any grid

  const ShellWalk& walk_;
  const std::vector<std::vector<SphereTree::Spheres>>& nodes_;
  float margin_;  // m
  std::array<float, 9> turn_{};
  Origin whole_;  // of the tool
};

void walk_for_target(const ShellWalk& walk) {
  const std::size_t root = walk.tree->levels.size();
  if (walk.field.format == FieldFormat::int16)
    Walker<std::int16_t>(walk).visit(root, 0);
  else
    Walker<float>(walk).visit(root, 0);
}

const char* target_name() {
  return hwy::TargetName(HWY_TARGET);
}

}  // namespace fulcrum::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fulcrum {

HWY_EXPORT(walk_for_target);
HWY_EXPORT(target_name);

void walk_shell(const ShellWalk& walk) noexcept {
  HWY_DYNAMIC_DISPATCH(walk_for_target)(walk);
}

const char* simd_target() {
  return HWY_DYNAMIC_DISPATCH(target_name)();
}

}  // namespace fulcrum
#endif
