#include "haptics/bake/overlap_depth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <utility>

#include "haptics/bake/crossings.h"

namespace fulcrum {
namespace {

constexpr double kMeets = 1e-10;  // m, within which triangles count as meeting: well above rounding

constexpr std::size_t kFewPlanes = 4;

constexpr double kClearShare = 0.5;  // of the clearance: what is looked for before a box counts as far
constexpr int kClearLooks = 1000;    // for one pose, after which its clearance is left unknown

struct Pair {
  std::uint32_t mine, theirs;  // triangles of the surface asked about, of the other solid
};

std::uint32_t component_of(const Solid& solid, std::uint32_t triangle) {
  const auto after =
      std::upper_bound(solid.components.begin(), solid.components.end(), triangle,
                       [](std::uint32_t t, const SolidComponent& c) { return t < c.first_triangle; });
  return static_cast<std::uint32_t>(after - solid.components.begin()) - 1;
}

Corners3 placed(const Corners3& corners, const Pose& X) {
  const Mat3 R = X.q.toRotationMatrix();
  return {R * corners[0] + X.p, R * corners[1] + X.p, R * corners[2] + X.p};
}

Vec3 centre_of(const Corners3& c) {
  return (c[0] + c[1] + c[2]) / 3;
}

double radius_about(const Corners3& c, const Vec3& centre) {
  return std::max({(c[0] - centre).norm(), (c[1] - centre).norm(), (c[2] - centre).norm()});
}

// Across the longest side.
std::array<Corners3, 2> halves(const Corners3& corners) {
  const auto side = [&](std::size_t i) { return (corners[(i + 1) % 3] - corners[i]).squaredNorm(); };
  std::size_t longest = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (side(i) > side(longest)) longest = i;
  const Vec3 &a = corners[longest], &b = corners[(longest + 1) % 3], &c = corners[(longest + 2) % 3];
  const Vec3 middle = (a + b) / 2;
  return {Corners3{a, middle, c}, Corners3{middle, b, c}};
}

Box3 box_of(const Corners3& c) {
  Box3 box(c[0]);
  box.extend(c[1]).extend(c[2]);
  return box;
}

Box3 placed_box(const Box3& box, const Pose& X) {
  Box3 all;
  for (int i = 0; i < 8; ++i) all.extend(X * box.corner(static_cast<Box3::CornerType>(i)));
  return all;
}

struct Plane {
  Vec3 normal;  // unit
  Vec3 origin;  // (3) m
};
Plane plane_of(const Corners3& c) {
  return {(c[1] - c[0]).cross(c[2] - c[0]).stableNormalized(), c[0]};
}

struct PlaneCut {
  double evenly = 0;  // m, how far the triangle reaches beyond the plane, on the side where it is less
  std::array<double, 3> heights{};  // m, of its corners
};
PlaneCut cut_by(const Plane& plane, const Corners3& corners) {
  PlaneCut cut;
  for (std::size_t i = 0; i < 3; ++i) cut.heights[i] = plane.normal.dot(corners[i] - plane.origin);
  const auto [low, high] = std::minmax({cut.heights[0], cut.heights[1], cut.heights[2]});
  cut.evenly = std::min(high, -low);
  return cut;
}

// One surface in one component of the other solid. All coordinates are in that solid's frame.
class Search {
public:
  Search(const Solid& surface, const Solid& solid, const TriangleDistance& distance, const Pose& X_surface,
         const OverlapDepth::Limits& limits, DeepestOverlap& found)
      : surface_(surface),
        solid_(solid),
        distance_(distance),
        X_surface_(X_surface),
        limits_(limits),
        found_(found) {}

  // pairs: of triangles that meet, theirs all of this component, sorted.
  void run(std::uint32_t component, const std::vector<Pair>& pairs) {
    component_ = component;
    hint_ = solid_.components[component].first_triangle;
    pairs_ = pairs;
    state_.assign(surface_.mesh.triangles.size(), State::unseen);
    for (const Pair& pair : pairs_) state_[pair.mine] = State::crossing;
    for (std::size_t i = 0; i < pairs_.size(); i = end_of(i)) add(pairs_[i].mine, i, end_of(i));
    for (std::size_t i = 0; i < pairs_.size(); i = end_of(i)) enter_behind(pairs_[i].mine);
    // Where a surface that crossed itself was cut, a walk over edges does not reach everywhere.
    for (const SolidComponent& mine : surface_.components)
      if (was_cut(mine)) try_all(mine);
      // A surface that crosses nothing lies behind the other one whole, or not at all.
      else if (!crosses(mine) &&
               solid_.components[component].bounds.contains(corners(mine.first_triangle)[0]))
        enter(mine.first_triangle);
    refine();
  }

private:
  enum class State : unsigned char { unseen, crossing, settled };
  struct Piece {
    Corners3 corners;
    double bound = 0;                     // m, of the depth in it
    std::uint32_t nearest = 0;            // the component's triangle nearest to its centre
    std::vector<std::uint32_t> crossing;  // those it may cross; none: it lies on one side
    bool operator<(const Piece& other) const { return bound < other.bound; }
  };

  Corners3 corners(std::uint32_t triangle) const {
    return placed(corners_of(surface_.mesh, triangle), X_surface_);
  }
  std::size_t end_of(std::size_t i) const {
    std::size_t end = i + 1;
    while (end < pairs_.size() && pairs_[end].mine == pairs_[i].mine) ++end;
    return end;
  }
  bool crosses(const SolidComponent& mine) const {
    const auto first = std::lower_bound(pairs_.begin(), pairs_.end(), mine.first_triangle,
                                        [](const Pair& pair, std::uint32_t t) { return pair.mine < t; });
    return first != pairs_.end() && first->mine < mine.first_triangle + mine.triangle_count;
  }

  bool was_cut(const SolidComponent& mine) const {
    const auto begin = surface_.neighbours.begin() + mine.first_triangle;
    return !mine.shell.triangles.empty() &&
           std::any_of(begin, begin + mine.triangle_count, [](const Triangle& across) {
             return std::find(across.begin(), across.end(), Solid::kNoNeighbour) != across.end();
           });
  }

  double depth_at(const Vec3& p, std::uint32_t& hint) {
    ++found_.distances;
    return -distance_.component_distance(component_, p, hint);
  }
  void note(double depth, const Vec3& p) {
    if (!(depth > std::max(found_.depth, limits_.above))) return;
    found_.depth = depth;
    found_.p_W = p;
  }
  double wanted() const { return std::max(limits_.above, found_.depth + limits_.tolerance); }

  // Puts the piece into the queue unless no point of it can be as deep as is wanted. piece.bound: its
  // parent's.
  void consider(Piece piece) {
    const Vec3 centre = centre_of(piece.corners);
    const double depth = depth_at(centre, piece.nearest);
    std::erase_if(piece.crossing, [&](std::uint32_t theirs) {
      const Corners3 other = corners_of(solid_.mesh, theirs);
      return cut_by(plane_of(other), piece.corners).evenly <= kMeets ||
             meeting(piece.corners, other, kMeets) == Meeting::apart;
    });
    if (depth < 0 && piece.crossing.empty()) return;  // it lies in front of the surface
    note(depth, centre);
    double to_nearest = 0;
    Vec3 farthest = centre;
    for (const Vec3& corner : piece.corners) {
      const double away = (corner - distance_.closest_on(piece.nearest, corner)).norm();
      if (away <= to_nearest) continue;
      to_nearest = away;
      farthest = corner;
    }
    piece.bound = std::min({piece.bound, depth + radius_about(piece.corners, centre), to_nearest});
    if (piece.bound > wanted()) {  // where the bound is attained it is the answer
      std::uint32_t nearest = piece.nearest;
      note(depth_at(farthest, nearest), farthest);
    }
    if (piece.bound > wanted())
      queue_.push(std::move(piece));
    else
      settle(piece.bound);
  }
  void settle(double bound) { found_.bound = std::max(found_.bound, bound); }

  void add(std::uint32_t triangle, std::size_t from, std::size_t to) {
    Piece piece{corners(triangle), std::numeric_limits<double>::infinity(), hint_, {}};
    for (std::size_t i = from; i < to; ++i) piece.crossing.push_back(pairs_[i].theirs);
    consider(std::move(piece));
  }

  bool behind(std::uint32_t triangle) { return depth_at(centre_of(corners(triangle)), hint_) > 0; }

  void try_all(const SolidComponent& mine) {
    for (std::uint32_t t = mine.first_triangle; t < mine.first_triangle + mine.triangle_count; ++t) {
      if (state_[t] != State::unseen) continue;
      state_[t] = State::settled;
      if (solid_.components[component_].bounds.intersects(box_of(corners(t))) && behind(t)) add(t, 0, 0);
    }
  }

  // From a triangle that crosses to its neighbours that do not, and on to theirs, as long as they lie behind.
  void enter_behind(std::uint32_t crossing) {
    for (const std::uint32_t next : surface_.neighbours[crossing])
      if (next != Solid::kNoNeighbour) enter(next);
  }
  void enter(std::uint32_t first) {
    std::vector<std::uint32_t> waiting{first};
    bool known_behind = false;
    while (!waiting.empty()) {
      const std::uint32_t t = waiting.back();
      waiting.pop_back();
      if (state_[t] != State::unseen) continue;
      state_[t] = State::settled;
      if (!known_behind && !behind(t)) return;
      known_behind = true;
      add(t, 0, 0);
      for (const std::uint32_t next : surface_.neighbours[t])
        if (next != Solid::kNoNeighbour) waiting.push_back(next);
    }
  }

  // Cuts the piece whose bound is the largest until none can be deeper than what was found.
  void refine() {
    while (!queue_.empty()) {
      const Piece piece = queue_.top();
      if (piece.bound <= wanted() || found_.distances >= limits_.distances) {
        settle(piece.bound);
        queue_ = {};
        return;
      }
      queue_.pop();
      if (!cut(piece)) halve(piece);
    }
  }

  // In two where a plane that matters divides it most evenly: that of a triangle it crosses, where these are
  // few, which parts what lies behind the surface from what lies in front; or a wall over an edge of the
  // nearest triangle, since over one triangle the bound is that of a plane, and exact. False: no such plane
  // divides it.
  bool cut(const Piece& piece) {
    PlaneCut best;
    const auto offer = [&](const Plane& plane) {
      const PlaneCut next = cut_by(plane, piece.corners);
      if (next.evenly > best.evenly) best = next;
    };
    if (piece.crossing.size() <= kFewPlanes)
      for (const std::uint32_t theirs : piece.crossing) offer(plane_of(corners_of(solid_.mesh, theirs)));
    if (best.evenly <= kMeets) {
      const Corners3 nearest = corners_of(solid_.mesh, piece.nearest);
      const Vec3 normal = plane_of(nearest).normal;
      for (std::size_t e = 0; e < 3; ++e)
        offer({(nearest[(e + 1) % 3] - nearest[e]).cross(normal).stableNormalized(), nearest[e]});
    }
    if (best.evenly <= kMeets) return false;
    // The corner that is alone on its side is cut off.
    const std::array<double, 3>& h = best.heights;
    std::size_t i = 0;
    while ((h[i] > 0) == (h[(i + 1) % 3] > 0) || (h[i] > 0) == (h[(i + 2) % 3] > 0)) ++i;
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const Vec3 &a = piece.corners[i], &b = piece.corners[j], &c = piece.corners[k];
    const Vec3 ab = a + h[i] / (h[i] - h[j]) * (b - a);
    const Vec3 ac = a + h[i] / (h[i] - h[k]) * (c - a);
    consider(part_of(piece, {a, ab, ac}));
    consider(part_of(piece, {ab, b, c}));
    consider(part_of(piece, {ab, c, ac}));
    return true;
  }

  void halve(const Piece& piece) {
    for (const Corners3& half : halves(piece.corners)) consider(part_of(piece, half));
  }
  static Piece part_of(const Piece& piece, const Corners3& corners) {
    return {corners, piece.bound, piece.nearest, piece.crossing};
  }

  const Solid& surface_;
  const Solid& solid_;
  const TriangleDistance& distance_;
  const Pose& X_surface_;  // of the surface, in the solid's frame
  const OverlapDepth::Limits& limits_;
  DeepestOverlap& found_;
  std::uint32_t component_ = 0;
  std::uint32_t hint_ = 0;
  std::vector<Pair> pairs_;
  std::vector<State> state_;
  std::priority_queue<Piece> queue_;
};

// Every component of the solid that the surface can reach into.
void search(const Solid& surface, const Solid& solid, const TriangleDistance& distance, const Pose& X_surface,
            std::vector<Pair> pairs, const OverlapDepth::Limits& limits, DeepestOverlap& found) {
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return a.mine != b.mine ? a.mine < b.mine : a.theirs < b.theirs;
  });
  const Box3 all = placed_box(surface.bounds(), X_surface);
  Search each(surface, solid, distance, X_surface, limits, found);
  for (std::uint32_t k = 0; k < solid.components.size(); ++k) {
    if (!solid.components[k].bounds.intersects(all)) continue;
    std::vector<Pair> own;
    for (const Pair& pair : pairs)
      if (component_of(solid, pair.theirs) == k) own.push_back(pair);
    each.run(k, own);
  }
}

}  // namespace

OverlapDepth::OverlapDepth(const Solid& scene_W, const Solid& tool_T, const DistanceField* field)
    : scene_W_(scene_W), tool_T_(tool_T), field_(field), to_scene_(scene_W), to_tool_(tool_T) {
  for (const Vec3& p_T : tool_T.mesh.vertices) reach_ = std::max(reach_, p_T.norm());
}

DeepestOverlap OverlapDepth::at(const Pose& X_WT, const Limits& limits) const {
  DeepestOverlap found;
  const Pose X_TW = X_WT.inverse();
  if (is_clear(X_WT.p, reach_, found.distances) &&
      (field_ != nullptr || to_scene_.signed_distance(X_WT.p) > 0)) {
    found.clearance = clearance(X_WT, found.distances);
    return found;
  }

  std::vector<Pair> of_tool, of_scene;
  std::vector<std::uint32_t> near;
  const auto part_is_clear = [&](const Vec3& centre_T, double radius) {
    return is_clear(X_WT * centre_T, radius, found.distances);
  };
  const auto meet = [&](std::uint32_t t) {
    const Corners3 corners_T = corners_of(tool_T_.mesh, t);
    const Vec3 centre_T = centre_of(corners_T);
    if (part_is_clear(centre_T, radius_about(corners_T, centre_T))) return;
    const Corners3 corners = placed(corners_T, X_WT);
    near.clear();
    to_scene_.tree().near_box(to_scene_.tree().whole(), box_of(corners), near);
    for (const std::uint32_t s : near) {
      if (meeting(corners, corners_of(scene_W_.mesh, s), kMeets) == Meeting::apart) continue;
      of_tool.push_back({t, s});
      of_scene.push_back({s, t});
    }
  };
  to_tool_.tree().visit_unless(to_tool_.tree().whole(), part_is_clear, meet);
  search(tool_T_, scene_W_, to_scene_, X_WT, std::move(of_tool), limits, found);
  const double depth = found.depth;
  search(scene_W_, tool_T_, to_tool_, X_TW, std::move(of_scene), limits, found);
  if (found.depth > depth) found.p_W = X_WT * found.p_W;
  found.bound = std::max(found.bound, found.depth);
  if (found.bound == 0) found.clearance = clearance(X_WT, found.distances);
  return found;
}

bool OverlapDepth::is_clear(const Vec3& p_W, double radius, std::int64_t& distances) const {
  if (field_ != nullptr) return field_->distance(p_W) - field_->local_error_m(p_W) > radius;
  const TriangleTree& tree = to_scene_.tree();
  ++distances;
  return tree.nearest(tree.whole(), p_W, radius * radius, TriangleTree::kNone).triangle ==
         TriangleTree::kNone;
}

double OverlapDepth::clearance(const Pose& X_WT, std::int64_t& distances) const {
  std::uint32_t hint = TriangleTree::kNone;
  const auto distance_at = [&](const Vec3& p_W) {
    if (field_ != nullptr) {
      const FieldSample seen = field_->sample(p_W);
      if (seen.in_band || seen.distance < 0) return seen.distance - field_->local_error_m(p_W);
    }
    const TriangleTree& tree = to_scene_.tree();
    ++distances;
    const auto nearest = tree.nearest(tree.whole(), p_W, std::numeric_limits<double>::infinity(), hint);
    hint = nearest.triangle;
    return std::sqrt(nearest.squared);
  };
  double nearest = std::numeric_limits<double>::infinity(), least = nearest;
  int looks = 0;
  const auto is_far = [&](const Vec3& centre_T, double radius) {
    const double distance = least > 0 ? distance_at(X_WT * centre_T) : 0;
    nearest = std::min(nearest, distance);
    if (nearest <= 0 || ++looks > kClearLooks) {
      least = 0;
      return true;
    }
    if (distance - radius < kClearShare * nearest) return false;
    least = std::min(least, distance - radius);
    return true;
  };
  std::vector<Corners3> pieces;
  to_tool_.tree().visit_unless(to_tool_.tree().whole(), is_far, [&](std::uint32_t triangle) {
    pieces = {corners_of(tool_T_.mesh, triangle)};
    while (!pieces.empty()) {
      const Corners3 piece = pieces.back();
      pieces.pop_back();
      const Vec3 centre = centre_of(piece);
      if (is_far(centre, radius_about(piece, centre))) continue;
      for (const Corners3& half : halves(piece)) pieces.push_back(half);
    }
  });
  return least;
}

}  // namespace fulcrum
