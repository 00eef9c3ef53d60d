#pragma once
// Candidates of features for each tick, gathered before they are needed: while one gathering serves, the next
// one grows by a share in each look, around where the tool is then expected to be. A tool that goes where
// nobody expected it has what it needs gathered at once.

#include <cstddef>
#include <memory>

#include "haptics/contact/feature_gathering.h"
#include "haptics/geometry/feature_mesh.h"
#include "haptics/math/pose.h"

namespace fulcrum {

class FeatureLookahead {
public:
  // slack rad, deepest m: as of FeatureGathering. Both meshes have to outlive it.
  FeatureLookahead(const FeatureMesh& tool_T, const FeatureMesh& scene_W, double slack, double deepest);

  // Makes gathering() one that has all candidates nearer than `reach` m with the tool at X_WT and after the
  // step `ahead` (6, m and rad in W, about T). False: there are more than `most` of a kind.
  bool look(const Pose& X_WT, const Vec6& ahead, double reach, std::size_t most) noexcept;
  // Some of the next gathering, once this look's candidates were measured.
  void go_on() noexcept;

  FeatureGathering& gathering() { return *gathering_; }
  const FeatureGathering& gathering() const { return *gathering_; }
  // On the gathering's way: the look's pose, and the one ahead.
  const ToolWay::Place& now() const { return now_; }
  const ToolWay::Place& then() const { return then_; }
  std::size_t bytes() const { return gathering_->bytes() + next_->bytes(); }

private:
  struct Span {
    double way = 0, turn = 0;  // m and rad
  };
  static Span span_of(const Vec6& step) { return {step.head<3>().norm(), step.tail<3>().norm()}; }
  void follow(const Pose& X_WT, const Vec6& ahead) noexcept;
  bool covers(const FeatureGathering& gathering) noexcept;
  bool gather(std::size_t most) noexcept;
  void learn() noexcept;
  bool goes_straight() const noexcept;
  Pose place_in(double looks) const noexcept;
  ToolWay way_on(const Pose& X_WT, double looks) const noexcept;
  bool is_on(const FeatureGathering& gathering, const Pose& X_WT) const noexcept;
  double looks_left() const noexcept;
  double length(const Span& span) const noexcept { return span.way + span.turn * radius_; }
  std::size_t visits_left() const noexcept;

  double radius_;  // m, of the tool
  std::unique_ptr<FeatureGathering> gathering_, next_;
  // This look: its pose, and the one ahead; the step between them; m, as far as candidates are.
  Pose X_WT_, X_WT_ahead_;
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
  // What the next one will cost, and what one at once cost the last time.
  std::size_t expected_visits_ = 512, at_once_visits_ = 512;
};

}  // namespace fulcrum
