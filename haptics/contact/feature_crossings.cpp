#include "haptics/contact/feature_crossings.h"

#include <algorithm>
#include <array>

#include "haptics/geometry/bounds-inl.h"

namespace fulcrum {
namespace {

constexpr double kResting = 1e-8;  // m, what is in by less may be so by rounding

// Whether the segment goes through the triangle, by more than kResting on either side and within its rim:
// what rests on it may be in by rounding.
bool pierces(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& nhat) {
  const double from = nhat.dot(p - a), to = nhat.dot(q - a);
  if (!(std::min(from, to) < -kResting && std::max(from, to) > kResting)) return false;
  const Vec3 x = p + (q - p) * (from / (from - to));
  const auto is_within = [&](const Vec3& of, const Vec3& next) {
    const Vec3 along = next - of;
    return nhat.dot(along.cross(x - of)) > kResting * along.norm();
  };
  return is_within(a, b) && is_within(b, c) && is_within(c, a);
}

}  // namespace

FeatureCrossings::FeatureCrossings(std::shared_ptr<const FeatureMesh> tool_T,
                                   std::shared_ptr<const FeatureMesh> scene_W)
    : tool_(std::move(tool_T)),
      scene_(std::move(scene_W)),
      look_of_(tool_->face_tree().groups().size()),
      bounds_W_(tool_->face_tree().groups().size()) {}

bool FeatureCrossings::crosses(const Pose& X_WT) noexcept {
  put(X_WT);
  for (unsigned part = 0; part < kParts; ++part)
    if (crosses(part)) return true;
  return false;
}

bool FeatureCrossings::crosses(const Pose& X_WT, unsigned part) noexcept {
  put(X_WT);
  return crosses(part);
}

void FeatureCrossings::put(const Pose& X_WT) noexcept {
  ++looks_;
  X_WT_ = X_WT;
  R_WT_ = X_WT.q.toRotationMatrix();
}

bool FeatureCrossings::crosses(unsigned part) noexcept {
  const std::span<const FeatureTree::Group> tool = tool_->face_tree().groups();
  if (tool.empty() || scene_->face_tree().groups().empty()) return false;
  // Three levels down the tool's tree: to the lane that the part's digits say. Where a branch is shorter, the
  // rest of its digits are 0.
  Lane of_tool{0, part / 16 % 4};
  pose(0);
  for (const unsigned digit : {part / 4 % 4, part % 4}) {
    const std::uint32_t child = tool[of_tool.group].children[of_tool.lane];
    if (child == FeatureTree::kNone) return false;
    if ((child & FeatureTree::kFeature) == 0) {
      of_tool = {child, digit};
      pose(child);
    } else if (digit != 0) {
      return false;
    }
  }
  if (tool[of_tool.group].children[of_tool.lane] == FeatureTree::kNone) return false;
  const Bounds tool_W = bounds_W_[of_tool.group][of_tool.lane];
  for (unsigned near = scene_->face_tree().groups()[0].bounds.overlapping(tool_W); near != 0;
       near &= near - 1)
    if (crosses(of_tool, {0, lowest_bit(near)})) return true;
  return false;
}

// Of two lanes that overlap.
bool FeatureCrossings::crosses(Lane of_tool, Lane of_scene) noexcept {
  const std::span<const FeatureTree::Group> tool = tool_->face_tree().groups(),
                                            scene = scene_->face_tree().groups();
  const std::uint32_t tool_child = tool[of_tool.group].children[of_tool.lane],
                      scene_child = scene[of_scene.group].children[of_scene.lane];
  const bool tool_ends = (tool_child & FeatureTree::kFeature) != 0,
             scene_ends = (scene_child & FeatureTree::kFeature) != 0;
  if (tool_ends && scene_ends)
    return cross(tool_child ^ FeatureTree::kFeature, scene_child ^ FeatureTree::kFeature);
  const Bounds tool_W = bounds_W_[of_tool.group][of_tool.lane],
               scene_W = scene[of_scene.group].bounds[of_scene.lane];
  const bool splits_scene = tool_ends || (!scene_ends && scene_W.size() > tool_W.size());
  unsigned near =
      splits_scene ? scene[scene_child].bounds.overlapping(tool_W) : pose(tool_child).overlapping(scene_W);
  for (; near != 0; near &= near - 1) {
    const unsigned lane = lowest_bit(near);
    if (splits_scene ? crosses(of_tool, {scene_child, lane}) : crosses({tool_child, lane}, of_scene))
      return true;
  }
  return false;
}

// An edge of one of the faces through the other.
bool FeatureCrossings::cross(std::uint32_t tool_face, std::uint32_t scene_face) const noexcept {
  const FeatureMesh::Face &of_tool = tool_->faces()[tool_face], &of_scene = scene_->faces()[scene_face];
  const auto scene = [&](unsigned i) -> const Vec3& { return scene_->vertices()[of_scene.corners[i % 3]]; };
  const auto in_W = [&](std::uint32_t vertex) -> Vec3 { return R_WT_ * tool_->vertices()[vertex] + X_WT_.p; };
  const std::array tool{in_W(of_tool.corners[0]), in_W(of_tool.corners[1]), in_W(of_tool.corners[2])};
  const Vec3 nhat = R_WT_ * of_tool.nhat;
  // All of one on one side of the other's plane.
  const auto sides = [](double a, double b, double c) {
    return std::min({a, b, c}) > 0 || std::max({a, b, c}) < 0;
  };
  const auto over_scene = [&](const Vec3& p) { return of_scene.nhat.dot(p - scene(0)); };
  const auto over_tool = [&](const Vec3& p) { return nhat.dot(p - tool[0]); };
  if (sides(over_scene(tool[0]), over_scene(tool[1]), over_scene(tool[2])) ||
      sides(over_tool(scene(0)), over_tool(scene(1)), over_tool(scene(2))))
    return false;
  for (unsigned e = 0; e < 3; ++e) {
    if (!tool_->edges()[of_tool.edges[e]].flat &&
        pierces(tool[e], tool[(e + 1) % 3], scene(0), scene(1), scene(2), of_scene.nhat))
      return true;
    if (!scene_->edges()[of_scene.edges[e]].flat &&
        pierces(scene(e), scene(e + 1), tool[0], tool[1], tool[2], nhat))
      return true;
  }
  return false;
}

const Bounds4& FeatureCrossings::pose(std::uint32_t group) noexcept {
  if (look_of_[group] != looks_) {
    look_of_[group] = looks_;
    const Sweep still{.R_from = R_WT_,
                      .R_middle = R_WT_,
                      .R_to = R_WT_,
                      .p_from = X_WT_.p,
                      .p_to = X_WT_.p,
                      .reach = 0,
                      .turn = 0,
                      .slack = NormalCone(Vec3::UnitX())};
    bounds_W_[group] = tool_->face_tree().groups()[group].bounds.swept(still);
  }
  return bounds_W_[group];
}

std::size_t FeatureCrossings::bytes() const {
  return bounds_W_.size() * (sizeof(Bounds4) + sizeof(std::uint64_t));
}

}  // namespace fulcrum
