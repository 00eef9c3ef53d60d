#include "haptics/contact/shell_walk.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "haptics/contact/shell_walk.cpp"
#include "hwy/foreach_target.h"  // compiles this file once for each target; before highway.h

#include "haptics/contact/field_lookup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fulcrum::HWY_NAMESPACE {

HWY_INLINE std::uint32_t bits_of(M mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(f, mask, bytes);
  return static_cast<std::uint32_t>(bytes[0] | bytes[1] << 8);
}

template <class Value>
class Walker {
public:
  explicit Walker(const ShellWalk& walk) : walk_(walk), nodes_(walk.tree->levels) {}

  void visit(std::size_t level, std::size_t block) const {
    if (level == 0) return visit_patch(block);
    const std::uint32_t near = near_children(nodes_[level - 1][block]);
    for (std::uint32_t left = near; left != 0; left &= left - 1)
      visit(level - 1, block * kBlock + static_cast<std::size_t>(__builtin_ctz(left)));
  }

private:
  template <class Block>
  HWY_INLINE Place place_of(const Block& block, std::size_t i) const {
    const F x = hn::Load(f, &block.x[i]), y = hn::Load(f, &block.y[i]), z = hn::Load(f, &block.z[i]);
    const auto row = [&](std::size_t r) {
      const float* a = &walk_.turn[3 * r];
      const F sum = hn::Add(hn::Add(hn::Mul(hn::Set(f, a[0]), x), hn::Mul(hn::Set(f, a[1]), y)),
                            hn::Mul(hn::Set(f, a[2]), z));
      return hn::Add(sum, hn::Set(f, walk_.shift[r]));
    };
    return {row(0), row(1), row(2)};
  }

  HWY_INLINE std::uint32_t near_children(const SphereTree::Spheres& block) const {
    const F threshold = hn::Set(f, walk_.margin + walk_.slack);
    std::uint32_t near = 0;
    for (std::size_t i = 0; i < kBlock; i += hn::Lanes(f)) {
      Terms terms;
      const F distance = look_up<Value>(walk_.field, place_of(block, i), terms);
      const F reach = hn::Add(hn::Load(f, &block.radius[i]), threshold);
      near |= bits_of(hn::Lt(distance, reach)) << i;
    }
    return near;
  }

  HWY_INLINE void visit_patch(std::size_t patch) const {
    const SphereTree::Points& block = walk_.tree->patches[patch];
    PatchHit hit;
    hit.first = static_cast<std::uint32_t>(patch * kBlock);
    hit.touching = 0;
    hit.guessed = 0;
    for (std::size_t i = 0; i < kBlock; i += hn::Lanes(f)) {
      Terms terms;
      const F distance = look_up<Value>(walk_.field, place_of(block, i), terms);
      hn::Store(distance, f, &hit.distance[i]);
      const M touching = hn::Lt(distance, hn::Set(f, walk_.margin));
      if (hn::AllFalse(f, touching)) continue;
      const std::uint32_t bits = bits_of(touching);
      hit.touching |= bits << i;
      if (!walk_.normals) continue;
      std::uint32_t known = 0;
      if (!hn::AllFalse(f, terms.stored)) {
        F nx, ny, nz;
        known = bits_of(unit_gradient(walk_.field, terms, nx, ny, nz));
        hn::Store(nx, f, &hit.nx[i]);
        hn::Store(ny, f, &hit.ny[i]);
        hn::Store(nz, f, &hit.nz[i]);
      }
      hit.guessed |= (bits & ~known) << i;
    }
    if (hit.touching != 0) walk_.found(walk_.taker, hit);
  }

  const ShellWalk& walk_;
  const std::vector<std::vector<SphereTree::Spheres>>& nodes_;
};

void walk_for_target(const ShellWalk& walk) {
  const std::size_t root = walk.tree->levels.size();
  if (walk.field.format == FieldFormat::int16) {
    Walker<std::int16_t>(walk).visit(root, 0);
  } else {
    Walker<float>(walk).visit(root, 0);
  }
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
