#include "engine/render/mirror_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace fulcrum::render {
namespace {

constexpr float kMirrorVoxels = 128.0F;  // along the longest side, at the most
constexpr std::uint32_t kLevels = 5;     // each side of the finest is a multiple of 16
constexpr float kPiece = 0.35F;          // voxels, see matter_of()
constexpr float kBefore = 1.25F;         // voxels before a surface: light is found there

std::optional<VoxelGrid> mirror_grid(const VisualDesc& desc, std::uint32_t layers) {
  std::optional<VoxelGrid> grid =
      voxel_grid(desc, layers, kMirrorVoxels - 1.0F);  // rounding may bring one more
  if (!grid) return {};
  constexpr std::uint32_t step = 1U << (kLevels - 1);
  const glm::uvec3 counts = (grid->counts + step - 1U) / step * step;
  grid->low -= 0.5F * grid->voxel * glm::vec3(counts - grid->counts);
  grid->counts = counts;
  return grid;
}

// Of a volume's harmonics, between voxels.
glm::vec4 harmonics_at(const LightVolume& light, const std::vector<glm::vec4>& of, const glm::vec3& at) {
  const glm::vec3 in = (at - light.low) / light.voxel - 0.5F;
  const glm::vec3 last = glm::vec3(light.counts) - 1.0F;
  const glm::vec3 place = glm::clamp(in, glm::vec3(0.0F), last);
  const glm::uvec3 low = glm::min(glm::uvec3(place), light.counts - 1U),
                   high = glm::min(low + 1U, light.counts - 1U);
  const glm::vec3 part = place - glm::vec3(low);
  const auto at_cell = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    return of[(std::size_t{z} * light.counts.y + y) * light.counts.x + x];
  };
  const auto row = [&](std::uint32_t y, std::uint32_t z) {
    return glm::mix(at_cell(low.x, y, z), at_cell(high.x, y, z), part.x);
  };
  return glm::mix(glm::mix(row(low.y, low.z), row(high.y, low.z), part.y),
                  glm::mix(row(low.y, high.z), row(high.y, high.z), part.y), part.z);
}

float harmonics_in(const glm::vec4& harmonics, const glm::vec3& d) {
  return std::max(glm::dot(glm::vec3(harmonics), d) + harmonics.w, 0.0F);
}

// The part of a light that arrives through the voxels.
float unhidden(const VoxelGrid& grid, const std::vector<float>& passes, glm::vec3 at,
               const glm::vec3& towards, float far) {
  float part = 1.0F;
  for (float way = 0.0F; way < far && part > 0.02F; way += grid.voxel, at += grid.voxel * towards) {
    const std::optional<std::size_t> voxel = grid.index(at);
    if (!voxel) break;
    part *= passes[*voxel];
  }
  return part;
}

struct Lighting {
  const VisualDesc& desc;
  const VoxelGrid& grid;
  const std::vector<float>& passes;
  const LightVolume& light;
  const Irradiance& around;
};

// Irradiance / pi of a surface in the middle of a voxel that faces n.
glm::vec3 arriving(const Lighting& by, const glm::vec3& middle, const glm::vec3& n) {
  const glm::vec3 before = middle + n * (kBefore * by.light.voxel);
  const glm::vec4 received = harmonics_at(by.light, by.light.received, before);
  const float lit =
      std::min(harmonics_in(received, n) / std::max(harmonics_in(by.light.unhidden, n), 1e-6F), 1.0F);
  glm::vec3 all =
      glm::mix(glm::vec3(harmonics_at(by.light, by.light.sent_on, before)), irradiance(by.around, n), lit);
  if (!by.desc.key_light) return all;
  const KeyBeam beam = key_beam(*by.desc.key_light, middle, by.grid.voxel);
  const float facing_it = glm::dot(n, beam.towards);
  if (facing_it > 0.0F)
    all += beam.arriving * (facing_it * unhidden(by.grid, by.passes, middle + 2.0F * by.grid.voxel * n,
                                                 beam.towards, beam.far));
  return all;
}

// Radiance that a voxel's surfaces send on. Of what has another side in it, as a thin board has, that of the
// brightest side: it is looked at from where light comes to it.
glm::vec3 radiance_sent(const Lighting& by, const Matter& matter, const glm::vec3& middle) {
  const glm::vec3 colour = matter.colour / matter.area;
  if (const std::optional<glm::vec3> n = facing(matter)) return colour * arriving(by, middle, *n);
  glm::vec3 brightest(0.0F);
  for (const glm::vec3& side : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)})
    for (const float sign : {1.0F, -1.0F}) {
      const glm::vec3 arrives = arriving(by, middle, sign * side);
      if (arrives.x + arrives.y + arrives.z > brightest.x + brightest.y + brightest.z) brightest = arrives;
    }
  return colour * brightest;
}

// The part of light that a voxel of that face (m^2) hides: what faces one way all of it, of the rest, which
// has another side, the half.
float cover(const Matter& matter, float face) {
  const float net = glm::length(matter.normal);
  return std::min((net + 0.5F * (matter.area - net)) / face, 1.0F);
}

struct VoxelLevel {
  glm::uvec3 counts;
  std::vector<float> area;      // m^2
  std::vector<glm::vec3> sent;  // radiance, times that
  std::vector<glm::vec3> normal,
      bright;                // the way that surfaces face, times that; and times their luminance, too
  std::vector<float> hides;  // the part of light

  std::size_t index(const glm::uvec3& cell) const {
    return (std::size_t{cell.z} * counts.y + cell.y) * counts.x + cell.x;
  }
};

// Of eight voxels, x fastest: what of the light along an axis two behind each other hide, in the mean of the
// four pairs; of the axis along which that is most, so that a wall of one voxel stays one.
float hidden_by_eight(const std::array<float, 8>& hides) {
  float most = 0.0F;
  for (std::size_t axis = 1; axis < 8; axis *= 2) {
    float sum = 0.0F;
    for (std::size_t i = 0; i < 8; ++i)
      if ((i & axis) == 0) sum += 1.0F - (1.0F - hides[i]) * (1.0F - hides[i | axis]);
    most = std::max(most, 0.25F * sum);
  }
  return most;
}

// Of half as many voxels along each side.
VoxelLevel coarser(const VoxelLevel& fine) {
  VoxelLevel made{fine.counts / 2U, {}, {}, {}, {}, {}};
  for (std::uint32_t z = 0; z < made.counts.z; ++z)
    for (std::uint32_t y = 0; y < made.counts.y; ++y)
      for (std::uint32_t x = 0; x < made.counts.x; ++x) {
        float area = 0.0F;
        glm::vec3 sent(0.0F), normal(0.0F), bright(0.0F);
        std::array<float, 8> hides{};
        for (std::uint32_t i = 0; i < 8; ++i) {
          const std::size_t from = fine.index({2 * x + (i & 1U), 2 * y + (i >> 1U & 1U), 2 * z + (i >> 2U)});
          area += fine.area[from];
          sent += fine.sent[from];
          normal += fine.normal[from];
          bright += fine.bright[from];
          hides[i] = fine.hides[from];
        }
        made.area.push_back(area);
        made.sent.push_back(sent);
        made.normal.push_back(normal);
        made.bright.push_back(bright);
        made.hides.push_back(hidden_by_eight(hides));
      }
  return made;
}

std::vector<glm::vec4> shown(const VoxelLevel& level) {
  std::vector<glm::vec4> voxels(level.area.size(), glm::vec4(0.0F));
  for (std::size_t i = 0; i < voxels.size(); ++i)
    if (level.area[i] > 0.0F)
      voxels[i] = glm::vec4(level.sent[i] / level.area[i] * level.hides[i], level.hides[i]);
  return voxels;
}

// A sum over surfaces, as a mean of what hides light.
std::vector<glm::vec4> in_the_mean(const VoxelLevel& level, const std::vector<glm::vec3>& sums) {
  std::vector<glm::vec4> voxels(sums.size(), glm::vec4(0.0F));
  for (std::size_t i = 0; i < voxels.size(); ++i)
    if (level.area[i] > 0.0F) voxels[i] = glm::vec4(sums[i] / level.area[i] * level.hides[i], 0.0F);
  return voxels;
}

std::uint64_t with_coarser(std::uint64_t voxels) {
  std::uint64_t all = 0;
  for (std::uint32_t level = 0; level < kLevels; ++level) all += voxels >> (3 * level);
  return all;
}

// Something is of metal smooth enough to mirror its neighbours, and something stands.
bool mirrors_neighbours(const VisualDesc& desc) {
  constexpr float kRoughest = 0.7F;  // of shaders/include/shading.glsl: the light volume tells as much
  const bool metal = std::ranges::any_of(desc.instances, [&](const Instance& instance) {
    const Material& material = desc.materials[instance.material];
    const bool is_textured = material.detail && material.detail->layers[SurfaceDetail::metal_rough];
    const bool is_unlit = material.detail && material.detail->unlit;
    return material.metallic > 0.0F && (material.roughness < kRoughest || is_textured) && !is_unlit;
  });
  return metal && light_volume_voxels(desc) > light_volume_layers(desc).size();
}

}  // namespace

std::uint64_t mirror_volume_voxels(const VisualDesc& desc) {
  if (!mirrors_neighbours(desc)) return 0;
  std::uint64_t all = 0;
  for (const std::uint32_t layers : light_volume_layers(desc)) {
    const std::optional<VoxelGrid> grid = mirror_grid(desc, layers);
    all += grid ? 3 * with_coarser(grid->size()) - 2 * grid->size() : 3;
  }
  return all;
}

MirrorVolume make_mirror_volume(const VisualDesc& desc, std::uint32_t layers, const LightVolume& light,
                                const Irradiance& received) {
  MirrorVolume made;
  const std::optional<VoxelGrid> grid = mirror_grid(desc, layers);
  if (!grid) return made;
  made.low = grid->low;
  made.voxel = grid->voxel;
  made.counts = grid->counts;
  const std::vector<Matter> matter = matter_of(desc, layers, *grid, kPiece, light.means);
  const std::vector<float> passes = passing(*grid, matter);
  const Lighting by{desc, *grid, passes, light, received};
  VoxelLevel level{grid->counts, {}, {}, {}, {}, {}};
  for (std::size_t i = 0; i < matter.size(); ++i) {
    const float area = matter[i].area;
    level.area.push_back(area);
    const glm::vec3 sent = area > 0.0F ? radiance_sent(by, matter[i], grid->middle(i)) : glm::vec3(0.0F);
    level.sent.push_back(area * sent);
    level.normal.push_back(matter[i].normal);
    level.bright.push_back(glm::dot(sent, kLuminance) * matter[i].normal);
    level.hides.push_back(cover(matter[i], grid->voxel * grid->voxel));
  }
  made.levels = {shown(level)};
  made.facing.clear();
  made.bright.clear();
  while (made.levels.size() < kLevels) {
    level = coarser(level);
    made.levels.push_back(shown(level));
    made.facing.push_back(in_the_mean(level, level.normal));
    made.bright.push_back(in_the_mean(level, level.bright));
  }
  return made;
}

}  // namespace fulcrum::render
