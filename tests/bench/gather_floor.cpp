#include "tests/bench/gather_floor.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/bench/gather_floor.cpp"
#include "hwy/foreach_target.h"  // before highway.h

#include "haptics/contact/field_lookup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fulcrum::HWY_NAMESPACE {

std::int32_t read_for_target(const std::int16_t* values, const std::int32_t* offsets, std::size_t count) {
  I sum = hn::Zero(n);
  for (std::size_t i = 0; i < count; i += hn::Lanes(n)) {
    const I at = hn::LoadU(n, offsets + i);
    sum = hn::Or(sum, gather(values, at));
    sum = hn::Or(sum, gather(values + kBrickSide, at));
    sum = hn::Or(sum, gather(values + kBrickSide * kBrickSide, at));
    sum = hn::Or(sum, gather(values + kBrickSide * kBrickSide + kBrickSide, at));
  }
  return hn::GetLane(sum);
}

}  // namespace fulcrum::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fulcrum {
HWY_EXPORT(read_for_target);
namespace bench {

std::int32_t read_alone(const std::int16_t* values, std::span<const std::int32_t> offsets) {
  return HWY_DYNAMIC_DISPATCH(read_for_target)(values, offsets.data(), offsets.size());
}

}  // namespace bench
}  // namespace fulcrum
#endif
