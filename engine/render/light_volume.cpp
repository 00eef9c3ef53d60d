#include "engine/render/light_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/render/bounds.h"
#include "engine/render/look.h"
#include "engine/render/mip_chain.h"

namespace fulcrum::render {
namespace {

constexpr float kMostVoxels = 64.0F;  // along the longest side
constexpr std::size_t kDirections = 64;
constexpr std::size_t kFineDirections = 4096;  // that those stand for, of light that changes little
constexpr glm::vec3 kLuminance{0.2126F, 0.7152F, 0.0722F};

struct Grid {
  glm::vec3 low{0.0F};
  float voxel = 1.0F;
  glm::uvec3 counts{1U};

  std::size_t size() const { return std::size_t{counts.x} * counts.y * counts.z; }
  // Of the voxel around a point; none: it lies outside.
  std::optional<std::size_t> index(const glm::vec3& at) const {
    const glm::vec3 in = (at - low) / voxel;
    for (int i = 0; i < 3; ++i)
      if (!(in[i] >= 0.0F && in[i] < static_cast<float>(counts[i]))) return {};
    const glm::uvec3 cell(in);
    return (std::size_t{cell.z} * counts.y + cell.y) * counts.x + cell.x;
  }
};

bool hides_light(const VisualDesc& desc, const Instance& instance, std::uint32_t layers) {
  if (instance.movable || (instance.layers & layers) == 0) return false;
  const auto look = look_of(desc.materials[instance.material]);
  return !look || !is_blended(*look);
}

// Around what stands and throws a shadow; a floor or wall near it belongs to it as far as it is near.
std::optional<Grid> grid_over(const VisualDesc& desc, std::uint32_t layers) {
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
  Grid grid;
  grid.voxel = std::max({size.x, size.y, size.z, 1e-6F}) / (kMostVoxels - 6.0F);
  grid.counts = glm::uvec3(glm::ceil(size / grid.voxel)) + 6U;  // an open rim of three all round
  grid.low = 0.5F * (all.low + all.high) - 0.5F * grid.voxel * glm::vec3(grid.counts);
  return grid;
}

// What the triangles in a voxel amount to.
struct Matter {
  float area = 0.0F;       // m^2
  glm::vec3 normal{0.0F};  // times area
  glm::vec3 colour{0.0F};  // what they send on of what they receive, times area
};

struct Corner {
  glm::vec3 at, colour;
};

// Triangles cut into pieces of about a voxel, each of which belongs to the voxel that its middle lies in.
class Voxeliser {
public:
  // piece: m, the longest edge of one.
  Voxeliser(const Grid& grid, float piece) : grid_(grid), piece_(piece), matter_(grid.size()) {}

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

  Grid grid_;
  float piece_;
  std::vector<Matter> matter_;
};

// What a surface of it sends on of what it receives, in the mean of its picture.
glm::vec3 sent_on_by(const VisualDesc& desc, const Material& material) {
  if (!material.detail) return material.base_colour;
  const auto& layer = material.detail->layers[SurfaceDetail::base_colour];
  return layer ? material.base_colour * mean_colour(desc.textures[layer->texture]) : material.base_colour;
}

// An instance that hides light, its vertices in the world.
struct Standing {
  const Mesh* mesh;
  std::vector<Corner> corners;
};

std::vector<Standing> standing_in(const VisualDesc& desc, std::uint32_t layers) {
  std::vector<Standing> found;
  std::vector<glm::vec3> colours;  // of each material
  for (const Material& material : desc.materials) colours.push_back(sent_on_by(desc, material));
  for (const Instance& instance : desc.instances) {
    if (!hides_light(desc, instance, layers)) continue;
    const Mesh& mesh = desc.meshes[instance.mesh];
    const glm::vec3 colour = colours[instance.material];
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

// Pieces of a voxel, unless that made millions of them: a thousand sheets, each as large as the scene.
float piece_for(const std::vector<Standing>& all, const Grid& grid) {
  constexpr float kMostPieces = 4e6F, kMostOfOne = 16.0F * kMostVoxels * kMostVoxels;
  float pieces = 0.0F;
  for_each_triangle(all, [&](const Corner& a, const Corner& b, const Corner& c) {
    const float size =
        std::max({glm::distance(a.at, b.at), glm::distance(b.at, c.at), glm::distance(c.at, a.at)});
    pieces += std::min(size * size / (grid.voxel * grid.voxel), kMostOfOne);
  });
  return grid.voxel * std::sqrt(std::max(1.0F, pieces / kMostPieces));
}

std::vector<Matter> matter_of(const VisualDesc& desc, std::uint32_t layers, const Grid& grid) {
  const std::vector<Standing> all = standing_in(desc, layers);
  Voxeliser voxeliser(grid, piece_for(all, grid));
  for_each_triangle(all, [&](const Corner& a, const Corner& b, const Corner& c) { voxeliser.add(a, b, c); });
  return voxeliser.take();
}

// Unit; none: as much of it faces one way as the other.
std::optional<glm::vec3> facing(const Matter& matter) {
  const float net = glm::length(matter.normal);
  if (net < 0.1F * matter.area || net == 0.0F) return {};
  return matter.normal / net;
}

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
  Sweep(const Grid& grid, const glm::vec3& from, const Light& outside) {
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

std::vector<float> passing(const Grid& grid, const std::vector<Matter>& matter) {
  const float face = grid.voxel * grid.voxel;
  std::vector<float> passes(matter.size());
  for (std::size_t i = 0; i < matter.size(); ++i) passes[i] = 1.0F - std::min(matter[i].area / face, 1.0F);
  return passes;
}

void let_in(LightVolume& made, const Grid& grid, const std::vector<float>& passes,
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

// voxel: no light is nearer than one.
glm::vec3 key_irradiance(const KeyLight& key, float voxel, const glm::vec3& at, const glm::vec3& n,
                         const glm::vec4& open) {
  glm::vec3 towards = -glm::normalize(key.direction);
  float strength = key.intensity;
  if (key.kind == KeyLight::Kind::spot) {
    const glm::vec3 way = key.position - at;
    towards = glm::normalize(way);
    const float radius2 = 0.25F * key.diameter * key.diameter;
    strength *= (1.0F + radius2) / std::max(glm::dot(way, way) + radius2, voxel * voxel);
    if (glm::dot(-towards, glm::normalize(key.direction)) < std::cos(0.5F * key.cone_rad)) strength = 0.0F;
  }
  return key.colour * (strength * std::max(glm::dot(n, towards), 0.0F) * std::min(in(open, towards), 1.0F));
}

// Radiance that a voxel's surfaces send on, lit as the place two voxels before them is.
std::vector<glm::vec3> radiance_of(const LightVolume& made, const Grid& grid,
                                   const std::vector<Matter>& matter, const VisualDesc& desc,
                                   const Irradiance& around) {
  std::vector<glm::vec3> sent(matter.size(), glm::vec3(0.0F));
  for (std::size_t i = 0; i < matter.size(); ++i) {
    if (matter[i].area == 0.0F) continue;
    const glm::vec3 n = facing(matter[i]).value_or(glm::vec3(0, 1, 0));
    const glm::uvec3 cell(i % grid.counts.x, i / grid.counts.x % grid.counts.y,
                          i / (grid.counts.x * grid.counts.y));
    const glm::vec3 at = grid.low + grid.voxel * (glm::vec3(cell) + 0.5F + 1.5F * n);
    const std::size_t seen = grid.index(at).value_or(i);
    const float lit = std::min(in(made.received[seen], n) / std::max(in(made.unhidden, n), 1e-6F), 1.0F);
    glm::vec3 arrives = irradiance(around, n) * lit;
    if (desc.key_light) arrives += key_irradiance(*desc.key_light, grid.voxel, at, n, made.open[seen]);
    sent[i] = matter[i].colour / matter[i].area * arrives;
  }
  return sent;
}

// Nothing arrives from outside; what leaves a voxel is what it lets through and, to the side that it faces,
// what it sends.
void send_on(LightVolume& made, const Grid& grid, const std::vector<Matter>& matter,
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
    const std::optional<Grid> grid = grid_over(desc, layers);
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
  const std::optional<Grid> grid = grid_over(desc, layers);
  if (!grid) return made;
  made.low = grid->low;
  made.voxel = grid->voxel;
  made.counts = grid->counts;
  const std::vector<Matter> matter = matter_of(desc, layers, *grid);
  const std::vector<float> passes = passing(*grid, matter);
  let_in(made, *grid, passes, rays);
  send_on(made, *grid, matter, passes, rays, radiance_of(made, *grid, matter, desc, received));
  return made;
}

}  // namespace fulcrum::render
