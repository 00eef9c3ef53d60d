#pragma once
// The shell points that touch the scene in one tick, or are about to, in storage that is sized once.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "haptics/math/linear.h"

namespace fulcrum {

inline constexpr std::size_t kMaxContacts = 256;
inline constexpr std::size_t kMaxRegions = 32;

struct Contact {
  std::uint32_t point = 0;     // index in the shell
  Vec3 p_W = Vec3::Zero();     // (3) m
  Vec3 nhat_W = Vec3::Zero();  // (3) unit, out of the scene: the direction in which the tool is pushed
  double depth = 0;            // m, > 0 inside the scene, < 0 outside
  double area = 0;             // m^2 of tool surface
};

// Touching points that lie together and are pushed alike. An id lasts as long as the region is touched.
struct ContactRegion {
  std::uint32_t id = 0;
  std::int64_t age_ticks = 0;   // 0 in the tick in which it appears
  Vec3 p_W = Vec3::Zero();      // (3) m, centre of pressure
  Vec3 nhat_W = Vec3::Zero();   // (3) unit, weighted likewise
  Vec3 force_W = Vec3::Zero();  // (3) N on the tool
  double depth_max = 0;         // m
  double approach_speed = 0;    // m/s of the tool into the scene at p_W, < 0 when leaving
  std::uint32_t points = 0;
};

class ContactSet {
public:
  ContactSet() { contacts_.reserve(kMaxContacts); }

  void clear() noexcept { contacts_.clear(); }
  // Past the capacity the shallowest contact makes room; false if something was left out.
  bool add(const Contact& contact) noexcept;
  std::span<const Contact> contacts() const { return contacts_; }
  double depth_max() const;  // m, 0 when nothing touches

private:
  std::vector<Contact> contacts_;
};

}  // namespace fulcrum
