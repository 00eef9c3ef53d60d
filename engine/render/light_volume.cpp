#include "engine/render/light_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace fulcrum::render {
namespace {

constexpr float kMostVoxels = 64.0F;  // along the longest side
constexpr std::size_t kDirections = 64;
constexpr std::size_t kFineDirections = 4096;  // that those stand for, of light that changes little

// Unit, spread evenly.
template <std::size_t n>
std::array<glm::vec3, n> directions() {
  std::array<glm::vec3, n> made;
  for (std::size_t i = 0; i < n; ++i) {
    const float y = 1.0F - 2.0F * (static_cast<float>(i) + 0.5F) / static_cast<float>(n);
    const float turn = 2.39996323F * static_cast<float>(i), across = std::sqrt(1.0F - y * y);
    made[i] = {across * std::cos(turn), y, across * std::sin(turn)};
  }
  return made;
}

std::vector<Beam> spread_beams(const Surroundings& around) {
  std::vector<Beam> beams;
  for (const glm::vec3& d : directions<kFineDirections>())
    beams.push_back({d, around.radiance(d), 1.0F / static_cast<float>(kFineDirections)});
  return beams;
}

struct Ray {
  glm::vec3 from;   // unit: where the light comes from
  float luminance;  // in the mean of all directions that this one stands for, times their share of all
};

std::vector<Ray> rays_of(const Surroundings& around) {
  std::vector<Ray> rays;
  for (const glm::vec3& d : directions<kDirections>()) rays.push_back({d, 0.0F});
  for (const Beam& beam : around.beams.empty() ? spread_beams(around) : around.beams) {
    const auto nearest =
        std::ranges::max_element(rays, {}, [&](const Ray& ray) { return glm::dot(ray.from, beam.from); });
    nearest->luminance += glm::dot(beam.radiance, kLuminance) * beam.share;
  }
  return rays;
}

// Light of one direction on its way through the grid, slice by slice across the axis that it mostly follows.
template <typename Light>
class Sweep {
public:
  // outside: what arrives at the grid.
  Sweep(const VoxelGrid& grid, const glm::vec3& from, const Light& outside) {
    const glm::vec3 size = glm::abs(from);
    along_ = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    u_ = (along_ + 1) % 3;
    v_ = (along_ + 2) % 3;
    counts_ = glm::ivec3(grid.counts);
    strides_ = {1, counts_.x, counts_.x * counts_.y};
    upwards_ = from[along_] > 0.0F;
    du_ = from[u_] / size[along_];
    dv_ = from[v_] / size[along_];
    const auto slice = static_cast<std::size_t>((counts_[u_] + 3) * (counts_[v_] + 3));
    before_.assign(slice, outside);  // with a rim of open voxels
    after_.assign(slice, outside);
  }

  // leaves(voxel, light): of each voxel once, what leaves it of the light that arrives.
  template <typename Leaves>
  void run(const Leaves& leaves) {
    for (int step = 0; step < counts_[along_]; ++step) {
      const int at = upwards_ ? counts_[along_] - 1 - step : step;
      for (int v = 0; v < counts_[v_]; ++v)
        for (int u = 0; u < counts_[u_]; ++u) {
          const auto voxel =
              static_cast<std::size_t>(at * strides_[along_] + u * strides_[u_] + v * strides_[v_]);
          after_[place(u, v)] =
              leaves(voxel, upstream(static_cast<float>(u) + du_, static_cast<float>(v) + dv_));
        }
      before_.swap(after_);
    }
  }

private:
  std::size_t place(int u, int v) const {
    return static_cast<std::size_t>((v + 1) * (counts_[u_] + 3) + u + 1);
  }

  Light upstream(float u, float v) const {
    const float low_u = std::floor(u), low_v = std::floor(v);
    const Light* first = before_.data() + place(static_cast<int>(low_u), static_cast<int>(low_v));
    const Light* second = first + counts_[u_] + 3;
    const float part_u = u - low_u, part_v = v - low_v;
    const Light near = first[0] + part_u * (first[1] - first[0]);
    const Light far = second[0] + part_u * (second[1] - second[0]);
    return near + part_v * (far - near);
  }

  int along_ = 0, u_ = 1, v_ = 2;
  glm::ivec3 counts_{1}, strides_{1};
  bool upwards_ = false;
  float du_ = 0.0F, dv_ = 0.0F;
  std::vector<Light> before_, after_;
};

void let_in(LightVolume& made, const VoxelGrid& grid, const std::vector<float>& passes,
            const std::vector<Ray>& rays) {
  made.open.assign(grid.size(), glm::vec4(0.0F));
  made.received.assign(grid.size(), glm::vec4(0.0F));
  for (const Ray& ray : rays) {
    const glm::vec4 open = glm::vec4(3.0F * ray.from, 1.0F) / static_cast<float>(rays.size());
    const glm::vec4 received = glm::vec4(2.0F * ray.from, 1.0F) * ray.luminance;
    Sweep<float> sweep(grid, ray.from, 1.0F);
    sweep.run([&](std::size_t voxel, float part) {
      made.open[voxel] += part * open;
      made.received[voxel] += part * received;
      return part * passes[voxel];
    });
  }
}

float in(const glm::vec4& harmonics, const glm::vec3& d) {
  return std::max(glm::dot(glm::vec3(harmonics), d) + harmonics.w, 0.0F);
}

// Radiance that a voxel's surfaces send on, lit as the place two voxels before them is.
std::vector<glm::vec3> radiance_of(const LightVolume& made, const VoxelGrid& grid,
                                   const std::vector<Matter>& matter, const VisualDesc& desc,
                                   const Irradiance& around) {
  std::vector<glm::vec3> sent(matter.size(), glm::vec3(0.0F));
  for (std::size_t i = 0; i < matter.size(); ++i) {
    if (matter[i].area == 0.0F) continue;
    const glm::vec3 n = facing(matter[i]).value_or(glm::vec3(0, 1, 0));
    const glm::vec3 at = grid.low + grid.voxel * (glm::vec3(grid.cell(i)) + 0.5F + 1.5F * n);
    const std::size_t seen = grid.index(at).value_or(i);
    const float lit = std::min(in(made.received[seen], n) / std::max(in(made.unhidden, n), 1e-6F), 1.0F);
    glm::vec3 arrives = irradiance(around, n) * lit;
    if (desc.key_light) {
      const KeyBeam beam = key_beam(*desc.key_light, at, grid.voxel);
      arrives += beam.arriving * (std::max(glm::dot(n, beam.towards), 0.0F) *
                                  std::min(in(made.open[seen], beam.towards), 1.0F));
    }
    sent[i] = matter[i].colour / matter[i].area * arrives;
  }
  return sent;
}

// Nothing arrives from outside; what leaves a voxel is what it lets through and, to the side that it faces,
// what it sends.
void send_on(LightVolume& made, const VoxelGrid& grid, const std::vector<Matter>& matter,
             const std::vector<float>& passes, const std::vector<Ray>& rays,
             const std::vector<glm::vec3>& sent) {
  std::vector<std::optional<glm::vec3>> normals;
  normals.reserve(matter.size());
  for (const Matter& each : matter) normals.push_back(facing(each));
  made.sent_on.assign(grid.size(), glm::vec4(0.0F));
  for (const Ray& ray : rays) {
    Sweep<glm::vec4> sweep(grid, ray.from, glm::vec4(0.0F));  // w: the part that is hidden
    sweep.run([&](std::size_t voxel, const glm::vec4& light) {
      made.sent_on[voxel] += light;
      if (passes[voxel] == 1.0F) return light;
      const bool seen = !normals[voxel] || glm::dot(*normals[voxel], ray.from) < 0.2F;
      const glm::vec4 own(seen ? sent[voxel] : glm::vec3(0.0F), 1.0F);
      return glm::mix(own, light, passes[voxel]);
    });
  }
  for (glm::vec4& voxel : made.sent_on) voxel /= std::max(voxel.w, 1e-3F);
}

}  // namespace

KeyBeam key_beam(const KeyLight& key, const glm::vec3& at, float nearest) {
  if (key.kind != KeyLight::Kind::spot)
    return {-glm::normalize(key.direction), key.colour * key.intensity, std::numeric_limits<float>::max()};
  const glm::vec3 way = key.position - at;
  const glm::vec3 towards = glm::normalize(way);
  const float radius2 = 0.25F * key.diameter * key.diameter;
  float strength =
      key.intensity * (1.0F + radius2) / std::max(glm::dot(way, way) + radius2, nearest * nearest);
  if (glm::dot(-towards, glm::normalize(key.direction)) < std::cos(0.5F * key.cone_rad)) strength = 0.0F;
  return {towards, key.colour * strength, glm::length(way)};
}

std::vector<std::uint32_t> light_volume_layers(const VisualDesc& desc) {
  std::uint32_t any = 0, common = ~0U;
  for (const Instance& instance : desc.instances) {
    if (!hides_light(desc, instance, ~0U)) continue;
    any |= instance.layers;
    common &= instance.layers;
  }
  if (any == 0 || any == common) return {~0U};
  std::vector<std::uint32_t> each;
  for (std::uint32_t bit = 1; bit != 0; bit <<= 1)
    if ((any & bit) != 0) each.push_back(bit);
  return each;
}

std::uint64_t light_volume_voxels(const VisualDesc& desc) {
  std::uint64_t all = 0;
  for (const std::uint32_t layers : light_volume_layers(desc)) {
    const std::optional<VoxelGrid> grid = voxel_grid(desc, layers, kMostVoxels);
    all += grid ? grid->size() : 1;
  }
  return all;
}

LightVolume make_light_volume(const VisualDesc& desc, std::uint32_t layers, const Surroundings& around,
                              const Irradiance& received) {
  LightVolume made;
  const std::vector<Ray> rays = rays_of(around);
  for (const Ray& ray : rays) made.unhidden += glm::vec4(2.0F * ray.from, 1.0F) * ray.luminance;
  made.received = {made.unhidden};
  const std::optional<VoxelGrid> grid = voxel_grid(desc, layers, kMostVoxels);
  if (!grid) return made;
  made.low = grid->low;
  made.voxel = grid->voxel;
  made.counts = grid->counts;
  made.means = texture_means(desc, layers);
  const std::vector<Matter> matter = matter_of(desc, layers, *grid, 1.0F, made.means);
  const std::vector<float> passes = passing(*grid, matter);
  let_in(made, *grid, passes, rays);
  send_on(made, *grid, matter, passes, rays, radiance_of(made, *grid, matter, desc, received));
  return made;
}

}  // namespace fulcrum::render
