#include "engine/render/voxels.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/render/bounds.h"
#include "engine/render/look.h"
#include "engine/render/mip_chain.h"

namespace fulcrum::render {
namespace {

struct Corner {
  glm::vec3 at, colour;
};

// Triangles cut into pieces, each of which belongs to the voxel that its middle lies in.
class Voxeliser {
public:
  // piece: m, the longest edge of one.
  Voxeliser(const VoxelGrid& grid, float piece) : grid_(grid), piece_(piece), matter_(grid.size()) {}

  void add(const Corner& a, const Corner& b, const Corner& c) { add(a, b, c, 0); }
  std::vector<Matter> take() { return std::move(matter_); }

private:
  static constexpr int kMostHalvings = 60;

  bool is_beside(const Corner& a, const Corner& b, const Corner& c) const {
    const glm::vec3 high = grid_.low + grid_.voxel * glm::vec3(grid_.counts);
    return glm::any(glm::lessThan(glm::max(a.at, glm::max(b.at, c.at)), grid_.low)) ||
           glm::any(glm::greaterThan(glm::min(a.at, glm::min(b.at, c.at)), high));
  }

  void add(const Corner& a, const Corner& b, const Corner& c, int halvings) {
    if (is_beside(a, b, c)) return;
    const float ab = glm::distance(a.at, b.at), bc = glm::distance(b.at, c.at),
                ca = glm::distance(c.at, a.at);
    const float longest = std::max({ab, bc, ca});
    if (longest <= piece_ || halvings == kMostHalvings) return keep(a, b, c);
    const auto halve = [&](const Corner& from, const Corner& to, const Corner& rest) {
      const Corner middle{0.5F * (from.at + to.at), 0.5F * (from.colour + to.colour)};
      if (middle.at == from.at || middle.at == to.at) return keep(a, b, c);  // no float lies between
      add(from, middle, rest, halvings + 1);
      add(middle, to, rest, halvings + 1);
    };
    if (ab == longest) return halve(a, b, c);
    if (bc == longest) return halve(b, c, a);
    halve(c, a, b);
  }

  void keep(const Corner& a, const Corner& b, const Corner& c) {
    const auto where = grid_.index((a.at + b.at + c.at) / 3.0F);
    if (!where) return;
    const glm::vec3 normal = 0.5F * glm::cross(b.at - a.at, c.at - a.at);
    const float area = glm::length(normal);
    Matter& voxel = matter_[*where];
    voxel.area += area;
    voxel.normal += normal;
    voxel.colour += area / 3.0F * (a.colour + b.colour + c.colour);
  }

  VoxelGrid grid_;
  float piece_;
  std::vector<Matter> matter_;
};

// The picture of its base colour; none: it has none.
std::optional<std::size_t> base_texture(const Material& material) {
  if (!material.detail) return {};
  const auto& layer = material.detail->layers[SurfaceDetail::base_colour];
  return layer ? std::optional(layer->texture) : std::nullopt;
}

// What a surface of it sends on of what it receives, in the mean of its picture.
glm::vec3 sent_on_by(const Material& material, const TextureMeans& means) {
  const auto texture = base_texture(material);
  return texture ? material.base_colour * *means[*texture] : material.base_colour;
}

// An instance that hides light, its vertices in the world.
struct Standing {
  const Mesh* mesh;
  std::vector<Corner> corners;
};

std::vector<Standing> standing_in(const VisualDesc& desc, std::uint32_t layers, const TextureMeans& means) {
  std::vector<Standing> found;
  for (const Instance& instance : desc.instances) {
    if (!hides_light(desc, instance, layers)) continue;
    const Mesh& mesh = desc.meshes[instance.mesh];
    const glm::vec3 colour = sent_on_by(desc.materials[instance.material], means);
    Standing& standing = found.emplace_back(Standing{&mesh, {}});
    standing.corners.reserve(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
      standing.corners.push_back({glm::vec3(instance.X_WM * glm::vec4(mesh.positions[i], 1.0F)),
                                  colour * (mesh.colours.empty() ? glm::vec3(1.0F) : mesh.colours[i])});
  }
  return found;
}

template <typename Each>
void for_each_triangle(const std::vector<Standing>& all, const Each& each) {
  for (const Standing& standing : all)
    for (std::size_t i = 0; i + 2 < standing.mesh->indices.size(); i += 3) {
      const std::uint32_t* corner = standing.mesh->indices.data() + i;
      each(standing.corners[corner[0]], standing.corners[corner[1]], standing.corners[corner[2]]);
    }
}

// m, as wide as is asked for unless that made millions of them: a thousand sheets, each as large as the
// scene.
float piece_for(const std::vector<Standing>& all, const VoxelGrid& grid, float piece) {
  const float wanted = piece * grid.voxel;
  constexpr float kMostPieces = 4e6F;
  const auto longest = static_cast<float>(std::max({grid.counts.x, grid.counts.y, grid.counts.z}));
  const float most_of_one = 16.0F * longest * longest / (piece * piece);
  float pieces = 0.0F;
  for_each_triangle(all, [&](const Corner& a, const Corner& b, const Corner& c) {
    const float size =
        std::max({glm::distance(a.at, b.at), glm::distance(b.at, c.at), glm::distance(c.at, a.at)});
    pieces += std::min(size * size / (wanted * wanted), most_of_one);
  });
  return wanted * std::sqrt(std::max(1.0F, pieces / kMostPieces));
}

}  // namespace

std::optional<std::size_t> VoxelGrid::index(const glm::vec3& at) const {
  const glm::vec3 in = (at - low) / voxel;
  for (int i = 0; i < 3; ++i)
    if (!(in[i] >= 0.0F && in[i] < static_cast<float>(counts[i]))) return {};
  const glm::uvec3 cell(in);
  return (std::size_t{cell.z} * counts.y + cell.y) * counts.x + cell.x;
}

glm::uvec3 VoxelGrid::cell(std::size_t index) const {
  return {index % counts.x, index / counts.x % counts.y, index / (std::size_t{counts.x} * counts.y)};
}

glm::vec3 VoxelGrid::middle(std::size_t index) const {
  return low + voxel * (glm::vec3(cell(index)) + 0.5F);
}

bool hides_light(const VisualDesc& desc, const Instance& instance, std::uint32_t layers) {
  if (instance.movable || (instance.layers & layers) == 0) return false;
  const auto look = look_of(desc.materials[instance.material]);
  return !look || !(is_blended(*look) || is_all_cut_out(*look));
}

std::optional<VoxelGrid> voxel_grid(const VisualDesc& desc, std::uint32_t layers, float most) {
  std::vector<Bounds> casters, others;
  for (const Instance& instance : desc.instances) {
    if (!hides_light(desc, instance, layers)) continue;
    const Bounds box = transformed(bounds_of(desc.meshes[instance.mesh].positions), instance.X_WM);
    (instance.casts_shadow ? casters : others).push_back(box);
  }
  if (casters.empty()) casters.swap(others);
  if (casters.empty()) return {};
  Bounds all = casters.front();
  for (const Bounds& box : casters) all = {glm::min(all.low, box.low), glm::max(all.high, box.high)};
  const glm::vec3 reach(0.5F *
                        std::max({all.high.x - all.low.x, all.high.y - all.low.y, all.high.z - all.low.z}));
  const Bounds around{all.low - reach, all.high + reach};
  for (const Bounds& box : others) {
    const glm::vec3 low = glm::max(box.low, around.low), high = glm::min(box.high, around.high);
    if (glm::all(glm::lessThanEqual(low, high))) all = {glm::min(all.low, low), glm::max(all.high, high)};
  }
  const glm::vec3 size = all.high - all.low;
  VoxelGrid grid;
  grid.voxel = std::max({size.x, size.y, size.z, 1e-6F}) / (most - 6.0F);
  grid.counts = glm::uvec3(glm::ceil(size / grid.voxel)) + 6U;  // an open rim of three all round
  grid.low = 0.5F * (all.low + all.high) - 0.5F * grid.voxel * glm::vec3(grid.counts);
  return grid;
}

TextureMeans texture_means(const VisualDesc& desc, std::uint32_t layers) {
  TextureMeans means(desc.textures.size());
  for (const Instance& instance : desc.instances) {
    if (!hides_light(desc, instance, layers)) continue;
    const auto texture = base_texture(desc.materials[instance.material]);
    if (texture && !means[*texture]) means[*texture] = mean_colour(desc.textures[*texture]);
  }
  return means;
}

std::vector<Matter> matter_of(const VisualDesc& desc, std::uint32_t layers, const VoxelGrid& grid,
                              float piece, const TextureMeans& means) {
  const std::vector<Standing> all = standing_in(desc, layers, means);
  Voxeliser voxeliser(grid, piece_for(all, grid, piece));
  for_each_triangle(all, [&](const Corner& a, const Corner& b, const Corner& c) { voxeliser.add(a, b, c); });
  return voxeliser.take();
}

std::optional<glm::vec3> facing(const Matter& matter) {
  const float net = glm::length(matter.normal);
  if (net < 0.1F * matter.area || net == 0.0F) return {};
  return matter.normal / net;
}

std::vector<float> passing(const VoxelGrid& grid, const std::vector<Matter>& matter) {
  const float face = grid.voxel * grid.voxel;
  std::vector<float> passes(matter.size());
  for (std::size_t i = 0; i < matter.size(); ++i) passes[i] = 1.0F - std::min(matter[i].area / face, 1.0F);
  return passes;
}

}  // namespace fulcrum::render
