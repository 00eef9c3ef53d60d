#pragma once
// Contact regions and their identity from tick to tick.

#include <array>
#include <span>

#include "haptics/contact/contact_set.h"
#include "haptics/tool/rigid_body.h"

namespace fulcrum {

// What touches in a tick: each contact, and the region that it is of.
struct Touching {
  std::span<const Contact> contacts;         // at most kMaxContacts
  std::span<const std::uint16_t> region_of;  // (contacts) index into regions
  std::span<const ContactRegion> regions;
};

class RegionTracker {
public:
  // radius m: touching points nearer than this whose normals differ by less than 60 degrees are of one
  // region, and a region keeps its id while its centre in the scene moves less than this in a tick.
  explicit RegionTracker(double radius) : radius_(radius) {}

  // Which contacts are of one region: (contacts) their region's number in this tick. At most kMaxContacts.
  std::span<const std::uint16_t> find(std::span<const Contact> contacts) noexcept;
  // What the regions of the last find() are. forces: (n x 3) N, one for each contact.
  void describe(std::span<const Contact> contacts, std::span<const Vec3> forces,
                const BodyState& tool) noexcept;
  void update(std::span<const Contact> contacts, std::span<const Vec3> forces,
              const BodyState& tool) noexcept {
    find(contacts);
    describe(contacts, forces, tool);
  }

  // Adds a force on the tool to that of each region, (regions x 3) N: its friction.
  void add_forces(std::span<const Vec3> forces) noexcept;

  std::span<const ContactRegion> regions() const { return {regions_.data(), count_}; }
  // contacts: those of the last update().
  Touching touching(std::span<const Contact> contacts) const {
    return {contacts, {label_.data(), contacts.size()}, regions()};
  }

private:
  std::size_t cluster(std::span<const Contact> contacts) noexcept;
  void inherit_ids(std::span<const ContactRegion> before) noexcept;

  double radius_;
  std::uint32_t next_id_ = 1;
  std::size_t found_ = 0;  // by the last find()
  std::size_t count_ = 0;
  std::array<ContactRegion, kMaxRegions> regions_{}, before_{};
  std::array<std::uint16_t, kMaxContacts> label_{};
};

}  // namespace fulcrum
