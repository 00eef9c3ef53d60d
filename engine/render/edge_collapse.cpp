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
constexpr double kDrawnOut = 0.05;       // of what it had: a triangle's part of a texture, for its area
constexpr double kLargestExtent = 0.05;  // error at which it ends, in relation to the patch's size
constexpr std::size_t kShareOfPass = 3;  // of the wanted collapses a pass does one in so many

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

struct Move {
  std::uint32_t from = kNone, to = kNone;
};

// A vertex that is to go, and where its triangles are hung instead; at a seam, the one at the same place on
// the seam's other side goes with it.
struct Collapse {
  Move move, other_side;
  double error = 0.0;  // m^2
};

// The neighbours of a vertex along its triangles' edges that have no triangle on their other side. kNone:
// there is no such edge, or more than one.
struct Rim {
  std::uint32_t next = kNone, before = kNone;  // as its triangles run round
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
    find_slides();
    find_kinds();
    keep_seams_in_place();
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
      return a.error != b.error ? a.error < b.error : a.move.from < b.move.from;
    };
    std::nth_element(wanted.begin(), last, wanted.end(), before);
    const double limit = std::min(last->error, largest_);
    std::erase_if(wanted, [limit](const Collapse& each) { return each.error > limit; });
    std::ranges::sort(wanted, before);
    std::iota(now_.begin(), now_.end(), 0U);
    touched_.assign(touched_.size(), false);
    bool any = false;
    for (const Collapse& collapse : wanted) {
      if (!can_go(collapse)) continue;
      take(collapse.move);
      if (collapse.other_side.from != kNone) take(collapse.other_side);
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
  enum class Kind : std::uint8_t {
    fixed,
    free,  // every edge is shared by two triangles that run along it in opposite ways
    seam,  // so it is together with twin_, at the same place: the surface goes on, what is seen of it does
           // not
  };

  void find_slides() {
    if (patch_.uv.empty()) return;
    slides_.resize(patch_.positions.size());
    for (const Corners& t : patch_.triangles) {
      SlideQuadric slide;
      slide.add_triangle({patch_.positions[t[0]], patch_.positions[t[1]], patch_.positions[t[2]]},
                         {patch_.uv[t[0]], patch_.uv[t[1]], patch_.uv[t[2]]});
      for (const std::uint32_t corner : t) slides_[corner].add(slide);
    }
  }

  void find_kinds() {
    const std::size_t count = patch_.positions.size();
    kinds_.assign(count, Kind::fixed);
    twin_.assign(count, kNone);
    touched_.assign(count, false);
    now_.resize(count);
    index_fans();
    for (std::uint32_t v = 0; v < count; ++v) {
      neighbours_of(v);
      if (std::ranges::adjacent_find(out_) == out_.end() && out_ == in_) kinds_[v] = Kind::free;
    }
    std::vector<std::uint32_t> by_place(count);
    std::iota(by_place.begin(), by_place.end(), 0U);
    const auto key = [this](std::uint32_t v) {
      const glm::dvec3& p = patch_.positions[v];
      return std::array{p.x, p.y, p.z};
    };
    std::ranges::sort(by_place, [&](std::uint32_t a, std::uint32_t b) {
      return key(a) != key(b) ? key(a) < key(b) : a < b;
    });
    for (std::size_t first = 0, end = 0; first < count; first = end) {
      while (end < count && key(by_place[end]) == key(by_place[first])) ++end;
      if (end == first + 2) pair(by_place[first], by_place[first + 1]);
    }
  }

  // They are two sides of one seam if their rims run along the same edges, in opposite ways.
  void pair(std::uint32_t v, std::uint32_t w) {
    const Rim a = rim_of(v), b = rim_of(w);
    const auto meet = [this](std::uint32_t x, std::uint32_t y) {
      return x != kNone && y != kNone && patch_.positions[x] == patch_.positions[y];
    };
    if (!meet(a.next, b.before) || !meet(a.before, b.next)) return;
    // Where a sheet has two layers, its rims between patches run so, too.
    if (patch_.stays[v] || patch_.stays[w]) return;
    kinds_[v] = kinds_[w] = Kind::seam;
    twin_[v] = w;
    twin_[w] = v;
  }

  // Where triangles go on evenly beyond a seam, their planes say nothing of where it runs: upright ones along
  // it do.
  void keep_seams_in_place() {
    for (const Corners& t : patch_.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t v = t[i], next = t[(i + 1) % 3];
        if (kinds_[v] != Kind::seam || rim_of(v).next != next) continue;
        const std::array corners{patch_.positions[v], patch_.positions[next],
                                 patch_.positions[t[(i + 2) % 3]]};
        quadrics_[v].add_upright(corners);
        quadrics_[next].add_upright(corners);
      }
  }

  // out_ and in_: the ends of a vertex's edges as its triangles run round, in order.
  void neighbours_of(std::uint32_t v) const {
    out_.clear(), in_.clear();
    for (const std::uint32_t index : fan(v)) {
      const Corners& t = patch_.triangles[index];
      const std::size_t at = t[0] == v ? 0 : t[1] == v ? 1 : 2;
      out_.push_back(t[(at + 1) % 3]), in_.push_back(t[(at + 2) % 3]);
    }
    std::ranges::sort(out_), std::ranges::sort(in_);
  }

  Rim rim_of(std::uint32_t v) const {
    neighbours_of(v);
    if (std::ranges::adjacent_find(out_) != out_.end()) return {};
    const auto only = [](const std::vector<std::uint32_t>& these, const std::vector<std::uint32_t>& those) {
      std::vector<std::uint32_t> left;
      std::ranges::set_difference(these, those, std::back_inserter(left));
      return left.size() == 1 ? left.front() : kNone;
    };
    return {only(out_, in_), only(in_, out_)};
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
    for (std::uint32_t v = 0; v < kinds_.size(); ++v) {
      Collapse best{{}, {}, std::numeric_limits<double>::infinity()};
      if (kinds_[v] == Kind::free) {
        for (const std::uint32_t index : fan(v)) {
          const Corners& t = patch_.triangles[index];
          // Each neighbour comes once after it, going round.
          const std::uint32_t to = t[0] == v ? t[1] : t[1] == v ? t[2] : t[0];
          const double error = error_of({v, to});
          if (error < best.error) best = {{v, to}, {}, error};
        }
      } else if (kinds_[v] == Kind::seam && v < twin_[v]) {
        const std::uint32_t w = twin_[v];
        const Rim a = rim_of(v), b = rim_of(w);
        for (const auto& [to, other_to] : {std::pair(a.next, b.before), std::pair(a.before, b.next)}) {
          if (to == kNone || other_to == kNone || patch_.positions[to] != patch_.positions[other_to])
            continue;
          const double error = std::max(error_of({v, to}), error_of({w, other_to}));
          if (error < best.error) best = {{v, to}, {w, other_to}, error};
        }
      }
      if (best.move.from != kNone) wanted.push_back(best);
    }
    return wanted;
  }

  double error_of(const Move& move) const {
    const double error = quadrics_[move.from].error(patch_.positions[move.to], patch_.seen[move.to]);
    if (slides_.empty()) return error;
    return error + slides_[move.from].error(patch_.positions[move.to], patch_.uv[move.to]);
  }

  void take(const Move& move) {
    now_[move.from] = move.to;
    touched_[move.from] = touched_[move.to] = true;
    quadrics_[move.to].add(quadrics_[move.from]);
    if (!slides_.empty()) slides_[move.to].add(slides_[move.from]);
  }

  Corners moved(const Corners& t) const { return {now_[t[0]], now_[t[1]], now_[t[2]]}; }

  bool can_go(const Collapse& collapse) const {
    const auto may = [this](const Move& move) { return !touched_[move.from] && !touched_[move.to]; };
    if (collapse.other_side.from == kNone) return may(collapse.move) && can_go(collapse.move, 2);
    return may(collapse.move) && may(collapse.other_side) && can_go(collapse.move, 1) &&
           can_go(collapse.other_side, 1);
  }

  // The fan stays as it is facing, and the surface one: its ends have no neighbours in common but those that
  // complete the `vanishing` triangles along the edge between them, and not all of it vanishes.
  bool can_go(const Move& move, std::size_t vanishing) const {
    around_from_.clear(), around_to_.clear();
    bool is_left = false;
    for (const std::uint32_t index : fan(move.from)) {
      const Corners t = moved(patch_.triangles[index]);
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
      for (const std::uint32_t corner : t)
        if (corner != move.from) around_from_.push_back(corner);
      if (std::ranges::find(t, move.to) != t.end()) continue;
      if (turns(t, move) || folds(t, move)) return false;
      is_left = true;
    }
    if (!is_left) return false;
    for (const std::uint32_t index : fan(move.to)) {
      const Corners t = moved(patch_.triangles[index]);
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
      for (const std::uint32_t corner : t)
        if (corner != move.to) around_to_.push_back(corner);
    }
    const auto once = [](std::vector<std::uint32_t>& all) {
      std::ranges::sort(all);
      all.erase(std::unique(all.begin(), all.end()), all.end());
    };
    once(around_from_), once(around_to_);
    common_.clear();
    std::ranges::set_intersection(around_from_, around_to_, std::back_inserter(common_));
    return common_.size() == vanishing;
  }

  bool turns(const Corners& t, const Move& move) const {
    std::array<glm::dvec3, 3> before{}, after{};
    for (std::size_t i = 0; i < 3; ++i) {
      before[i] = patch_.positions[t[i]];
      after[i] = patch_.positions[t[i] == move.from ? move.to : t[i]];
    }
    const glm::dvec3 was = glm::cross(before[1] - before[0], before[2] - before[0]);
    const glm::dvec3 is = glm::cross(after[1] - after[0], after[2] - after[0]);
    return glm::dot(was, is) <= kTurned * glm::length(was) * glm::length(is);
  }

  // A texture would lie on the triangle mirrored, or be drawn out to a line.
  bool folds(const Corners& t, const Move& move) const {
    if (patch_.uv.empty()) return false;
    Corners after = t;
    std::ranges::replace(after, move.from, move.to);
    for (const std::size_t u : {0U, 2U}) {
      const double was = twice_area_in_texture(t, u), is = twice_area_in_texture(after, u);
      const double kept = was * is * twice_area(t);
      if (was != 0.0 && kept <= kDrawnOut * was * was * twice_area(after)) return true;
    }
    return false;
  }

  double twice_area(const Corners& t) const {
    const glm::dvec3& a = patch_.positions[t[0]];
    return glm::length(glm::cross(patch_.positions[t[1]] - a, patch_.positions[t[2]] - a));
  }

  // Negative: mirrored. u: where the set of coordinates begins.
  double twice_area_in_texture(const Corners& t, std::size_t u) const {
    const UvAt &a = patch_.uv[t[0]], &b = patch_.uv[t[1]], &c = patch_.uv[t[2]];
    return (b[u] - a[u]) * (c[u + 1] - a[u + 1]) - (b[u + 1] - a[u + 1]) * (c[u] - a[u]);
  }

  Patch patch_;
  std::vector<VertexQuadric> quadrics_;
  std::vector<SlideQuadric> slides_;  // of each vertex; none: nothing is laid on
  std::vector<Kind> kinds_;
  std::vector<std::uint32_t> twin_;  // of those at a seam
  std::vector<bool> touched_;        // by a collapse of this pass
  std::vector<std::uint32_t> now_;   // what each vertex has become in this pass
  std::vector<std::uint32_t> starts_, fans_;
  double error_ = 0.0, largest_ = 0.0;  // m^2
  mutable std::vector<std::uint32_t> around_from_, around_to_, common_, out_, in_;
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
