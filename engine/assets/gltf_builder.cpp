#include "engine/assets/gltf_builder.h"

#include <algorithm>

namespace fulcrum {
namespace {

// target: what a view is for, or 0.
template <typename Item>
int add_view(tinygltf::Model& gltf, const std::vector<Item>& items, int target) {
  std::vector<unsigned char>& bytes = gltf.buffers[0].data;
  bytes.resize((bytes.size() + 3) / 4 * 4);  // accessors begin at multiples of their components' size
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = bytes.size();
  view.byteLength = items.size() * sizeof(Item);
  view.target = target;
  bytes.resize(view.byteOffset + view.byteLength);
  std::copy_n(reinterpret_cast<const unsigned char*>(items.data()), view.byteLength,
              bytes.data() + view.byteOffset);
  gltf.bufferViews.push_back(view);
  return static_cast<int>(gltf.bufferViews.size() - 1);
}

int add_vectors(tinygltf::Model& gltf, const std::vector<Eigen::Vector3f>& vectors) {
  static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float));
  Eigen::Vector3f low = vectors.front();
  Eigen::Vector3f high = vectors.front();
  for (const Eigen::Vector3f& v : vectors) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  tinygltf::Accessor accessor;
  accessor.bufferView = add_view(gltf, vectors, TINYGLTF_TARGET_ARRAY_BUFFER);
  accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
  accessor.count = vectors.size();
  accessor.type = TINYGLTF_TYPE_VEC3;
  for (int k = 0; k < 3; ++k) {
    accessor.minValues.push_back(low[k]);
    accessor.maxValues.push_back(high[k]);
  }
  gltf.accessors.push_back(accessor);
  return static_cast<int>(gltf.accessors.size() - 1);
}

template <int n>
int add_floats(tinygltf::Model& gltf, const std::vector<Eigen::Matrix<float, n, 1>>& rows, int type) {
  static_assert(sizeof(Eigen::Matrix<float, n, 1>) == n * sizeof(float));
  tinygltf::Accessor accessor;
  accessor.bufferView = add_view(gltf, rows, TINYGLTF_TARGET_ARRAY_BUFFER);
  accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
  accessor.count = rows.size();
  accessor.type = type;
  gltf.accessors.push_back(accessor);
  return static_cast<int>(gltf.accessors.size() - 1);
}

int add_indices(tinygltf::Model& gltf, const std::vector<std::uint32_t>& indices) {
  tinygltf::Accessor accessor;
  accessor.bufferView = add_view(gltf, indices, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  accessor.count = indices.size();
  accessor.type = TINYGLTF_TYPE_SCALAR;
  gltf.accessors.push_back(accessor);
  return static_cast<int>(gltf.accessors.size() - 1);
}

}  // namespace

tinygltf::Model empty_gltf(const std::string& name, const std::string& generator) {
  tinygltf::Model gltf;
  gltf.asset.version = "2.0";
  gltf.asset.generator = generator;
  gltf.buffers.emplace_back();
  gltf.scenes.emplace_back();
  gltf.scenes[0].name = name;
  gltf.defaultScene = 0;
  return gltf;
}

tinygltf::Material gltf_material(const std::string& name, const std::array<double, 3>& base_colour,
                                 double metallic, double roughness) {
  tinygltf::Material material;
  material.name = name;
  const auto& c = base_colour;
  material.pbrMetallicRoughness.baseColorFactor = {c[0], c[1], c[2], 1.0};
  material.pbrMetallicRoughness.metallicFactor = metallic;
  material.pbrMetallicRoughness.roughnessFactor = roughness;
  return material;
}

int add_picture(tinygltf::Model& gltf, const std::string& name, const std::vector<std::uint8_t>& png) {
  tinygltf::Image image;
  image.name = name;
  image.mimeType = "image/png";
  image.bufferView = add_view(gltf, png, 0);
  gltf.images.push_back(image);
  tinygltf::Texture texture;
  texture.source = static_cast<int>(gltf.images.size() - 1);
  gltf.textures.push_back(texture);
  return static_cast<int>(gltf.textures.size() - 1);
}

void add_part(tinygltf::Model& gltf, const GltfPart& part) {
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  primitive.material = part.material;
  primitive.attributes["POSITION"] = add_vectors(gltf, part.positions);
  primitive.attributes["NORMAL"] = add_vectors(gltf, part.normals);
  if (!part.colours.empty()) primitive.attributes["COLOR_0"] = add_vectors(gltf, part.colours);
  if (!part.uv.empty()) primitive.attributes["TEXCOORD_0"] = add_floats<2>(gltf, part.uv, TINYGLTF_TYPE_VEC2);
  if (!part.tangents.empty())
    primitive.attributes["TANGENT"] = add_floats<4>(gltf, part.tangents, TINYGLTF_TYPE_VEC4);
  primitive.indices = add_indices(gltf, part.indices);
  tinygltf::Mesh mesh;
  mesh.name = part.name;
  mesh.primitives.push_back(primitive);
  gltf.meshes.push_back(mesh);

  tinygltf::Node node;
  node.name = part.name;
  node.mesh = static_cast<int>(gltf.meshes.size() - 1);
  gltf.nodes.push_back(node);
  gltf.scenes[0].nodes.push_back(static_cast<int>(gltf.nodes.size() - 1));
}

}  // namespace fulcrum
