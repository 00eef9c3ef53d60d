#include "haptics/bake/repair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "haptics/bake/holes.h"
#include "haptics/bake/patch_visibility.h"
#include "haptics/bake/patches.h"
#include "haptics/bake/redundant_patches.h"
#include "haptics/bake/sentence.h"
#include "haptics/bake/t_junctions.h"
#include "haptics/bake/weld.h"

namespace fulcrum {
namespace {

constexpr double kCrack = 1e-5;        // of the diagonal; or more,
constexpr double kExported = 0.5e-6;   // m, as programs round, and then at most
constexpr double kWidestCrack = 1e-4;  // of the diagonal
constexpr double kWidestHole = 0.25;   // of the body's diagonal
constexpr double kSheet = 0.5;         // a side that sees this share of what the other sees is not inside
constexpr std::size_t kTold = 5;       // holes and sheets each; the others together

// m: what is nearer was meant to meet.
double crack_width(double diagonal_m) {
  return std::max(kCrack * diagonal_m, std::min(kExported, kWidestCrack * diagonal_m));
}

Box3 bounds_of(const TriangleMesh& mesh, const std::vector<std::uint32_t>& triangles) {
  Box3 box;
  for (const std::uint32_t t : triangles)
    for (const std::uint32_t v : mesh.triangles[t]) box.extend(mesh.vertices[v]);
  return box;
}

double area_of(const TriangleMesh& mesh, const std::vector<std::uint32_t>& triangles) {
  double area = 0.0;
  for (const std::uint32_t t : triangles) {
    const Triangle& corner = mesh.triangles[t];
    const Vec3& a = mesh.vertices[corner[0]];
    area += 0.5 * (mesh.vertices[corner[1]] - a).cross(mesh.vertices[corner[2]] - a).norm();
  }
  return area;
}

void remove(TriangleMesh& mesh, const std::vector<bool>& gone) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (!gone[t]) mesh.triangles[kept++] = mesh.triangles[t];
  mesh.triangles.resize(kept);
}

class MeshRepair {
public:
  explicit MeshRepair(TriangleMesh mesh) { result_.mesh = std::move(mesh); }

  Result<Repaired> run() {
    close();
    if (std::optional<Error> error = orient()) return *error;
    if (std::optional<Error> error = drop_sheets()) return *error;
    if (std::optional<Error> error = fill()) return *error;
    return std::move(result_);
  }

private:
  TriangleMesh& mesh() { return result_.mesh; }
  static std::string from(const Mended& mended) {
    return (mended.count == 1 ? "at " : "the first at ") + spell(mended.place);
  }
  void tell(std::string sentence) { result_.notes.push_back(std::move(sentence)); }

  // What is there twice hides an open edge, and what has been joined or cut may be there twice.
  void close() {
    Box3 box;
    for (const Triangle& corner : mesh().triangles)
      for (const std::uint32_t v : corner) box.extend(mesh().vertices[v]);
    const double width = crack_width(box.diagonal().norm());
    Mended repeated;
    drop_repeated(repeated);
    const Mended dropped = drop_slivers(mesh(), width);
    const Mended moved = close_cracks(mesh(), width);
    drop_repeated(repeated);
    const Mended cut = cut_at_t_junctions(mesh(), width);
    drop_repeated(repeated);
    if (repeated.count > 0)
      tell(count(repeated.count, "triangle repeats another and is", "triangles repeat others and are") +
           " left out, " + from(repeated) + ".");
    if (dropped.count > 0)
      tell(count(dropped.count, "triangle without height is", "triangles without height are") +
           " left out, " + from(dropped) + ".");
    if (moved.count > 0)
      tell("Cracks narrower than " + spell_mm(width) +
           " have been closed: " + count(moved.count, "vertex", "vertices") + " moved, " + from(moved) + ".");
    if (cut.count > 0)
      tell("Edges have been cut where corners of other triangles lie on them: " +
           count(cut.count, "place", "places") + ", " + from(cut) + ".");
  }

  void drop_repeated(Mended& repeated) {
    const std::vector<bool> gone = repeated_triangles(mesh());
    for (std::size_t t = 0; t < gone.size(); ++t)
      if (gone[t]) repeated.add(mesh().vertices[mesh().triangles[t][0]]);
    remove(mesh(), gone);
  }

  // An open patch faces the side that sees more, if it was wound both ways or others meet it; else it is
  // taken at its word: a cavity with a hole in it must not become a body.
  std::optional<Error> orient() {
    const std::vector<Triangle> before = mesh().triangles;
    auto patches = cut_into_patches(mesh());
    if (!patches) return patches.error();
    patches_ = std::move(*patches);
    visibility_ = measure_visibility(mesh(), patches_);
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      const Patch& patch = patches_[i];
      if (visibility_[i].back > visibility_[i].front && (patch.turned > 0 || patch.joined)) {
        for (const std::uint32_t t : patch.triangles) turn(mesh().triangles[t]);
        std::swap(visibility_[i].front, visibility_[i].back);
      }
    }
    Mended turned;
    for (std::size_t t = 0; t < before.size(); ++t)
      if (mesh().triangles[t] != before[t]) turned.add(mesh().vertices[before[t][0]]);
    if (turned.count > 0)
      tell(count(turned.count, "triangle was wound against the rest and has",
                 "triangles were wound against the rest and have") +
           " been turned, " + from(turned) + ".");
    return std::nullopt;
  }

  std::optional<Error> drop_sheets() {
    double whole = 0.0;
    for (const Patch& patch : patches_) whole += area_of(mesh(), patch.triangles);
    std::vector<bool> gone(mesh().triangles.size());
    std::size_t told = 0;
    const auto leave_out = [&](const Patch& patch, const std::string& why) {
      for (const std::uint32_t t : patch.triangles) gone[t] = true;
      if (told++ >= kTold) return;
      const Box3 box = bounds_of(mesh(), patch.triangles);
      tell("A sheet of " + count(patch.triangles.size(), "triangle", "triangles") + " around " +
           spell(box.center()) + ", " + spell_mm(box.diagonal().norm()) + " across, " + why +
           " and is left out; if it is to be touched, give it thickness.");
    };
    const std::vector<bool> redundant = redundant_patches(mesh(), patches_, visibility_);
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      const Patch& patch = patches_[i];
      const auto [front, back] = visibility_[i];
      if (redundant[i]) {
        leave_out(patch, front + back > 0.0 ? "stands on a surface without bounding anything"
                                            : "lies inside a body");
      } else if (patch.open && std::min(front, back) >= kSheet * std::max(front, back)) {
        const Box3 box = bounds_of(mesh(), patch.triangles);
        if (area_of(mesh(), patch.triangles) > kScrap * whole) {
          return Error{"A sheet of " + count(patch.triangles.size(), "triangle", "triangles") + " around " +
                       spell(box.center()) + ", " + spell_mm(box.diagonal().norm()) +
                       " across, bounds nothing: give it thickness, or remove it."};
        }
        leave_out(patch, "bounds nothing");
      }
    }
    remove(mesh(), gone);
    if (told > kTold) tell(count(told - kTold, "more sheet is", "more sheets are") + " left out.");
    return std::nullopt;
  }

  std::optional<Error> fill() {
    std::vector<HoleFill> fills = fill_holes(mesh());
    std::stable_sort(fills.begin(), fills.end(),
                     [](const HoleFill& l, const HoleFill& r) { return l.width_m > r.width_m; });
    const std::vector<double> diagonal = body_diagonals();
    std::size_t told = 0, others = 0;
    for (const HoleFill& fill : fills) {
      const double widest = kWidestHole * diagonal[fill.rim.front()];
      if (fill.width_m > widest) {
        return Error{"A hole about " + spell_mm(fill.width_m) + " wide around " + spell(fill.place) +
                     " is more than can be filled by guess (" + spell_mm(widest) +
                     " here): close it where the model was made, or give the surface thickness."};
      }
      mesh().triangles.insert(mesh().triangles.end(), fill.triangles.begin(), fill.triangles.end());
      if (fill.width_m <= crack_width(diagonal[fill.rim.front()])) continue;
      if (told++ < kTold) {
        tell("A hole about " + spell_mm(fill.width_m) + " wide around " + spell(fill.place) +
             " has been filled: inside is a guess within " + spell_mm(reach_of(fill)) + " of it.");
      } else {
        ++others;
      }
    }
    if (others > 0) tell(count(others, "narrower hole has", "narrower holes have") + " been filled as well.");
    return std::nullopt;
  }

  // From a hole's middle to the farthest point of its rim.
  double reach_of(const HoleFill& fill) {
    double reach = 0.0;
    for (const std::uint32_t v : fill.rim) reach = std::max(reach, (mesh().vertices[v] - fill.place).norm());
    return reach;
  }

  // (vertices) of the body a vertex belongs to.
  std::vector<double> body_diagonals() {
    Sets sets(mesh().vertices.size());
    for (const Triangle& corner : mesh().triangles) {
      sets.join(corner[0], corner[1]);
      sets.join(corner[0], corner[2]);
    }
    std::vector<Box3> boxes(mesh().vertices.size());
    for (std::uint32_t v = 0; v < boxes.size(); ++v) boxes[sets.find(v)].extend(mesh().vertices[v]);
    std::vector<double> diagonals;
    for (std::uint32_t v = 0; v < boxes.size(); ++v)
      diagonals.push_back(boxes[sets.find(v)].diagonal().norm());
    return diagonals;
  }

  Repaired result_;
  std::vector<Patch> patches_;
  std::vector<PatchVisibility> visibility_;  // (patches)
};

}  // namespace

Result<Repaired> repair_mesh(TriangleMesh welded) {
  return MeshRepair(std::move(welded)).run();
}

}  // namespace fulcrum
