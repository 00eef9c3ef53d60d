#include "engine/scenario/kept_levels.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "engine/assets/byte_stream.h"
#include "engine/assets/sha256.h"

namespace fulcrum::scenario {
namespace {

// Another one where levels of the same mesh become others, or their bytes.
constexpr std::string_view kLevelsFormat = "fulcrum levels 1";

std::string name_of_levels(const render::Mesh& mesh) {
  Sha256 hasher;
  hasher.update(kLevelsFormat);
  const auto add = [&hasher](const auto& values) {
    const std::size_t count = values.size();
    hasher.update(std::as_bytes(std::span(&count, 1)));
    hasher.update(std::as_bytes(std::span(values)));
  };
  add(mesh.positions);
  add(mesh.normals);
  add(mesh.colours);
  add(mesh.indices);
  return hasher.finish_hex() + ".levels";
}

std::vector<std::byte> bytes_of(const render::LevelsOfDetail& levels) {
  ByteWriter to;
  to.vector(levels.indices);
  to.value(levels.pieces.size());
  for (const render::LevelsOfDetail::Piece& piece : levels.pieces) {
    to.value(piece.bounds);
    to.vector(piece.levels);
  }
  return to.bytes();
}

// The levels of a mesh reach neither beyond their triangles nor beyond its vertices.
bool fits(const render::LevelsOfDetail& levels, const render::Mesh& mesh) {
  using Piece = render::LevelsOfDetail::Piece;
  using Level = render::LevelsOfDetail::Level;
  const auto lies_within = [&levels](const Level& level) {
    return level.count % 3 == 0 && std::size_t{level.first} + level.count <= levels.indices.size();
  };
  return levels.indices.size() >= mesh.indices.size() && !levels.pieces.empty() &&
         std::ranges::all_of(levels.pieces,
                             [&](const Piece& piece) {
                               return !piece.levels.empty() && std::ranges::all_of(piece.levels, lies_within);
                             }) &&
         std::ranges::all_of(levels.indices,
                             [&mesh](std::uint32_t vertex) { return vertex < mesh.positions.size(); });
}

std::optional<render::LevelsOfDetail> levels_from(std::span<const std::byte> bytes,
                                                  const render::Mesh& mesh) {
  ByteReader from(bytes);
  render::LevelsOfDetail levels;
  levels.indices = from.vector<std::uint32_t>();
  const auto pieces = from.value<std::size_t>();
  if (pieces > bytes.size()) return std::nullopt;
  for (std::size_t i = 0; i < pieces; ++i) {
    render::LevelsOfDetail::Piece piece;
    piece.bounds = from.value<render::Bounds>();
    piece.levels = from.vector<render::LevelsOfDetail::Level>();
    levels.pieces.push_back(std::move(piece));
  }
  if (!from.finished_well() || !fits(levels, mesh)) return std::nullopt;
  return levels;
}

}  // namespace

std::vector<std::string> add_levels_of_detail(render::VisualDesc& desc, const BakeCache& cache) {
  std::vector<std::string> notes;
  for (render::Mesh& mesh : desc.meshes) {
    if (mesh.indices.size() / 3 < render::kTrianglesWorthLevels) continue;
    if (!mesh.uv.empty()) continue;  // coarser triangles would bend what is laid onto them
    const auto is_whole = [&mesh](std::span<const std::byte> bytes) {
      return levels_from(bytes, mesh).has_value();
    };
    const Baked<std::vector<std::byte>> kept = cache.bytes(
        name_of_levels(mesh), is_whole, [&mesh] { return bytes_of(render::levels_of_detail(mesh)); });
    mesh.levels = levels_from(kept.value, mesh);
    if (!mesh.levels) continue;
    const bool is_whole_alone = mesh.levels->pieces.size() == 1 && mesh.levels->pieces[0].levels.size() == 1;
    if (is_whole_alone) mesh.levels.reset();                                  // it is all edges
    const bool is_told = std::ranges::find(notes, kept.note) != notes.end();  // of the mesh before
    if (!kept.note.empty() && !is_told) notes.push_back(kept.note);
  }
  return notes;
}

}  // namespace fulcrum::scenario
