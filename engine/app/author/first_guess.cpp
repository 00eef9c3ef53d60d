#include "engine/app/author/first_guess.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "haptics/bake/mass_properties.h"
#include "haptics/bake/overlap_depth.h"
#include "haptics/bake/triangle_distance.h"
#include "haptics/math/functions.h"

namespace fulcrum::app {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kClear = 1e-4;                       // m, of overlap that a response pushes out
constexpr double kLightest = 0.005, kHeaviest = 0.3;  // kg, of what is held between fingers
constexpr double kOfWorkspace = 0.7;                  // what the guessed way takes of it

struct End {
  Vec3 point = Vec3::Zero();  // (3) m, the middle of what is outermost there
  double width = 0;           // m, the largest distance from the axis within a tenth of the length
};

// What the tool has at its end in direction d from c.
End end_of(const TriangleMesh& mesh, const Vec3& c, const Vec3& d) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vec3& p : mesh.vertices) {
    low = std::min(low, d.dot(p - c));
    high = std::max(high, d.dot(p - c));
  }
  End end;
  int outermost = 0;
  for (const Vec3& p : mesh.vertices) {
    const double along = d.dot(p - c);
    if (along > high - 0.1 * (high - low)) end.width = std::max(end.width, (p - c - along * d).norm());
    if (along < high - 1e-4 * (high - low)) continue;
    end.point += p;
    ++outermost;
  }
  end.point /= outermost;
  return end;
}

// The axis about which the tool is slimmest; along the largest of M's axes where it is as wide as long.
Vec3 long_axis(const Solid& tool_M) {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(mass_properties(tool_M).inertia);
  Vec3 axis = solver.eigenvectors().col(0);
  int largest = 0;
  tool_M.bounds().sizes().maxCoeff(&largest);
  if (solver.eigenvalues()[0] > 0.8 * solver.eigenvalues()[1]) axis = Vec3::Unit(largest);
  axis.cwiseAbs().maxCoeff(&largest);
  return axis[largest] < 0 ? Vec3(-axis) : axis;
}

// The scene's surface as it is met from above, nearest to the middle.
Vec3 place_from_above(const TriangleDistance& scene, const Box3& box) {
  const Vec3 middle = box.center(), half = 0.5 * box.sizes();
  const double above = box.max().y() + 0.1 * box.diagonal().norm();
  for (int ring = 0; ring <= 10; ++ring) {
    for (int step = 0; step < std::max(1, 8 * ring); ++step) {
      const double angle = 2 * std::numbers::pi * step / std::max(1, 8 * ring);
      const double x = middle.x() + 0.09 * ring * half.x() * math::cos(angle);
      const double z = middle.z() + 0.09 * ring * half.z() * math::sin(angle);
      const Vec3 from(x, above, z), to(x, box.min().y() - half.y() - 1e-3, z);
      if (const auto hit = scene.first_crossing(from, to)) return from + hit->fraction * (to - from);
    }
  }
  return box.center();
}

class Guesser {
public:
  Guesser(const Solid& scene_W, const Solid& tool_M, const DeviceDesc& device)
      : scene_(scene_W), tool_(tool_M), device_(device), overlap_(scene_W, tool_M, nullptr) {}

  FirstGuess take() {
    hold();
    guess_.place = place_from_above(TriangleDistance(scene_), scene_.bounds());
    guess_.radius =
        std::clamp(0.03 * scene_.bounds().diagonal().norm(), 0.002, std::max(0.002, 0.1 * guess_.length));
    lean();
    lay_workspace();
    look();
    return guess_;
  }

private:
  void hold() {
    const MassProperties mass = mass_properties(tool_);
    const Vec3 axis = long_axis(tool_);
    const End low = end_of(tool_.mesh, mass.centre, -axis), high = end_of(tool_.mesh, mass.centre, axis);
    const bool high_is_slimmer = high.width < 0.95 * low.width;
    guess_.axis = high_is_slimmer ? axis : Vec3(-axis);
    guess_.touch_point = high_is_slimmer ? high.point : low.point;
    guess_.length = axis.dot(high.point - low.point);
    // A third of the length from the other end.
    guess_.X_HM.p = -(guess_.touch_point - guess_.axis * (2.0 / 3) * guess_.length);
    const double steel = guess_.density * mass.volume_m3;
    if (steel < kLightest || steel > kHeaviest) guess_.density = 0;
  }

  Pose at(const Vec3& place, const Quat& q) const { return {q, place - q * guess_.touch_point}; }

  // From the place back along the tool: where its touch point begins.
  double way() const { return std::clamp(0.5 * guess_.length, 0.02, 0.2); }

  // With the touch point so far back from the place, along the tool.
  bool is_clear(const Quat& q, double back) const {
    const Pose X_WM = at(guess_.place - back * (q * guess_.axis), q);
    return overlap_.at(X_WM, {.above = kClear, .tolerance = kClear, .distances = 20'000}).depth <= kClear;
  }

  // m, how far before the place the tool comes to rest, where its end is too wide for it; absent: the way
  // there is not free.
  std::optional<double> rest(const Quat& q) const {
    double clear = way(), touching = 0;
    for (const double part : {0.5, 0.7, 0.85, 1.0})
      if (!is_clear(q, part * way())) return std::nullopt;
    if (is_clear(q, 0)) return 0;
    while (clear - touching > kClear) {
      const double middle = 0.5 * (clear + touching);
      (is_clear(q, middle) ? clear : touching) = middle;
    }
    return clear;
  }

  void lean() {
    const auto leaning = [&](double angle, double about) {
      const Vec3 down(-math::sin(angle) * math::sin(about), -math::cos(angle),
                      -math::sin(angle) * math::cos(about));
      return Quat::FromTwoVectors(guess_.axis, down);
    };
    Quat q = leaning(0, 0);
    double least = std::numeric_limits<double>::infinity();
    for (const double angle : {35 * kDegree, 20 * kDegree, 0.0}) {
      for (const double about : {0.0, 45 * kDegree, -45 * kDegree, 90 * kDegree, -90 * kDegree}) {
        const std::optional<double> back = rest(leaning(angle, about));
        if (!back || *back >= least - 0.5 * guess_.radius) continue;
        least = *back;
        q = leaning(angle, about);
      }
    }
    guess_.is_clear = std::isfinite(least);
    if (guess_.is_clear) guess_.place -= least * (q * guess_.axis);
    guess_.X_WM_touch = at(guess_.place, q);
    guess_.X_WM_start = at(guess_.place - way() * (q * guess_.axis), q);
  }

  Vec3 handle(const Pose& X_WM) const { return (X_WM * guess_.X_HM.inverse()).p; }

  void lay_workspace() {
    Box3 ways;
    ways.extend(handle(guess_.X_WM_start));
    ways.extend(handle(guess_.X_WM_touch));
    guess_.base = ways.center();
    // Of the scene so much as a hand goes over.
    const Vec3 half = 0.5 * scene_.bounds().sizes().cwiseMin(0.6) + 0.5 * ways.sizes();
    const double scale = (half.cwiseQuotient(kOfWorkspace * device_.workspace)).maxCoeff();
    const double rounded = std::round(4 * std::clamp(scale, 0.5, 10.0)) / 4;
    guess_.position_scale = rounded;
    guess_.force_scale = std::round(100 * std::min(1.0, 1 / rounded)) / 100;
  }

  void look() {
    Box3 seen = scene_.bounds();
    for (const Vec3& p : tool_.mesh.vertices) seen.extend(guess_.X_WM_start * p);
    guess_.look_at = seen.center();
    guess_.look_from = std::max(1e-3, 1.25 * seen.diagonal().norm());
  }

  const Solid& scene_;
  const Solid& tool_;
  const DeviceDesc& device_;
  OverlapDepth overlap_;
  FirstGuess guess_;
};

}  // namespace

FirstGuess guess_scenario(const Solid& scene_W, const Solid& tool_M, const DeviceDesc& device) {
  return Guesser(scene_W, tool_M, device).take();
}

}  // namespace fulcrum::app
