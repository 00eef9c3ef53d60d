#include "haptics/effects/guidance/guidance_way.h"

#include <algorithm>
#include <cmath>

#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

constexpr double kMostPieceTurn = 0.1;  // rad, of a piece

// On a leg of any waypoints.
Pose on_leg(const Pose& from, const Pose& to, double part) {
  return {slerp(from.q, to.q, part), from.p + part * (to.p - from.p)};
}

}  // namespace

GuidanceWay::GuidanceWay(const std::vector<GuidancePose>& poses, const Vec3& p_TH) : poses_(poses) {
  // Of a single pose the way is a leg from there to there.
  if (poses_.size() == 1) poses_.push_back(poses_.front());
  for (std::size_t leg = 0; leg + 1 < poses_.size(); ++leg) {
    add_leg(leg, p_TH);
    if (!poses_[leg + 1].rests) continue;
    const Piece& last = pieces_.back();
    rests_.push_back({pieces_.size() - 1, 1, last.p_WH + last.way_W, 0});
  }
}

void GuidanceWay::add_leg(std::size_t leg, const Vec3& p_TH) {
  const GuidancePose& begin = poses_[leg];
  const GuidancePose& end = poses_[leg + 1];
  const int count =
      std::max(1, static_cast<int>(std::ceil(angle_between(begin.X_WT.q, end.X_WT.q) / kMostPieceTurn)));
  Vec3 p_WH = begin.X_WT * p_TH;
  for (int i = 0; i < count; ++i) {
    Piece& piece = pieces_.emplace_back();
    piece.leg = leg;
    piece.from = static_cast<double>(i) / count;
    piece.to = static_cast<double>(i + 1) / count;
    piece.p_WH = p_WH;
    p_WH = (i + 1 == count ? end.X_WT : on_leg(begin.X_WT, end.X_WT, piece.to)) * p_TH;
    piece.way_W = p_WH - piece.p_WH;
    piece.length = piece.way_W.norm();
    piece.duration = (end.time - begin.time) / count;
    piece.time = begin.time + piece.from * (end.time - begin.time);
  }
}

double GuidanceWay::length() const {
  double sum = 0;
  for (const Piece& piece : pieces_) sum += piece.length;
  return sum;
}

GuidanceWay::Place GuidanceWay::nearest(std::size_t number, const Vec3& p_WH, double from,
                                        double to) const noexcept {
  const Piece& piece = pieces_[number];
  Place place{number, to, Vec3::Zero(), 0};
  if (piece.length > 0)
    place.part = std::clamp((p_WH - piece.p_WH).dot(piece.way_W) / piece.way_W.squaredNorm(), from, to);
  place.p_WH = piece.p_WH + place.part * piece.way_W;
  place.distance = (p_WH - place.p_WH).norm();
  return place;
}

Pose GuidanceWay::X_WT_after(const Place& place, double later) const noexcept {
  const double wanted = time(place) + later;
  std::size_t number = place.piece;
  const std::size_t end = std::min(pieces_.size(), number + kMostAhead);
  while (number + 1 < end && wanted > pieces_[number].time + pieces_[number].duration) ++number;
  const Piece& piece = pieces_[number];
  const double part = piece.duration > 0 ? std::clamp((wanted - piece.time) / piece.duration, 0.0, 1.0) : 1.0;
  return on_leg(poses_[piece.leg].X_WT, poses_[piece.leg + 1].X_WT,
                piece.from + part * (piece.to - piece.from));
}

}  // namespace fulcrum
