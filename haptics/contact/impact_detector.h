#pragma once
// Finds impacts among the contact regions of a tick: regions that were not there, met while the hand
// approaches.
//
// What touches is remembered as places: points of the tool, at most kPlaces, half a region's radius apart,
// each with the normal against which it was pressed. A region is new where no contact of it lies within a
// region's radius of a remembered place whose normal is within 60 degrees of its own. What identity regions
// have plays no part, so that one which splits, merges, jumps or gets another id stays what it was; while the
// tool rests, slides or rolls its places go along with what touches. A place is forgotten, and may be struck
// again, once it no longer touches and its point of the tool is farther than the retreat
//     from the scene's surface, or
//     along the normal from where it was pressed last: the tip of a tool that slides along a floor from one
//     blow on a wall to the next.
// Beyond the field's band a distance is a lower bound: there the first may come late, by half a brick's
// diagonal at most, and the second tells of a straight retreat in time.
//
// The speed is that of the hand's motion: under the response constraint the tool has been stopped already in
// the tick in which it touches. What touches on the first tick, or without approach, is remembered and is no
// impact.

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "haptics/contact/impact.h"
#include "haptics/contact/regions.h"
#include "haptics/geometry/distance_field.h"
#include "haptics/geometry/object_map.h"
#include "haptics/math/pose.h"

namespace fulcrum {

struct ImpactDetectorDesc {
  double retreat = 3e-3;       // m, in the scene
  double least_speed = 10e-3;  // m/s, of approach; slower is no impact
};

class ImpactDetector {
public:
  // Twice what can touch in one tick: beyond it the one that touched longest ago is forgotten, never one that
  // touches.
  static constexpr std::size_t kPlaces = 2 * kMaxContacts;

  // region_radius m: as in ContactDesc. objects: null in a scene of one object.
  ImpactDetector(const ImpactDetectorDesc& desc, double region_radius,
                 std::shared_ptr<const DistanceField> scene_field, std::shared_ptr<const ObjectMap> objects);

  struct Tick {
    Pose X_WT;   // of the tool, when `touching` was found
    Pose X_WG;   // where the hand wants the tool
    Twist V_WG;  // how fast
    Touching touching;
  };
  // Answers impacts(): one for each new region, in the order of the regions. May: change its memory. Must
  // not: allocate, lock, throw.
  std::span<const Impact> process(const Tick& tick) noexcept;

  std::span<const Impact> impacts() const { return {impacts_.data(), impact_count_}; }  // of the last tick
  std::size_t places() const { return count_; }                                         // remembered now

private:
  struct Place {
    Vec3 p_T = Vec3::Zero();     // (3) m, of the tool
    Vec3 nhat_W = Vec3::Zero();  // (3) unit, against which it was pressed last
    double surface = 0;          // m, along nhat_W, where the scene began there
    std::int64_t tick = 0;       // when it touched last
  };
  void strike(const Tick& tick, std::size_t region, const Pose& X_TW) noexcept;
  void remember(const Pose& X_WT, Place touched) noexcept;
  void forget(const Pose& X_WT) noexcept;
  // Index of a place within `radius` of p_T that is pressed alike, kPlaces: none.
  std::size_t find(const Vec3& p_T, const Vec3& nhat_W, double radius) noexcept;

  ImpactDetectorDesc desc_;
  double radius_;
  std::shared_ptr<const DistanceField> field_;
  std::shared_ptr<const ObjectMap> objects_;
  std::int64_t tick_ = 0;
  std::array<Place, kPlaces> places_{};
  std::size_t count_ = 0;
  std::size_t found_ = 0;  // where the last search ended: neighbours follow each other
  std::array<Impact, kMaxRegions> impacts_{};
  std::size_t impact_count_ = 0;
};

}  // namespace fulcrum
