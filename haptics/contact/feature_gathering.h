#pragma once
// Which features of a tool and a scene could be nearest to each other anywhere on a way that the tool may go,
// and around it: candidates for a few ticks, found in the trees of both. What is left out is too far off, or
// has normals that are never opposite. It can be done in parts, so that no tick has all of it to do.

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

#include "haptics/geometry/feature_mesh.h"
#include "haptics/math/pose.h"

namespace fulcrum {

// A straight way of the tool, at an even turn, and what is around.
struct ToolWay {
  Pose X_WT;                 // where it begins
  Vec6 step = Vec6::Zero();  // (6) m and rad in W, about T: to its end
  double reach = 0;          // m, around
  double turn = 0;           // rad, around, about T

  Pose at(double part) const noexcept;  // 0 to 1
  // Where on the way a pose is, or is nearest to; and how far off. radius m: of the tool, which weighs turns.
  struct Place {
    double part = 0;
    double off = 0, turn_off = 0;  // m and rad
  };
  Place place(const Pose& X_WT, double radius) const noexcept;
};

// A feature of the tool's and one of the scene's, and a plane that separated them when they were last
// measured: its normal is `away`, and no vertex of the scene's feature has a product with `away` above
// `beyond`. The two are apart wherever all vertices of the tool's feature still have larger ones.
struct FeatureCandidate {
  std::uint32_t tool = 0, scene = 0;
  double beyond = 0;               // m
  std::array<float, 3> away{};     // (3) unit in W, from the scene to the tool; 0: they were not measured
  float radius = 0;                // m, of the tool's, from T
  float apart = 0, apart_way = 0;  // m, at the way's beginning at least, and how much more at its end

  bool is_apart(const ToolWay::Place& now, const ToolWay::Place& ahead, double reach) const noexcept {
    return std::min(apart + apart_way * now.part, apart + apart_way * ahead.part) >
           reach + std::max(now.off, ahead.off) + radius * std::max(now.turn_off, ahead.turn_off);
  }
};

class FeatureGathering {
public:
  static constexpr std::size_t kMostCandidates = 1u << 14;    // of each kind
  enum Kind { kVertexFace, kFaceVertex, kEdgeEdge, kKinds };  // the tool's feature first

  // slack rad: how far from opposite normals of a candidate may be. deepest m: what has passed the other
  // farther is none. Both meshes have to outlive it.
  FeatureGathering(const FeatureMesh& tool_T, const FeatureMesh& scene_W, double slack, double deepest);

  static constexpr std::size_t kAnyNumber = ~std::size_t{0};
  // most: candidates of a kind; more are too many, as are more visits than most_visits. Then it ends undone.
  void begin(const ToolWay& way, std::size_t most, std::size_t most_visits = kAnyNumber) noexcept;
  // Looks at so many more groups of the one's tree beside groups of the other's, four boxes each.
  void go_on(std::size_t visits) noexcept;
  void go_on() noexcept { go_on(kAnyNumber); }
  void give_up() noexcept { state_ = State::none; }
  bool is_begun() const { return state_ != State::none; }
  bool is_done() const { return state_ == State::done; }
  std::size_t visits() const { return visits_; }  // since it began

  // What is gathered: at a place that is off it, the candidates are all that can come nearer than its reach
  // less what the place is off, if the place is turned by no more than it.
  const ToolWay& way() const { return way_; }
  std::span<FeatureCandidate> candidates(Kind kind) { return candidates_[kind]; }
  std::span<const FeatureCandidate> candidates(Kind kind) const { return candidates_[kind]; }

  // A plane between the two across `away`, `allowance` m farther off the scene's feature than it could be.
  // tool, scene: the features' vertices.
  void set_apart(FeatureCandidate& candidate, std::span<const std::uint32_t> tool, const Vec3& away,
                 std::initializer_list<Vec3> scene, double allowance) noexcept;
  std::size_t bytes() const;

private:
  enum class State { none, going_on, done };
  // A tree of the tool's, and its groups in W: those that were visited.
  struct Posed {
    explicit Posed(const FeatureTree& tree);
    std::span<const FeatureTree::Group> groups;
    std::vector<std::uint32_t> gathering;  // (groups) in which gathering_ a group's bounds were made
    std::vector<Bounds4> bounds_W;         // (groups)
  };
  // Where a vertex of the tool's is at the way's two ends.
  struct Ends {
    Vec3 from_W = Vec3::Zero(), to_W = Vec3::Zero();  // (3) m
    std::uint32_t gathering = 0;
    float radius = 0;  // m, from T
  };
  // Of two groups that may meet: all lanes of each, or one alone.
  struct Meeting {
    static constexpr std::uint32_t kAll = 4;
    std::uint32_t tool = 0, scene = 0, tool_lane = kAll, scene_lane = kAll;
  };

  const FeatureTree& scene_tree(Kind kind) const;
  const Bounds4& pose(Posed& tool, std::uint32_t group) noexcept;
  const Ends& ends(std::uint32_t tool_vertex) noexcept;
  void begin_kind() noexcept;
  void descend(const Meeting& meeting) noexcept;
  void meet(const Meeting& lanes) noexcept;
  void take(std::uint32_t tool, std::uint32_t scene) noexcept;
  void take_vertex_face(std::uint32_t vertex, std::uint32_t face) noexcept;
  void take_face_vertex(std::uint32_t face, std::uint32_t vertex) noexcept;
  void take_edges(std::uint32_t of_tool, std::uint32_t of_scene) noexcept;
  void keep(const FeatureCandidate& candidate) noexcept;
  bool is_out(FeatureCandidate& candidate, std::span<const std::uint32_t> tool, const Vec3& nhat,
              std::initializer_list<Vec3> scene) noexcept;
  bool is_out(const FeatureCandidate& candidate) const noexcept;

  const FeatureMesh *tool_, *scene_;
  double slack_, deepest_;  // rad and m
  State state_ = State::none;
  ToolWay way_;
  Sweep sweep_;
  double turned_ = 0;  // rad, normals are off their middle at most
  std::size_t most_ = 0, most_visits_ = 0, visits_ = 0;
  bool too_many_ = false;
  std::uint32_t gathering_ = 0;  // how many there were
  std::size_t kind_ = 0;
  NormalCone cone_;  // its angle: of the kind, how far normals may be from opposite
  std::array<Posed, kKinds> posed_;
  std::vector<Ends> ends_;         // (tool's vertices)
  std::vector<Meeting> meetings_;  // to be looked at
  std::array<std::vector<FeatureCandidate>, kKinds> candidates_;
};

}  // namespace fulcrum
