#include "tools/content/mesh/tube.h"

#include <algorithm>
#include <cmath>

#include "haptics/math/functions.h"
#include "tools/content/mesh/loft.h"

namespace fulcrum::content {
namespace {

void add_station(std::vector<Station>* line, const Station& station) {
  // A U-bolt's two bends meet without a straight run between them.
  if (!line->empty() && (line->back().p - station.p).norm() < 1e-3 * mm) return;
  line->push_back(station);
}

void add_bend(std::vector<Station>* line, const Centreline& spec, std::size_t corner) {
  const Eigen::Vector3d& c = spec.corners[corner];
  const Eigen::Vector3d t_in = (c - spec.corners[corner - 1]).normalized();
  const Eigen::Vector3d t_out = (spec.corners[corner + 1] - c).normalized();
  const double turn = math::acos(std::clamp(t_in.dot(t_out), -1.0, 1.0));
  const double setback = spec.bend_radius * math::tan(0.5 * turn);
  const Eigen::Vector3d inward = (t_out - t_out.dot(t_in) * t_in).normalized();
  const Eigen::Vector3d start = c - setback * t_in;
  const Eigen::Vector3d end = c + setback * t_out;
  const Eigen::Vector3d centre = start + spec.bend_radius * inward;
  const auto add_at = [&](double angle, double swell) {
    add_station(line, {centre + spec.bend_radius * (math::sin(angle) * t_in - math::cos(angle) * inward),
                       math::cos(angle) * t_in + math::sin(angle) * inward, swell});
  };
  const bool welded = spec.weld_bead > 0.0;
  const double bead_half_width = 2.0 * spec.weld_bead;
  const double bead_half_angle = bead_half_width / spec.bend_radius;

  if (welded) add_station(line, {start - bead_half_width * t_in, t_in, 0.0});
  add_at(0.0, spec.weld_bead);
  if (welded) add_at(bead_half_angle, 0.0);
  const int steps = std::max(2, static_cast<int>(std::ceil(turn / spec.bend_step - 1e-9)));
  for (int i = 1; i < steps; ++i) add_at(turn * i / steps, 0.0);
  if (welded) add_at(turn - bead_half_angle, 0.0);
  add_at(turn, spec.weld_bead);
  if (welded) add_station(line, {end + bead_half_width * t_out, t_out, 0.0});
}

class SectionMaker {
public:
  SectionMaker(const Station& first, int columns)
      : columns_(columns), tangent_(first.tangent), x_(frame_along(first.p, first.tangent).linear().col(0)) {}

  // Carries the section's axes along without twist.
  void move_to(const Station& station) {
    x_ = Eigen::Quaterniond::FromTwoVectors(tangent_, station.tangent) * x_;
    tangent_ = station.tangent;
    x_ = (x_ - x_.dot(tangent_) * tangent_).normalized();
  }

  Section ring(const Eigen::Vector3d& centre, double radius) const {
    const Eigen::Vector3d y = tangent_.cross(x_);
    Section section;
    for (int k = 0; k < columns_; ++k) {
      const double angle = 2.0 * pi * k / columns_;
      section.push_back(centre + radius * (math::cos(angle) * x_ + math::sin(angle) * y));
    }
    return section;
  }

private:
  int columns_;
  Eigen::Vector3d tangent_;
  Eigen::Vector3d x_;
};

// Sections of an end, from the middle of its face to the full radius; `inward` points into the bar.
std::vector<Section> end_sections(const SectionMaker& maker, const Station& at, double radius, TubeEnd end,
                                  const Eigen::Vector3d& inward) {
  constexpr double bevel = 0.6 * mm;
  const double bore = radius - std::max(3.0 * mm, 0.16 * radius);
  switch (end) {
    case TubeEnd::flat:
      return {maker.ring(at.p, radius)};
    case TubeEnd::cut:
      return {maker.ring(at.p + 6.0 * mm * inward, bore), maker.ring(at.p, bore),
              maker.ring(at.p, radius - bevel), maker.ring(at.p + bevel * inward, radius)};
    case TubeEnd::stud:
      return {maker.ring(at.p, 0.75 * radius), maker.ring(at.p + 0.25 * radius * inward, radius)};
  }
  return {};
}

}  // namespace

std::vector<Station> stations(const Centreline& line) {
  const auto& corners = line.corners;
  const std::size_t last = corners.size() - 1;
  std::vector<Station> result;
  add_station(&result, {corners[0], (corners[1] - corners[0]).normalized(), 0.0});
  for (std::size_t i = 1; i < last; ++i) add_bend(&result, line, i);
  add_station(&result, {corners[last], (corners[last] - corners[last - 1]).normalized(), 0.0});
  return result;
}

Solid tube(std::span<const Station> line, double radius, int columns, TubeEnd start, TubeEnd end) {
  SectionMaker maker(line.front(), columns);
  std::vector<Section> sections = end_sections(maker, line.front(), radius, start, line.front().tangent);
  for (const Station& station : line.subspan(1, line.size() - 2)) {
    maker.move_to(station);
    sections.push_back(maker.ring(station.p, radius + station.swell));
  }
  maker.move_to(line.back());
  std::vector<Section> tail = end_sections(maker, line.back(), radius, end, -line.back().tangent);
  sections.insert(sections.end(), tail.rbegin(), tail.rend());
  return loft(sections);
}

}  // namespace fulcrum::content
