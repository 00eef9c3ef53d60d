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
constexpr std::string_view kLevelsFormat = "fulcrum levels 3";
constexpr std::string_view kUvFormat = "uv 1";  // of a mesh of which any are read

// A mesh of fewer triangles shares a file with the others of its scene: a plant has hundreds of bolts.
constexpr std::size_t kTrianglesWorthAFile = 4096;

struct MeshInUse {
  render::Mesh* mesh = nullptr;
  render::UvSets read{};  // by the materials that it is shown with
};
using Meshes = std::vector<MeshInUse>;
using Levels = std::vector<render::LevelsOfDetail>;  // of each of them

std::string name_of_levels(const Meshes& meshes) {
  Sha256 hasher;
  hasher.update(kLevelsFormat);
  const auto add = [&hasher](const auto& values) {
    const std::size_t count = values.size();
    hasher.update(std::as_bytes(std::span(&count, 1)));
    hasher.update(std::as_bytes(std::span(values)));
  };
  for (const auto& [mesh, read] : meshes) {
    add(mesh->positions);
    add(mesh->normals);
    add(mesh->colours);
    add(mesh->indices);
    if (!read[0] && !read[1]) continue;
    hasher.update(kUvFormat);
    add(read);
    add(mesh->uv);
  }
  return hasher.finish_hex() + ".levels";
}

std::vector<std::byte> make_bytes(const Meshes& meshes) {
  ByteWriter to;
  for (const auto& [mesh, read] : meshes) {
    const render::LevelsOfDetail levels = render::levels_of_detail(*mesh, read);
    to.vector(levels.indices);
    to.value(levels.pieces.size());
    for (const render::LevelsOfDetail::Piece& piece : levels.pieces) {
      to.value(piece.bounds);
      to.vector(piece.levels);
    }
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

std::optional<Levels> levels_from(std::span<const std::byte> bytes, const Meshes& meshes) {
  ByteReader from(bytes);
  Levels all;
  for (const MeshInUse& each : meshes) {
    render::LevelsOfDetail& levels = all.emplace_back();
    levels.indices = from.vector<std::uint32_t>();
    const auto pieces = from.value<std::size_t>();
    if (pieces > bytes.size()) return std::nullopt;
    for (std::size_t i = 0; i < pieces; ++i) {
      render::LevelsOfDetail::Piece piece;
      piece.bounds = from.value<render::Bounds>();
      piece.levels = from.vector<render::LevelsOfDetail::Level>();
      levels.pieces.push_back(std::move(piece));
    }
    if (!fits(levels, *each.mesh)) return std::nullopt;
  }
  if (!from.finished_well()) return std::nullopt;
  return all;
}

// Returns what is to be told of the file that they are kept in.
std::string add_levels(const Meshes& meshes, const BakeCache& cache) {
  const auto is_whole = [&meshes](std::span<const std::byte> bytes) {
    return levels_from(bytes, meshes).has_value();
  };
  const Baked<std::vector<std::byte>> kept =
      cache.bytes(name_of_levels(meshes), is_whole, [&meshes] { return make_bytes(meshes); });
  std::optional<Levels> all = levels_from(kept.value, meshes);
  if (!all) return kept.note;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    render::LevelsOfDetail& levels = (*all)[i];
    const bool is_all_edges = levels.pieces.size() == 1 && levels.pieces[0].levels.size() == 1;
    if (!is_all_edges) meshes[i].mesh->levels = std::move(levels);
  }
  return kept.note;
}

// Of each mesh: which of its places in textures are looked up.
std::vector<render::UvSets> read_sets(const render::VisualDesc& desc) {
  std::vector<render::UvSets> sets(desc.meshes.size());
  for (const render::Instance& instance : desc.instances) {
    const auto& detail = desc.materials[instance.material].detail;
    if (!detail || desc.meshes[instance.mesh].uv.empty()) continue;
    for (const std::optional<render::TextureLayer>& layer : detail->layers)
      if (layer) sets[instance.mesh][layer->uv_set == 1 ? 1 : 0] = true;
  }
  return sets;
}

}  // namespace

std::vector<std::string> add_levels_of_detail(render::VisualDesc& desc, const BakeCache& cache) {
  std::vector<Meshes> files;
  Meshes small;
  const std::vector<render::UvSets> read = read_sets(desc);
  for (std::size_t i = 0; i < desc.meshes.size(); ++i) {
    const MeshInUse each{&desc.meshes[i], read[i]};
    const std::size_t triangles = each.mesh->indices.size() / 3;
    if (triangles < render::kTrianglesWorthLevels) continue;
    if (triangles < kTrianglesWorthAFile)
      small.push_back(each);
    else
      files.push_back({each});
  }
  if (!small.empty()) files.push_back(std::move(small));
  std::vector<std::string> notes;
  for (const Meshes& meshes : files) {
    std::string note = add_levels(meshes, cache);
    const bool is_told = std::ranges::find(notes, note) != notes.end();  // of the file before
    if (!note.empty() && !is_told) notes.push_back(std::move(note));
  }
  return notes;
}

}  // namespace fulcrum::scenario
