#include "engine/app/picture/touches.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace fulcrum::app {
namespace {

// m: a tick ends where springs still press or where a constraint has slid along what it touched.
constexpr double kMargin = 200e-6;
constexpr int kRounds = 60;           // of the descent, over all contacts
constexpr double kArm = 10;           // of the tool's radius: torque counts by the force that it takes there
constexpr double kLeastShare = 0.01;  // of the hardest: less is no touch
constexpr double kLeastForce = 1e-4;  // N, likewise

using Row = Eigen::Matrix<double, 6, 1>;

// (n) N, one for each contact. Coordinate descent: each force in turn is the best one, the others being what
// they are.
std::array<double, kMaxContacts> share(std::span<const Contact> contacts, const TickRecord& record,
                                       double arm) {
  std::array<Row, kMaxContacts> rows;
  std::array<double, kMaxContacts> force{};
  for (std::size_t i = 0; i < contacts.size(); ++i)
    rows[i] << contacts[i].nhat_W, Vec3(contacts[i].p_W - record.X_WT.p).cross(contacts[i].nhat_W) / arm;
  Row left;
  left << record.contact_F_T_W.force, record.contact_F_T_W.torque / arm;
  for (int round = 0; round < kRounds; ++round)
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const double best = std::max(0.0, force[i] + rows[i].dot(left) / rows[i].squaredNorm());
      left += (force[i] - best) * rows[i];
      force[i] = best;
    }
  return force;
}

std::optional<ContactQuery> edge_query(const PlainScene& scene) {
  if (!scene.scene_edges || !scene.tool_field) return std::nullopt;
  const Pointshell& shell = *scene.tool_shell;
  // After the shell's points, at a number that no run of either reaches across.
  return ContactQuery::of_scene(scene.scene_edges, scene.tool_field, Normals::of_cell,
                                static_cast<std::uint32_t>(std::bit_ceil(shell.size())),
                                shell.max_radius_m + shell.covering_radius_m);
}

}  // namespace

TouchFinder::TouchFinder(const PlainScene& scene)
    : arm_(kArm * std::max(tool_radius(scene), 1e-6)),
      margin_(kMargin),
      edges_(edge_query(scene)),
      regions_(scene.contact.region_radius) {
  if (scene.tool_features) {
    features_.emplace(scene.tool_features, scene.scene_features);
    margin_ = FeaturePairs::kDeepest;
    return;
  }
  query_.emplace(scene.tool_shell, scene.scene_field);
  margin_ = std::min(margin_, scene.scene_field->band_m());
  if (scene.tool_field) margin_ = std::min(margin_, scene.tool_field->band_m());
}

void TouchFinder::look(const Pose& X_WT) {
  if (!features_) {
    query_->run(X_WT, contacts_, margin_);
    if (edges_) edges_->add(X_WT, contacts_, margin_);
    return;
  }
  features_->look(X_WT, margin_);
  std::vector<FeaturePair> nearest(features_->pairs().begin(), features_->pairs().end());
  std::ranges::sort(nearest, {}, &FeaturePair::gap);
  nearest.resize(std::min(nearest.size(), kMaxContacts));
  contacts_.clear();
  for (const FeaturePair& pair : nearest)
    contacts_.add(
        {.point = pair.number(), .p_W = pair.p_W, .nhat_W = pair.nhat_W, .depth = -pair.gap, .overlap = {}});
}

std::vector<Touch> TouchFinder::find(const TickRecord& record) {
  const double pushed = record.contact_F_T_W.force.norm();
  if (!(pushed > kLeastForce) || !std::isfinite(pushed) || !record.X_WT.is_finite()) return {};
  look(record.X_WT);
  const std::span<const Contact> contacts = contacts_.contacts();
  const std::array<double, kMaxContacts> force = share(contacts, record, arm_);
  const std::span<const std::uint16_t> region_of = regions_.find(contacts);
  std::vector<Touch> all(kMaxRegions);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    Touch& touch = all[region_of[i]];
    touch.force += force[i];
    touch.p_W += force[i] * contacts[i].p_W;
    touch.nhat_W += force[i] * contacts[i].nhat_W;
  }
  for (Touch& touch : all) {
    if (touch.force > 0) touch.p_W /= touch.force;
    touch.force = touch.nhat_W.norm();
  }
  std::ranges::sort(all, std::greater{}, &Touch::force);
  const double least = std::max(kLeastForce, kLeastShare * all.front().force);
  std::erase_if(all, [&](const Touch& touch) { return touch.force < least; });
  for (Touch& touch : all) touch.nhat_W.normalize();
  return all;
}

}  // namespace fulcrum::app
