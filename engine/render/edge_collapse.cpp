#include "engine/render/edge_collapse.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <span>

namespace fulcrum::render {
namespace {

constexpr std::size_t kFewest = 64;      // triangles of a patch that is made coarser
constexpr double kTurned = 0.2;          // cosine: a triangle that turns by more is taken for folded over
constexpr double kLargestExtent = 0.05;  // error at which it ends, in relation to the patch's size
constexpr std::size_t kShareOfPass = 3;  // of the wanted collapses a pass does one in so many

// A vertex that is to go, and where its triangles are hung instead.
struct Collapse {
  std::uint32_t from = 0, to = 0;
  double error = 0.0;  // m^2
};

class Collapser {
public:
  explicit Collapser(Patch patch) : patch_(std::move(patch)), quadrics_(patch_.positions.size()) {
    for (const Corners& t : patch_.triangles) {
      VertexQuadric quadric;
      quadric.add_triangle({patch_.positions[t[0]], patch_.positions[t[1]], patch_.positions[t[2]]},
                           {patch_.seen[t[0]], patch_.seen[t[1]], patch_.seen[t[2]]});
      for (const std::uint32_t corner : t) quadrics_[corner].add(quadric);
    }
    find_fixed();
    glm::dvec3 low = patch_.positions.front(), high = low;
    for (const glm::dvec3& p : patch_.positions) low = glm::min(low, p), high = glm::max(high, p);
    const double largest = kLargestExtent * glm::distance(low, high);
    largest_ = largest * largest;
  }

  const std::vector<Corners>& triangles() const { return patch_.triangles; }
  double error() const { return std::sqrt(error_); }

  // False: nothing more can go.
  bool pass() {
    index_fans();
    std::vector<Collapse> wanted = wanted_collapses();
    if (wanted.empty()) return false;
    const auto last = wanted.begin() + static_cast<std::ptrdiff_t>((wanted.size() - 1) / kShareOfPass);
    const auto before = [](const Collapse& a, const Collapse& b) {
      return a.error != b.error ? a.error < b.error : a.from < b.from;
    };
    std::nth_element(wanted.begin(), last, wanted.end(), before);
    const double limit = std::min(last->error, largest_);
    std::erase_if(wanted, [limit](const Collapse& each) { return each.error > limit; });
    std::ranges::sort(wanted, before);
    std::iota(now_.begin(), now_.end(), 0U);
    touched_.assign(touched_.size(), false);
    bool any = false;
    for (const Collapse& collapse : wanted) {
      if (touched_[collapse.from] || touched_[collapse.to] || !can_go(collapse)) continue;
      now_[collapse.from] = collapse.to;
      touched_[collapse.from] = touched_[collapse.to] = true;
      quadrics_[collapse.to].add(quadrics_[collapse.from]);
      error_ = std::max(error_, collapse.error);
      any = true;
    }
    if (!any) return false;
    for (Corners& t : patch_.triangles) t = moved(t);
    std::erase_if(patch_.triangles,
                  [](const Corners& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
    return true;
  }

private:
  // Every edge of a vertex that may go is shared by two triangles that run along it in opposite ways.
  void find_fixed() {
    fixed_.assign(patch_.positions.size(), false);
    touched_.assign(patch_.positions.size(), false);
    now_.resize(patch_.positions.size());
    index_fans();
    std::vector<std::uint32_t> out, in;
    for (std::uint32_t v = 0; v < fixed_.size(); ++v) {
      out.clear(), in.clear();
      for (const std::uint32_t index : fan(v)) {
        const Corners& t = patch_.triangles[index];
        const std::size_t at = t[0] == v ? 0 : t[1] == v ? 1 : 2;
        out.push_back(t[(at + 1) % 3]), in.push_back(t[(at + 2) % 3]);
      }
      std::ranges::sort(out), std::ranges::sort(in);
      fixed_[v] = out != in || std::ranges::adjacent_find(out) != out.end();
    }
  }

  void index_fans() {
    starts_.assign(patch_.positions.size() + 1, 0);
    for (const Corners& t : patch_.triangles)
      for (const std::uint32_t corner : t) ++starts_[corner + 1];
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    fans_.resize(3 * patch_.triangles.size());
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (std::uint32_t i = 0; i < patch_.triangles.size(); ++i)
      for (const std::uint32_t corner : patch_.triangles[i]) fans_[next[corner]++] = i;
  }

  std::span<const std::uint32_t> fan(std::uint32_t vertex) const {
    return std::span(fans_).subspan(starts_[vertex], starts_[vertex + 1] - starts_[vertex]);
  }

  // Of each vertex the one that costs least.
  std::vector<Collapse> wanted_collapses() const {
    std::vector<Collapse> wanted;
    for (std::uint32_t v = 0; v < fixed_.size(); ++v) {
      if (fixed_[v]) continue;
      Collapse best{v, v, std::numeric_limits<double>::infinity()};
      for (const std::uint32_t index : fan(v)) {
        const Corners& t = patch_.triangles[index];
        // Each neighbour comes once after it, going round.
        const std::uint32_t to = t[0] == v ? t[1] : t[1] == v ? t[2] : t[0];
        const double error = quadrics_[v].error(patch_.positions[to], patch_.seen[to]);
        if (error < best.error) best = {v, to, error};
      }
      if (best.to != v) wanted.push_back(best);
    }
    return wanted;
  }

  Corners moved(const Corners& t) const { return {now_[t[0]], now_[t[1]], now_[t[2]]}; }

  // The fan stays as it is facing, and the surface one: its ends have no neighbours in common but those that
  // complete the two triangles that vanish.
  bool can_go(const Collapse& collapse) const {
    around_from_.clear(), around_to_.clear();
    for (const std::uint32_t index : fan(collapse.from)) {
      const Corners t = moved(patch_.triangles[index]);
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
      for (const std::uint32_t corner : t)
        if (corner != collapse.from) around_from_.push_back(corner);
      if (std::ranges::find(t, collapse.to) == t.end() && turns(t, collapse)) return false;
    }
    for (const std::uint32_t index : fan(collapse.to)) {
      const Corners t = moved(patch_.triangles[index]);
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
      for (const std::uint32_t corner : t)
        if (corner != collapse.to) around_to_.push_back(corner);
    }
    const auto once = [](std::vector<std::uint32_t>& all) {
      std::ranges::sort(all);
      all.erase(std::unique(all.begin(), all.end()), all.end());
    };
    once(around_from_), once(around_to_);
    common_.clear();
    std::ranges::set_intersection(around_from_, around_to_, std::back_inserter(common_));
    return common_.size() == 2;
  }

  bool turns(const Corners& t, const Collapse& collapse) const {
    std::array<glm::dvec3, 3> before{}, after{};
    for (std::size_t i = 0; i < 3; ++i) {
      before[i] = patch_.positions[t[i]];
      after[i] = patch_.positions[t[i] == collapse.from ? collapse.to : t[i]];
    }
    const glm::dvec3 was = glm::cross(before[1] - before[0], before[2] - before[0]);
    const glm::dvec3 is = glm::cross(after[1] - after[0], after[2] - after[0]);
    return glm::dot(was, is) <= kTurned * glm::length(was) * glm::length(is);
  }

  Patch patch_;
  std::vector<VertexQuadric> quadrics_;
  std::vector<bool> fixed_, touched_;  // by a collapse of this pass
  std::vector<std::uint32_t> now_;     // what each vertex has become in this pass
  std::vector<std::uint32_t> starts_, fans_;
  double error_ = 0.0, largest_ = 0.0;  // m^2
  mutable std::vector<std::uint32_t> around_from_, around_to_, common_;
};

}  // namespace

std::vector<CoarserPatch> collapse_edges(Patch patch) {
  std::size_t finer = patch.triangles.size();
  std::vector<CoarserPatch> levels;
  if (finer <= kFewest) return levels;
  Collapser collapser(std::move(patch));
  while (collapser.triangles().size() > kFewest && collapser.pass()) {
    if (2 * collapser.triangles().size() > finer) continue;
    levels.push_back({collapser.triangles(), collapser.error()});
    finer = collapser.triangles().size();
  }
  // What is left of the way to the next half.
  if (4 * collapser.triangles().size() < 3 * finer)
    levels.push_back({collapser.triangles(), collapser.error()});
  return levels;
}

}  // namespace fulcrum::render
