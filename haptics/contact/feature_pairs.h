#pragma once
// A tool's vertices, edges and faces against a scene's: which of them are near each other, how far apart, and
// along which normal. Measured on the triangles, in double precision.

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "haptics/contact/feature_lookahead.h"
#include "haptics/contact/feature_passing.h"
#include "haptics/geometry/feature_mesh.h"
#include "haptics/geometry/point_triangle.h"
#include "haptics/math/pose.h"

namespace fulcrum {

// A place where the two surfaces are nearest to each other, locally, or would be if the tool turned by
// kMostTurn: all that is around either feature lies on its own side of the plane across nhat, but for that
// angle. Edges that are parallel, and edges that do not bend outwards, are in no pair of edges: their ends
// and the faces beside them are. Where the surface goes on beyond a face's or an edge's end as a wall does
// beyond a room's corner, the pair does, too, for kDeepest.
struct FeaturePair {
  std::uint64_t key = 0;       // the same two features have the same from look to look
  Vec3 p_W = Vec3::Zero();     // (3) m, on the tool
  Vec3 nhat_W = Vec3::Zero();  // (3) unit, from the scene to the tool
  double gap = 0;              // m, along nhat; below 0 the surfaces have passed each other there

  // A name of 32 bits, which two pairs may share: then one of them has the other's guess.
  std::uint32_t number() const { return static_cast<std::uint32_t>(key ^ key >> 29); }
};

class FeaturePairs {
public:
  static constexpr std::size_t kMostPairs = 1u << 14;
  static constexpr double kMostTurn = 0.03;             // rad, a longer turn may meet what is no pair
  static constexpr std::size_t kMeasuredATick = 16384;  // candidates
  static constexpr double kDeepest = 50e-6;             // m, what has passed farther is no pair

  FeaturePairs(std::shared_ptr<const FeatureMesh> tool_T, std::shared_ptr<const FeatureMesh> scene_W);

  // Until the next tick, looks gather no more than FeatureLookahead's budget has.
  void begin_tick() noexcept {
    lookahead_.begin_tick();
    measured_ = 0;
  }
  // Whether this tick's looks have gathered, or measured, what they may: another one costs a good deal more.
  bool is_spent() const { return lookahead_.is_spent() || measured_ > kMeasuredATick; }
  // 0 to 1: how much of another step from there a look would know, if the budget were spent.
  double known_part(const Vec6& ahead) const noexcept { return lookahead_.known_part(ahead); }
  // With the tool at X_WT: the pairs nearer than `reach` m, those that come as near where the tool goes
  // `ahead` (6, m and rad in W, about T), and those that have passed each other. Of these, none that came
  // from beside: that would have been in before the tool moved here, too, and was none of the last look's, a
  // short way from here. So does what lies on the far side of a wedge thinner than kDeepest, and what is on
  // the near side tells of it. In a tick ahead() and reach() may be less than was asked for; and reach() is
  // up to `farthest` m where that costs nothing. False: there were more than fit; then pairs() has not all
  // of them, or none.
  bool look(const Pose& X_WT, const Vec6& ahead, double reach, double farthest) noexcept;
  bool look(const Pose& X_WT, const Vec6& ahead, double reach) noexcept {
    return look(X_WT, ahead, reach, reach);
  }
  bool look(const Pose& X_WT, double reach) noexcept { return look(X_WT, Vec6::Zero(), reach); }
  const Vec6& ahead() const { return ahead_; }  // (6) m and rad, of the last look
  double reach() const { return reach_; }       // m, likewise
  // The tool goes back to where it was at the look before: for the next one, the last one was not.
  void take_back() noexcept { taken_back_ = true; }
  std::span<const FeaturePair> pairs() const { return pairs_; }
  double least_gap() const { return least_gap_; }  // m, of the pairs; infinite: there are none
  bool none_near() const;
  // 0 to 1: the part of the way to X_WT, within what the last look looked along, that the tool may go until
  // some features have gone in by `depth` m, though they may be out again at the way's end. What is in
  // already may be in by a little more.
  double free_part(const Pose& X_WT, double depth) noexcept;

  std::size_t bytes() const;

private:
  // Of a vertex of the tool's, at this look.
  struct Place {
    Vec3 now_W = Vec3::Zero(), ahead_W = Vec3::Zero();  // (3) m
    std::uint64_t look = 0;
  };
  const Place& place(std::uint32_t tool_vertex) noexcept;
  // Whether the candidate's plane still separates its two features, now and ahead. tool: the vertices of the
  // tool's feature.
  bool is_apart(const FeatureCandidate& candidate, std::span<const std::uint32_t> tool) noexcept;
  // Whether a gap now, and ahead, is wider than the look reaches; or deeper than what is a pair.
  bool is_above(double gap, double ahead) const noexcept { return std::min(gap, ahead) > near_; }
  bool is_below(double gap, double ahead) const noexcept {
    return std::max(gap, ahead) < -std::max(near_, kDeepest);
  }
  void vertex_on_face(FeatureCandidate& candidate) noexcept;
  void face_on_vertex(FeatureCandidate& candidate) noexcept;
  void edge_on_edge(FeatureCandidate& candidate) noexcept;
  void add(std::uint64_t kind, std::uint32_t tool, std::uint32_t scene, const Vec3& p_W, const Vec3& nhat_W,
           double gap) noexcept;
  void begin_depths() noexcept;
  bool came_from_outside(std::uint64_t key, const Vec3& p_W, const Vec3& nhat_W, double gap) noexcept;

  std::shared_ptr<const FeatureMesh> tool_, scene_;
  Pose X_WT_, X_WT_ahead_;
  Mat3 R_WT_ = Mat3::Identity(), R_WT_ahead_ = Mat3::Identity();
  Vec6 ahead_ = Vec6::Zero();
  double reach_ = 0, near_ = 0;  // m, of the look, and what is a pair: on arcs it is a little more
  std::uint64_t looks_ = 0;      // how many there were
  std::vector<Place> places_;    // (tool's vertices)
  FeatureLookahead lookahead_;
  FeaturePassing passing_;
  std::vector<FeaturePair> pairs_;
  double least_gap_ = 0;
  bool complete_ = true;
  std::size_t measured_ = 0;  // candidates, in this tick
  // What is in by more than a little, at this look and at the last complete one before it.
  struct Deep {
    std::uint64_t key = 0;
    bool came_from_outside = true;
  };
  std::vector<Deep> deep_, deep_before_;
  Pose X_WT_before_;
  bool taken_back_ = false;
  double least_gap_before_ = 0;  // m, at most 0
};

}  // namespace fulcrum
