#include "engine/assets/gltf_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <string>

#include "engine/assets/gltf_accessor.h"
#include "engine/assets/gltf_light.h"
#include "engine/assets/gltf_material.h"
#include "engine/files/plain_text.h"
#include "haptics/math/functions.h"

namespace fulcrum {
namespace {

// Of all parts: a small file may name one mesh very often.
constexpr std::size_t kMaxIndices = 150'000'000, kMaxVertices = 150'000'000;

constexpr double kFarthest_m =
    1e5;  // of a vertex: nothing that a hand reaches, in whatever unit it was drawn

bool all_finite(const std::vector<double>& numbers) {
  return std::all_of(
      numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

// X_PN: the node's frame in its parent's.
Eigen::Affine3d local_transform(const tinygltf::Node& node) {
  const auto has = [&node](const std::vector<double>& numbers, std::size_t wanted) {
    if (numbers.empty()) return false;
    if (numbers.size() != wanted || !all_finite(numbers))
      throw GltfFault("node " + name_in_quotes(node.name) +
                      " has a transform that is not made of finite numbers; export it again");
    return true;
  };
  Eigen::Affine3d local = Eigen::Affine3d::Identity();
  if (has(node.matrix, 16)) {
    local.matrix() = Eigen::Map<const Eigen::Matrix4d>(node.matrix.data());
    if (local.matrix().row(3) != Eigen::RowVector4d(0, 0, 0, 1))
      throw GltfFault("node " + name_in_quotes(node.name) +
                      " has a matrix whose last row is not 0, 0, 0, 1; export it again");
    return local;
  }
  if (has(node.translation, 3)) local.translate(Vec3(node.translation.data()));
  if (has(node.rotation, 4)) {
    const Quat q(node.rotation[3], node.rotation[0], node.rotation[1],
                 node.rotation[2]);  // the file says x, y, z, w
    if (!(q.norm() > 0.0))
      throw GltfFault("node " + name_in_quotes(node.name) + " has no rotation but zero; export it again");
    local.rotate(q.normalized());
  }
  if (has(node.scale, 3)) local.scale(Vec3(node.scale.data()));
  return local;
}

std::vector<int> root_nodes(const tinygltf::Model& file) {
  if (!file.scenes.empty()) {
    const int scene = std::max(file.defaultScene, 0);
    if (static_cast<std::size_t>(scene) >= file.scenes.size())
      throw GltfFault("its default scene does not exist; export it again");
    return file.scenes[static_cast<std::size_t>(scene)].nodes;
  }
  std::vector<bool> is_child(file.nodes.size(), false);
  for (const tinygltf::Node& node : file.nodes) {
    for (const int child : node.children)
      if (child >= 0 && static_cast<std::size_t>(child) < is_child.size())
        is_child[static_cast<std::size_t>(child)] = true;
  }
  std::vector<int> roots;
  for (std::size_t i = 0; i < is_child.size(); ++i)
    if (!is_child[i]) roots.push_back(static_cast<int>(i));
  return roots;
}

// glTF 2.0, 3.7.2.1: a mesh without normals is shaded flat, so that its triangles share no vertex.
void make_flat_normals(ModelPart& part) {
  std::vector<Vec3> positions, colours;
  std::vector<std::array<float, 4>> uv;
  for (const std::uint32_t i : part.indices) {
    positions.push_back(part.positions[i]);
    if (!part.colours.empty()) colours.push_back(part.colours[i]);
    if (!part.uv.empty()) uv.push_back(part.uv[i]);
  }
  part.positions = std::move(positions);
  part.colours = std::move(colours);
  part.uv = std::move(uv);
  std::iota(part.indices.begin(), part.indices.end(), 0u);
  part.normals.clear();
  for (std::size_t i = 0; i + 2 < part.positions.size(); i += 3) {
    const Vec3 &a = part.positions[i], &b = part.positions[i + 1], &c = part.positions[i + 2];
    part.normals.insert(part.normals.end(), 3, (b - a).cross(c - a));
  }
}

// Parts of one mesh may share its vertices: of each, those that it shows remain.
void keep_used_vertices(ModelPart& part) {
  constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(part.positions.size(), kUnused);
  for (const std::uint32_t i : part.indices) number[i] = 0;
  std::uint32_t used = 0;
  for (std::uint32_t& each : number)
    if (each != kUnused) each = used++;
  if (used == part.positions.size()) return;
  const auto keep = [&](auto& values) {
    if (values.empty()) return;
    for (std::size_t i = 0; i < number.size(); ++i)
      if (number[i] != kUnused) values[number[i]] = values[i];
    values.resize(used);
    values.shrink_to_fit();
  };
  keep(part.positions);
  keep(part.normals);
  keep(part.colours);
  keep(part.uv);
  for (std::uint32_t& i : part.indices) i = number[i];
}

// Where the first two sets of coordinates put each vertex; none: the file has none.
std::vector<std::array<float, 4>> read_uv(const tinygltf::Model& file, const tinygltf::Primitive& primitive,
                                          std::size_t vertices) {
  std::vector<std::array<float, 4>> uv;
  for (const std::size_t set : {std::size_t{0}, std::size_t{1}}) {
    const auto found = primitive.attributes.find("TEXCOORD_" + std::to_string(set));
    if (found == primitive.attributes.end()) continue;
    const std::vector<std::array<float, 2>> read = read_coordinates(file, found->second);
    if (read.size() != vertices)
      throw GltfFault("a mesh has more or fewer texture coordinates than vertices; export it again");
    uv.resize(vertices, {0, 0, 0, 0});
    for (std::size_t i = 0; i < vertices; ++i) {
      uv[i][2 * set] = read[i][0];
      uv[i][2 * set + 1] = read[i][1];
    }
  }
  return uv;
}

ModelPart part_from(const tinygltf::Model& file, const tinygltf::Primitive& primitive) {
  const auto positions = primitive.attributes.find("POSITION");
  if (positions == primitive.attributes.end())
    throw GltfFault("a mesh has no positions; export it again with its geometry");
  ModelPart part;
  part.positions = read_vectors(file, positions->second);
  if (primitive.indices >= 0) {
    part.indices = read_indices(file, primitive.indices);
  } else {
    part.indices.resize(part.positions.size());
    std::iota(part.indices.begin(), part.indices.end(), 0u);
  }
  if (part.indices.size() % 3 != 0) {
    throw GltfFault("a mesh has " + std::to_string(part.indices.size()) +
                    " corners, which are not whole triangles; export it again");
  }
  for (const std::uint32_t i : part.indices) {
    if (i >= part.positions.size()) {
      throw GltfFault("a triangle refers to vertex " + std::to_string(i) + " of " +
                      std::to_string(part.positions.size()) + "; the file is damaged, export it again");
    }
  }
  if (const auto colours = primitive.attributes.find("COLOR_0"); colours != primitive.attributes.end()) {
    part.colours = read_colours(file, colours->second);
    if (part.colours.size() != part.positions.size())
      throw GltfFault("a mesh has more or fewer colours than vertices; export it again");
  }
  if (names_pictures(file, primitive.material)) part.uv = read_uv(file, primitive, part.positions.size());
  if (const auto normals = primitive.attributes.find("NORMAL"); normals != primitive.attributes.end()) {
    part.normals = read_vectors(file, normals->second);
    if (part.normals.size() != part.positions.size())
      throw GltfFault("a mesh has more or fewer normals than vertices; export it again");
    keep_used_vertices(part);
  } else {
    make_flat_normals(part);
  }
  part.material = static_cast<std::uint32_t>(file.materials.size());  // the plain one, for parts without
  if (primitive.material >= 0) {
    part.material = static_cast<std::uint32_t>(primitive.material);
    if (part.material >= file.materials.size())
      throw GltfFault("a mesh refers to a material that the file does not hold; export it again");
  }
  return part;
}

void place(ModelPart& part, const Eigen::Affine3d& X_MN) {
  if (X_MN.linear().determinant() == 0.0)
    throw GltfFault("part " + name_in_quotes(part.name) +
                    " is scaled to nothing; give its node a scale other than zero");
  transform(part, X_MN);
  for (const Vec3& p : part.positions) {
    if (!(p.cwiseAbs().maxCoeff() <= kFarthest_m)) {
      throw GltfFault(
          "part " + name_in_quotes(part.name) +
          " is moved or scaled out of all bounds, farther than 100 km; check its node's transform");
    }
  }
}

// A custom property of an object that is a text; empty: there is none.
std::string property(const tinygltf::Node& node, const std::string& name) {
  if (!node.extras.IsObject() || !node.extras.Has(name)) return {};
  const tinygltf::Value& value = node.extras.Get(name);
  return value.IsString() ? value.Get<std::string>() : std::string();
}

// What nodes hold or what moves them, and no part has.
enum class NotDrawn { points, lines, targets, skins, animations };

const char* clause_about(NotDrawn kind) {
  switch (kind) {
    case NotDrawn::points:
      return "points, which are no surface";
    case NotDrawn::lines:
      return "lines, which are no surface";
    case NotDrawn::targets:
      return "morph targets: the mesh is seen and felt as it is without them";
    case NotDrawn::skins:
      return "skins: the mesh is seen and felt where its node puts it, undeformed";
    default:
      return "animations: all is seen and felt at rest";
  }
}

class Walk {
public:
  explicit Walk(const tinygltf::Model& file) : file_(file), seen_(file.nodes.size(), false) {}

  // All that its nodes hold, in their order.
  void read(Model& model) {
    std::vector<std::pair<int, Eigen::Affine3d>> waiting;
    const auto add = [&waiting](const std::vector<int>& nodes, const Eigen::Affine3d& X_MP) {
      for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) waiting.emplace_back(*node, X_MP);
    };
    add(root_nodes(file_), Eigen::Affine3d::Identity());
    while (!waiting.empty()) {
      const auto [index, X_MP] = waiting.back();
      waiting.pop_back();
      const tinygltf::Node& node = visit(index);
      const Eigen::Affine3d X_MN = X_MP * local_transform(node);
      if (node.mesh >= 0) add_mesh(node, X_MN);
      if (auto light = light_of(file_, node, X_MN)) {
        light->marked_role = property(node, "fulcrum_role");
        light->marked_material = property(node, "fulcrum_material");
        model.lights.push_back(std::move(*light));
      }
      add(node.children, X_MN);
    }
    model.parts = std::move(parts_);
    if (!file_.animations.empty()) told_.insert(NotDrawn::animations);
    for (const NotDrawn kind : told_) model.left_out.emplace_back(clause_about(kind));
  }

  // Of each part; how large it is, is the mean of three directions.
  const std::vector<PartFacts>& facts() const { return facts_; }

private:
  const tinygltf::Node& visit(int index) {
    if (index < 0 || static_cast<std::size_t>(index) >= file_.nodes.size())
      throw GltfFault("it refers to a node that it does not hold; export it again");
    const auto i = static_cast<std::size_t>(index);
    if (seen_[i]) throw GltfFault("a node has two parents or is its own ancestor; export it again");
    seen_[i] = true;
    return file_.nodes[i];
  }

  void add_mesh(const tinygltf::Node& node, const Eigen::Affine3d& X_MN) {
    if (static_cast<std::size_t>(node.mesh) >= file_.meshes.size()) {
      throw GltfFault("node " + name_in_quotes(node.name) +
                      " refers to a mesh that the file does not hold; export it again");
    }
    const tinygltf::Mesh& mesh = file_.meshes[static_cast<std::size_t>(node.mesh)];
    for (const tinygltf::Primitive& primitive : mesh.primitives) {
      const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
      if (mode < TINYGLTF_MODE_TRIANGLES) {
        told_.insert(mode == TINYGLTF_MODE_POINTS ? NotDrawn::points : NotDrawn::lines);
        continue;
      }
      if (mode != TINYGLTF_MODE_TRIANGLES)
        throw GltfFault("a mesh is made of triangle strips or fans; export it as plain triangles");
      ModelPart part = part_from(file_, primitive);
      vertices_ += vertex_count(primitive);
      if (vertices_ > kMaxVertices)
        throw GltfFault("its nodes show more than 150 million vertices; simplify it before export");
      part.name = plain_text(node.name.empty() ? mesh.name : node.name);
      part.marked_role = property(node, "fulcrum_role");
      part.marked_material = property(node, "fulcrum_material");
      indices_ += part.indices.size();
      if (indices_ > kMaxIndices)
        throw GltfFault("it shows more than 50 million triangles; simplify it before export");
      if (!primitive.targets.empty()) told_.insert(NotDrawn::targets);
      if (node.skin >= 0) told_.insert(NotDrawn::skins);
      place(part, X_MN);
      parts_.push_back(std::move(part));
      facts_.push_back(
          {math::cbrt(std::abs(X_MN.linear().determinant())),
           {primitive.attributes.contains("TEXCOORD_0"), primitive.attributes.contains("TEXCOORD_1")}});
    }
  }

  // That were read for it, used or not.
  std::size_t vertex_count(const tinygltf::Primitive& primitive) const {
    return file_.accessors[static_cast<std::size_t>(primitive.attributes.at("POSITION"))].count;
  }

  const tinygltf::Model& file_;
  std::vector<bool> seen_;
  std::vector<ModelPart> parts_;
  std::vector<PartFacts> facts_;
  std::set<NotDrawn> told_;
  std::size_t indices_ = 0, vertices_ = 0;
};

}  // namespace

Model model_from_gltf(const tinygltf::Model& file, const std::vector<std::string>& why_unread) {
  Model model;
  Walk walk(file);
  walk.read(model);
  if (model.parts.empty()) throw GltfFault("it holds no triangles; export it with its meshes, as triangles");
  read_materials(file, walk.facts(), why_unread, model);
  return model;
}

}  // namespace fulcrum
