#pragma once
// The shell points that touch the scene in one tick, or are about to, in storage that is sized once.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "haptics/math/linear.h"

namespace fulcrum {

inline constexpr std::size_t kMaxContacts = 256;
inline constexpr std::size_t kMaxRegions = 32;

// How much of the tool lies in the scene about some points, and where: sums over them.
struct Overlap {
  double area = 0;              // m^2 of tool surface
  double volume = 0;            // m^3, of area x depth
  double moment = 0;            // m^4, of area x depth^2
  Vec3 centred = Vec3::Zero();  // (3) m^4, of area x depth x p

  static Overlap of(double area, double depth, const Vec3& p) {
    const double inside = area * std::max(depth, 0.0);
    return {area, inside, inside * depth, inside * p};
  }
  Overlap& operator+=(const Overlap& other) {
    area += other.area;
    volume += other.volume;
    moment += other.moment;
    centred += other.centred;
    return *this;
  }
  double mean_depth() const { return volume > 0 ? moment / volume : 0.0; }  // m, weighted by the overlap
};

struct Contact {
  std::uint32_t point = 0;     // index in the shell
  Vec3 p_W = Vec3::Zero();     // (3) m
  Vec3 nhat_W = Vec3::Zero();  // (3) unit, out of the scene: the direction in which the tool is pushed
  double depth = 0;            // m, minus the distance: negative for a point within a query's margin
  Overlap overlap;             // of the points that it stands for, in W

  // (3) m: where the overlap presses.
  Vec3 pressed_W() const { return overlap.volume > 0 ? Vec3(overlap.centred / overlap.volume) : p_W; }
};

// Touching points that lie together and are pushed alike. An id lasts as long as the region is touched.
struct ContactRegion {
  std::uint32_t id = 0;
  std::int64_t age_ticks = 0;   // 0 in the tick in which it appears
  Vec3 p_W = Vec3::Zero();      // (3) m, centre of pressure
  Vec3 nhat_W = Vec3::Zero();   // (3) unit, mean of the normals, weighted as the centre of pressure
  Vec3 force_W = Vec3::Zero();  // (3) N on the tool
  double depth_max = 0;         // m
  double approach_speed = 0;    // m/s of the tool into the scene at p_W, < 0 when leaving
  std::uint32_t points = 0;
};

// Where more points touch than fit, neighbours are taken together: the contacts of an aligned run of 16
// points, a compact patch of the shell, become one, the deepest of them with all of their overlap; then those
// of runs of 32, 64 and so on. All of the touched surface stays represented, by between half the capacity and
// all of it.
class ContactSet {
public:
  ContactSet() { contacts_.reserve(kMaxContacts); }

  void clear() noexcept {
    contacts_.clear();
    run_bits_ = 0;
  }
  // In the order of the shell. Constant time but for a pass over the set each time that runs double.
  void add(const Contact& contact) noexcept;
  // add(), where no more is needed than to credit the overlap to a deeper contact of the same run; false if
  // the contact itself is wanted.
  bool absorb(std::uint32_t point, double depth, const Overlap& overlap) noexcept;
  bool complete() const { return run_bits_ == 0; }  // nothing has been taken together
  std::span<const Contact> contacts() const { return contacts_; }
  std::span<Contact> contacts() { return contacts_; }
  double depth_max() const;  // m, 0 when nothing touches

private:
  bool of_one_run(const Contact& a, std::uint32_t point) const noexcept {
    return a.point >> run_bits_ == point >> run_bits_;
  }
  void lengthen_runs() noexcept;

  std::vector<Contact> contacts_;
  unsigned run_bits_ = 0;  // a run has 2^run_bits_ points
};

}  // namespace fulcrum
