#include "engine/headset/touched_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "haptics/math/number_text.h"

namespace fulcrum::headset {
namespace {

// Digits alone, however far apart a space and a device say that two places are.
std::string in_mm(double m) {
  return number_text(std::round(1e4 * m) / 10, 9);
}

// Whether all stayed as near to their mean as a touch has to, and the mean.
struct Held {
  PointPair mean;
  double farthest_D = 0, farthest_L = 0;  // m
};
Held held(const std::vector<PointPair>& seen) {
  Held held;
  for (const PointPair& pair : seen) {
    held.mean.p_D += pair.p_D / static_cast<double>(seen.size());
    held.mean.p_L += pair.p_L / static_cast<double>(seen.size());
  }
  for (const PointPair& pair : seen) {
    held.farthest_D = std::max(held.farthest_D, (pair.p_D - held.mean.p_D).norm());
    held.farthest_L = std::max(held.farthest_L, (pair.p_L - held.mean.p_L).norm());
  }
  return held;
}

}  // namespace

void TouchedPoints::note(const TouchMoment& moment) {
  if (taken_) return;
  bool takes = false;
  for (std::size_t i = 0; i < moment.hands.size(); ++i) {
    const bool stops = moment.hands[i].stops;
    takes = takes || (stops && !pressed_[i]);
    pressed_[i] = stops || !moment.hands[i].is_known;  // what went on as it woke has to end first
  }
  begin(moment);
  if (touch_)
    hold(moment);
  else if (takes)
    take();
}

void TouchedPoints::begin(const TouchMoment& moment) {
  for (std::size_t i = 0; i < moment.hands.size(); ++i) {
    const bool squeezes = moment.hands[i].holds;
    const bool began = squeezes && !squeezed_[i];
    squeezed_[i] = squeezes || !moment.hands[i].is_known;
    if (!began || touch_) continue;
    if (points_.size() == kMost)
      said_ = "There are " + std::to_string(kMost) + " points, and no more are taken.";
    else
      touch_ = Touch{i, moment.time, {}};
  }
}

void TouchedPoints::hold(const TouchMoment& moment) {
  const std::optional<Vec3>& p_LC = moment.hands[touch_->hand].tip_L;
  if (!p_LC || !moment.p_DH) {
    said_ = p_LC ? "The device does not say where its handle is: look at its power and its cable."
                 : "The headset did not see the controller: hold it where it is in sight, and squeeze again.";
    touch_.reset();
    return;
  }
  touch_->seen.push_back({*moment.p_DH, *p_LC});
  if (moment.time - touch_->since < kHeldFor) return;
  const Touch touch = *std::exchange(touch_, std::nullopt);
  add(touch);
}

void TouchedPoints::add(const Touch& touch) {
  const Held point = held(touch.seen);
  if (const double farthest = std::max(point.farthest_D, point.farthest_L); farthest > kStill) {
    said_ = point.farthest_D > point.farthest_L ? "The handle moved by " : "The controller moved by ";
    said_ += in_mm(farthest) + " mm meanwhile: hold both still, and squeeze again.";
    return;
  }
  std::vector<PointPair> points = points_;
  points.push_back(point.mean);
  for (const PointPair& before : points_)
    if (const double apart = (before.p_D - point.mean.p_D).norm(); apart < kNearestPoints) {
      said_ = "That is " + in_mm(apart) + " mm from another point: touch a place that is " +
              in_mm(kNearestPoints) + " mm from each at least.";
      return;
    }
  if (points.size() >= kFewestPoints) {
    Result<RigidFit> fit = fit_rigid(points);
    if (!fit) {
      said_ = fit.error().sentence;
      return;
    }
    fit_ = std::move(*fit);
  }
  points_ = std::move(points);
  said_.clear();
}

void TouchedPoints::take() {
  if (!fit_) {
    said_ = "Three points are needed at least: go on.";
  } else if (fit_->rms > limit_) {
    forget("The residual is " + in_mm(fit_->rms) + " mm, and at most " + in_mm(limit_) +
           " mm is kept: touch each place with both tips at once, anew.");
  } else {
    taken_ = true;
    said_.clear();
  }
}

void TouchedPoints::look_away() {
  touch_.reset();
  squeezed_.fill(true);
  pressed_.fill(true);
}

void TouchedPoints::forget(std::string why) {
  points_.clear();
  fit_.reset();
  touch_.reset();
  said_ = std::move(why);
}

std::string TouchedPoints::text() const {
  std::string text =
      said_.empty() ? "The force is off until the device is laid onto the headset's space.\n" : said_ + "\n";
  if (touch_) return text + "Hold both still.";
  if (!fit_) {
    text +=
        "Point " + std::to_string(points_.size() + 1) + " of 3: hold the controller's tip at the handle's ";
    return text + "point, and squeeze. Choose places far apart, not in a line.";
  }
  text += std::to_string(points_.size()) + " points, residual " + in_mm(fit_->rms) + " mm RMS (";
  for (std::size_t i = 0; i < fit_->residuals.size(); ++i)
    text += (i == 0 ? "" : ", ") + in_mm(fit_->residuals[i]);
  text += fit_->rms > limit_
              ? " mm), more than the " + in_mm(limit_) + " mm that are kept.\nB, Y or menu begins anew"
              : std::string(" mm).\nB, Y or menu keeps it");
  return text + "; a squeeze at another place adds a point.";
}

}  // namespace fulcrum::headset
