#include "haptics/contact/regions.h"

#include <algorithm>

namespace fulcrum {
namespace {

constexpr double kLeastWeight = 1e-9;  // N, so that points which touch without force have a centre too

bool alike(const Contact& a, const Contact& b, double radius) {
  constexpr double cos_60_degrees = 0.5;
  return (a.p_W - b.p_W).squaredNorm() < radius * radius && a.nhat_W.dot(b.nhat_W) > cos_60_degrees;
}

}  // namespace

// Flood fill in the order of the contacts: the same labels for the same contacts, always. Regions past the
// capacity join the last one.
std::size_t RegionTracker::cluster(std::span<const Contact> contacts) noexcept {
  std::array<std::uint16_t, kMaxContacts> open{}, left{};
  std::size_t labels = 0, left_count = contacts.size();
  for (std::size_t i = 0; i < left_count; ++i) left[i] = static_cast<std::uint16_t>(i);
  while (left_count > 0) {
    const auto label = static_cast<std::uint16_t>(std::min(labels, kMaxRegions - 1));
    labels = std::min(labels + 1, kMaxRegions);
    std::size_t waiting = 0;
    open[waiting++] = left[0];
    label_[left[0]] = label;
    std::copy(left.begin() + 1, left.begin() + static_cast<std::ptrdiff_t>(left_count), left.begin());
    --left_count;
    while (waiting > 0) {
      const Contact& at = contacts[open[--waiting]];
      std::size_t kept = 0;
      for (std::size_t i = 0; i < left_count; ++i) {
        if (alike(at, contacts[left[i]], radius_)) {
          label_[left[i]] = label;
          open[waiting++] = left[i];
        } else {
          left[kept++] = left[i];
        }
      }
      left_count = kept;
    }
  }
  return labels;
}

std::span<const std::uint16_t> RegionTracker::find(std::span<const Contact> contacts) noexcept {
  found_ = cluster(contacts);
  return {label_.data(), contacts.size()};
}

void RegionTracker::describe(std::span<const Contact> contacts, std::span<const Vec3> forces,
                             const BodyState& tool) noexcept {
  std::copy_n(regions_.begin(), count_, before_.begin());
  const std::size_t count_before = count_;
  count_ = found_;
  std::array<double, kMaxRegions> pressure{};
  std::fill_n(regions_.begin(), count_, ContactRegion{});
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    ContactRegion& region = regions_[label_[i]];
    const double weight = forces[i].norm() + kLeastWeight;
    pressure[label_[i]] += weight;
    region.p_W += weight * contacts[i].p_W;
    region.nhat_W += weight * contacts[i].nhat_W;
    region.force_W += forces[i];
    region.depth_max = std::max(region.depth_max, contacts[i].depth);
    ++region.points;
  }
  for (std::size_t r = 0; r < count_; ++r) {
    ContactRegion& region = regions_[r];
    region.p_W /= pressure[r];
    region.nhat_W = region.nhat_W.normalized();  // a zero sum stays zero
    region.approach_speed =
        -region.nhat_W.dot(tool.V_WT.v + tool.V_WT.w.cross(Vec3(region.p_W - tool.X_WT.p)));
  }
  inherit_ids({before_.data(), count_before});
}

void RegionTracker::add_forces(std::span<const Vec3> forces) noexcept {
  for (std::size_t r = 0; r < forces.size(); ++r) regions_[r].force_W += forces[r];
}

// Each region takes the id of the nearest one of the tick before, nearest pairs first; the rest get new ids.
void RegionTracker::inherit_ids(std::span<const ContactRegion> before) noexcept {
  std::array<bool, kMaxRegions> taken{}, given{};
  for (;;) {
    double nearest = radius_ * radius_;
    std::size_t best_new = kMaxRegions, best_old = kMaxRegions;
    for (std::size_t r = 0; r < count_; ++r) {
      if (given[r]) continue;
      for (std::size_t o = 0; o < before.size(); ++o) {
        if (taken[o]) continue;
        const double apart = (regions_[r].p_W - before[o].p_W).squaredNorm();
        if (apart >= nearest || regions_[r].nhat_W.dot(before[o].nhat_W) <= 0) continue;
        nearest = apart;
        best_new = r;
        best_old = o;
      }
    }
    if (best_new == kMaxRegions) break;
    given[best_new] = taken[best_old] = true;
    regions_[best_new].id = before[best_old].id;
    regions_[best_new].age_ticks = before[best_old].age_ticks + 1;
  }
  for (std::size_t r = 0; r < count_; ++r)
    if (!given[r]) regions_[r].id = next_id_++;
}

}  // namespace fulcrum
