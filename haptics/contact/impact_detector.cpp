#include "haptics/contact/impact_detector.h"

#include <algorithm>
#include <utility>

namespace fulcrum {
namespace {

constexpr double kSpacing = 0.5;  // of a region's radius, between remembered places
constexpr double kAlike = 0.5;    // cosine of 60 degrees, as for the points of one region
constexpr double kLift = 0.25;    // of the retreat: a place this far above what touches beside it moves there

}  // namespace

ImpactDetector::ImpactDetector(const ImpactDetectorDesc& desc, double region_radius,
                               std::shared_ptr<const DistanceField> scene_field,
                               std::shared_ptr<const ObjectMap> objects)
    : desc_(desc), radius_(region_radius), field_(std::move(scene_field)), objects_(std::move(objects)) {}

std::span<const Impact> ImpactDetector::process(const Tick& tick) noexcept {
  const Touching& touching = tick.touching;
  const Pose X_TW = tick.X_WT.inverse();
  std::array<bool, kMaxRegions> known{};
  for (std::size_t i = 0; i < touching.contacts.size(); ++i) {
    bool& its = known[touching.region_of[i]];
    const Contact& contact = touching.contacts[i];
    its = its || find(X_TW * contact.p_W, contact.nhat_W, radius_) < count_;
  }
  impact_count_ = 0;
  for (std::size_t r = 0; r < touching.regions.size(); ++r)
    if (!known[r] && tick_ > 0) strike(tick, r, X_TW);
  for (const Contact& contact : touching.contacts)
    remember(tick.X_WT,
             {X_TW * contact.p_W, contact.nhat_W, contact.nhat_W.dot(contact.p_W) + contact.depth, tick_});
  forget(tick.X_WT);
  ++tick_;
  return impacts();
}

void ImpactDetector::strike(const Tick& tick, std::size_t region, const Pose& X_TW) noexcept {
  const ContactRegion& struck = tick.touching.regions[region];
  const Vec3 p_T = X_TW * struck.p_W;
  const Vec3 v_W = tick.V_WG.v + tick.V_WG.w.cross(Vec3(tick.X_WG.q * p_T));
  const double speed = -struck.nhat_W.dot(v_W);
  if (!(speed > desc_.least_speed)) return;
  impacts_[impact_count_++] = {.p_W = struck.p_W,
                               .nhat_W = struck.nhat_W,
                               .speed = speed,
                               .object = objects_ ? objects_->nearest(struck.p_W) : 0};
  remember(tick.X_WT, {p_T, struck.nhat_W, struck.nhat_W.dot(struck.p_W) + struck.depth_max, tick_});
}

void ImpactDetector::remember(const Pose& X_WT, Place touched) noexcept {
  std::size_t at = find(touched.p_T, touched.nhat_W, kSpacing * radius_);
  if (at == kPlaces) {
    const auto oldest = std::ranges::min_element(places_, std::less<>(), &Place::tick);
    at = count_ < kPlaces ? count_++ : static_cast<std::size_t>(oldest - places_.begin());
    places_[at] = touched;
    return;
  }
  // One that the tool has rolled off goes along with what touches.
  const double lift = touched.nhat_W.dot(X_WT * places_[at].p_T) - touched.surface;
  if (lift < kLift * desc_.retreat) touched.p_T = places_[at].p_T;
  places_[at] = touched;
}

void ImpactDetector::forget(const Pose& X_WT) noexcept {
  for (std::size_t i = 0; i < count_;) {
    const Place& place = places_[i];
    const Vec3 p_W = X_WT * place.p_T;
    const bool away = place.tick < tick_ && (place.nhat_W.dot(p_W) - place.surface > desc_.retreat ||
                                             field_->distance(p_W) > desc_.retreat);
    if (away)
      places_[i] = places_[--count_];
    else
      ++i;
  }
}

std::size_t ImpactDetector::find(const Vec3& p_T, const Vec3& nhat_W, double radius) noexcept {
  for (std::size_t looked = 0; looked < count_; ++looked, ++found_) {
    if (found_ >= count_) found_ = 0;
    const Place& place = places_[found_];
    if ((place.p_T - p_T).squaredNorm() < radius * radius && place.nhat_W.dot(nhat_W) > kAlike) return found_;
  }
  return kPlaces;
}

}  // namespace fulcrum
