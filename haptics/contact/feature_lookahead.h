#pragma once
// Candidates of features for each tick, gathered before they are needed: while one gathering serves, the next
// one grows by a share in each look, around where the tool is then expected to be. A tick gathers no more
// than its budget: a tool that goes faster than that, or where nobody expected it, is told how far it may go
// by what is known so far.

#include <algorithm>
#include <cstddef>
#include <memory>

#include "haptics/contact/feature_gathering.h"
#include "haptics/geometry/feature_mesh.h"
#include "haptics/math/pose.h"

namespace fulcrum {

class FeatureLookahead {
public:
  // Of four boxes beside four: 0.1 to 0.2 us each.
  static constexpr std::size_t kVisitsATick = 4096;

  // slack rad, deepest m: as of FeatureGathering. Both meshes have to outlive it.
  FeatureLookahead(const FeatureMesh& tool_T, const FeatureMesh& scene_W, double slack, double deepest);

  // From here on, until the next tick, kVisitsATick may be gathered. Before the first tick as many as it
  // takes.
  void begin_tick() noexcept {
    in_tick_ = true;
    budget_ = kVisitsATick;
  }
  bool is_spent() const { return budget_ == 0; }

  // What a look is known to have all candidates for: that part of the step ahead, 0 to 1, and `reach` m
  // around it. Wherever the tool goes in there, the next look has all those that are in.
  struct Known {
    double part = 0;
    double reach = -1;  // below 0: nothing is known
  };
  // With the tool at X_WT, and on the step `ahead` (6, m and rad in W, about T), within `reach` m: as much of
  // it as the budget allows, and what is in at X_WT whatever it costs; what is around up to `farthest` m if
  // it is known. Nothing is known if that is more candidates than there is room for.
  Known look(const Pose& X_WT, const Vec6& ahead, double reach, double farthest) noexcept;
  // 0 to 1: how much of another step from there a look would know, if it gathered nothing.
  double known_part(const Vec6& ahead) const noexcept;
  // Some of the next gathering, once this look's candidates were measured.
  void go_on() noexcept;

  FeatureGathering& gathering() { return *gathering_; }
  const FeatureGathering& gathering() const { return *gathering_; }
  // On the gathering's way: the look's pose, and the end of the part ahead that is known.
  const ToolWay::Place& now() const { return now_; }
  const ToolWay::Place& then() const { return then_; }
  std::size_t bytes() const { return gathering_->bytes() + next_->bytes(); }

private:
  struct Span {
    double way = 0, turn = 0;  // m and rad
  };
  static Span span_of(const Vec6& step) { return {step.head<3>().norm(), step.tail<3>().norm()}; }
  double product(const Vec6& a, const Vec6& b) const noexcept;
  void follow(const Pose& X_WT, const Vec6& ahead) noexcept;
  double spare(const FeatureGathering& gathering, const Pose& X_WT) const noexcept;
  Known known(const FeatureGathering& gathering) const noexcept { return known(gathering, ahead_, reach_); }
  Known known(const FeatureGathering& gathering, const Vec6& ahead, double reach) const noexcept;
  bool is_all(const Known& known) const noexcept { return known.part >= 1 && known.reach >= reach_; }
  double length(const Known& known) const noexcept;
  void find_more() noexcept;
  void take_next() noexcept;
  void grow(std::size_t visits) noexcept;
  bool goes_straight() const noexcept;
  bool foresees() const noexcept;
  Pose place_in(double looks) const noexcept;
  ToolWay way_here(double scale) const noexcept;
  double turn_of(double around) const noexcept;
  ToolWay way_on(const Pose& X_WT, double looks) const noexcept;
  double looks_left() const noexcept;
  double length(const Span& span) const noexcept { return span.way + span.turn * radius_; }
  std::size_t visits_left() const noexcept;

  double radius_, deepest_;  // m, of the tool, and what is in
  std::unique_ptr<FeatureGathering> gathering_, next_;
  bool in_tick_ = false;                               // since the first tick began
  std::size_t budget_ = FeatureGathering::kAnyNumber;  // visits, left in this tick
  // This look: its pose, and the step ahead; m, as far as candidates are.
  Pose X_WT_;
  Vec6 ahead_ = Vec6::Zero();
  double reach_ = 0;
  ToolWay::Place now_, then_;
  bool is_first_ = true;
  // How the tool moves, from look to look.
  Vec6 going_ = Vec6::Zero();         // (6) m and rad, on average
  Span swerving_;                     // off that, lately
  double pace_ = 0;                   // m, at most, lately
  double served_ = 0, interval_ = 1;  // looks, of the gathering, and of those before on average
  double room_;                       // m, around a way, at least
  double scale_ = 1;                  // 0 to 1, of how far ahead the next one looks
  double needed_scale_ = 1;           // likewise, where it is needed at once
  bool is_needed_ = false;            // the next one was begun for this look
  std::size_t expected_visits_ = 256, needed_visits_ = 256;  // that such ones cost lately
};

}  // namespace fulcrum
