#pragma once
// A way that the handle is to go: straight pieces between places of H, each of which knows when the expert
// is there and how the tool is turned. Where a leg turns the tool its H goes round, and it is cut into pieces
// of at most 0.1 rad: with 0.1 m from T to H they lie within 0.13 mm of it.

#include <cstddef>
#include <vector>

#include "haptics/math/pose.h"

namespace fulcrum {

// Where the expert has the tool. Between two of these it goes straight and by the shortest rotation.
struct GuidancePose {
  double time = 0;  // s since the first, rests left out; it never goes back
  Pose X_WT;
  bool rests = false;  // the expert stays here for a while
};

class GuidanceWay {
public:
  // At least one pose. p_TH (3) m, the handle on the tool.
  GuidanceWay(const std::vector<GuidancePose>& poses, const Vec3& p_TH);

  struct Place {
    std::size_t piece = 0;
    double part = 0;           // of the piece, 0 to 1
    Vec3 p_WH = Vec3::Zero();  // (3) m
    double distance = 0;       // m, of the handle for which it was found
  };

  std::size_t pieces() const { return pieces_.size(); }
  double length() const;                                                    // m, of all of it
  double length(std::size_t piece) const { return pieces_[piece].length; }  // m
  // The place of a piece, from one part of it to another, that is nearest to a handle. Where the handle does
  // not move along a piece, that is its end: a place alone tells nobody how far it has turned.
  Place nearest(std::size_t piece, const Vec3& p_WH, double from, double to) const noexcept;

  // s, when the expert is there.
  double time(const Place& place) const noexcept {
    return pieces_[place.piece].time + place.part * pieces_[place.piece].duration;
  }
  // The expert's tool so much later (s), as it goes on evenly along each leg; at most 24 pieces on.
  Pose X_WT_after(const Place& place, double later) const noexcept;

  // Where the expert rests, but for the start.
  const std::vector<Place>& rests() const { return rests_; }

  static constexpr std::size_t kMostAhead = 24;  // pieces that a tick looks at

private:
  struct Piece {
    Vec3 p_WH = Vec3::Zero();       // (3) m, where it begins
    Vec3 way_W = Vec3::Zero();      // (3) m, to its end
    double length = 0;              // m
    double time = 0, duration = 0;  // s
    std::size_t leg = 0;            // from poses_[leg] to the next
    double from = 0, to = 0;        // of that leg
  };

  void add_leg(std::size_t leg, const Vec3& p_TH);

  std::vector<GuidancePose> poses_;
  std::vector<Piece> pieces_;  // at least one
  std::vector<Place> rests_;
};

}  // namespace fulcrum
