// FNV-1a (draft-eastlake-fnv-17), a 64-bit word at a time instead of an octet, each followed by a fold of the
// high half into the low one: a product carries upwards only, and without the fold the low bits would never
// see the high.
#include "engine/record/digest.h"

#include <bit>
#include <concepts>
#include <span>

#include "haptics/signal/quantity.h"

namespace fulcrum::record {

namespace {

// The visitor of describe(), see haptics/signal/quantity.h: it takes the values and leaves out what they are
// called.
class Digest {
public:
  void time(const Quantity&, std::int64_t tick) { add(tick); }
  void number(const Quantity&, double value) { add(value); }
  void count(const Quantity&, std::int64_t value) { add(value); }
  void vector(const Quantity&, const Vec3& v) { add(v); }
  void length(const Quantity&, const Vec3& v) { add(v); }
  void wrench(const Quantity&, const Wrench& F) { add(F); }
  void pose(const Quantity&, const Pose& X) {
    add(X.q.w());
    add(Vec3(X.q.vec()));
    add(X.p);
  }
  void each(const Quantity&, std::span<const double> all, std::span<const std::string>) {
    for (const double value : all) add(value);
  }
  void unseen(const auto& value) { add(value); }
  const RecordNames& names() const { return names_; }

  std::uint64_t hash() const { return hash_; }

private:
  void add(std::uint64_t word) {
    hash_ = (hash_ ^ word) * 0x100000001b3u;
    hash_ ^= hash_ >> 32;
  }
  void add(std::integral auto value) { add(static_cast<std::uint64_t>(value)); }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(const Vec3& v) {
    for (const double component : v) add(component);
  }
  void add(const Wrench& F) {
    add(F.force);
    add(F.torque);
  }

  RecordNames names_{};
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

}  // namespace

std::uint64_t digest(const TickRecord& record) {
  Digest values;
  describe(values, record);
  return values.hash();
}

}  // namespace fulcrum::record
