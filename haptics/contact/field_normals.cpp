#include "haptics/contact/field_normals.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "haptics/contact/field_normals.cpp"
#include "hwy/foreach_target.h"  // compiles this file once for each target; before highway.h

#include "haptics/contact/field_lookup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fulcrum::HWY_NAMESPACE {

template <class Value>
HWY_INLINE M across_cells(const FieldView& field, const Place& place, F& nx, F& ny, F& nz) {
  const F half = hn::Set(f, 0.5f);
  M known = hn::Eq(half, half);
  const auto difference = [&](F Place::*axis) {
    Place high = place, low = place;
    high.*axis = hn::Add(place.*axis, half);
    low.*axis = hn::Sub(place.*axis, half);
    Terms terms;
    const F at_high = look_up<Value>(field, high, terms);
    known = hn::And(known, terms.stored);
    const F at_low = look_up<Value>(field, low, terms);
    known = hn::And(known, terms.stored);
    return hn::Sub(at_high, at_low);
  };
  const F gx = difference(&Place::x), gy = difference(&Place::y), gz = difference(&Place::z);
  const F size = length(gx, gy, gz);
  known = hn::And(known, hn::Gt(size, hn::Set(f, kFlat * field.voxel_m)));
  const F divisor = hn::IfThenElse(known, size, hn::Set(f, 1.0f));
  nx = hn::Div(gx, divisor);
  ny = hn::Div(gy, divisor);
  nz = hn::Div(gz, divisor);
  return known;
}

template <class Value>
HWY_INLINE M of_cell(const FieldView& field, const Place& place, F& nx, F& ny, F& nz) {
  Terms terms;
  look_up<Value>(field, place, terms);
  if (hn::AllFalse(f, terms.stored)) {
    nx = ny = nz = hn::Zero(f);
    return terms.stored;
  }
  return unit_gradient(field, terms, nx, ny, nz);
}

template <class Value>
void look_up_batch(const FieldView& field, Normals kind, NormalBatch& batch) {
  batch.known = 0;
  for (std::size_t i = 0; i < kBlock; i += hn::Lanes(f)) {
    const Place place{hn::Load(f, &batch.x[i]), hn::Load(f, &batch.y[i]), hn::Load(f, &batch.z[i]), {}};
    F nx, ny, nz;
    const M known = kind == Normals::of_cell ? of_cell<Value>(field, place, nx, ny, nz)
                                             : across_cells<Value>(field, place, nx, ny, nz);
    hn::Store(nx, f, &batch.nx[i]);
    hn::Store(ny, f, &batch.ny[i]);
    hn::Store(nz, f, &batch.nz[i]);
    batch.known |= bits_of(known) << i;
  }
}

void normals_for_target(const FieldView& field, Normals kind, NormalBatch& batch) {
  if (field.format == FieldFormat::int16)
    look_up_batch<std::int16_t>(field, kind, batch);
  else
    look_up_batch<float>(field, kind, batch);
}

}  // namespace fulcrum::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fulcrum {

HWY_EXPORT(normals_for_target);

void look_up_normals(const FieldView& field, Normals kind, NormalBatch& batch) noexcept {
  HWY_DYNAMIC_DISPATCH(normals_for_target)(field, kind, batch);
}

}  // namespace fulcrum
#endif
