#include "tools/content/mesh/glb_writer.h"

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iostream>

#include <tiny_gltf.h>

#include "tools/content/mesh/shading.h"

namespace fulcrum::content {
namespace {

template <typename Item>
int add_view(tinygltf::Model* gltf, const std::vector<Item>& items, int target) {
  std::vector<unsigned char>& bytes = gltf->buffers[0].data;
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = bytes.size();
  view.byteLength = items.size() * sizeof(Item);
  view.target = target;
  bytes.resize(view.byteOffset + view.byteLength);
  std::memcpy(bytes.data() + view.byteOffset, items.data(), view.byteLength);
  gltf->bufferViews.push_back(view);
  return static_cast<int>(gltf->bufferViews.size() - 1);
}

int add_vectors(tinygltf::Model* gltf, const std::vector<Eigen::Vector3f>& vectors) {
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
  gltf->accessors.push_back(accessor);
  return static_cast<int>(gltf->accessors.size() - 1);
}

int add_indices(tinygltf::Model* gltf, const std::vector<std::uint32_t>& indices) {
  tinygltf::Accessor accessor;
  accessor.bufferView = add_view(gltf, indices, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  accessor.count = indices.size();
  accessor.type = TINYGLTF_TYPE_SCALAR;
  gltf->accessors.push_back(accessor);
  return static_cast<int>(gltf->accessors.size() - 1);
}

std::vector<Eigen::Vector3f> narrowed(const std::vector<Eigen::Vector3d>& vectors) {
  std::vector<Eigen::Vector3f> result;
  result.reserve(vectors.size());
  for (const Eigen::Vector3d& v : vectors) result.push_back(v.cast<float>());
  return result;
}

ShadedMesh coated(const Part& part) {
  ShadedMesh mesh{.positions = narrowed(part.solid.points),
                  .normals = narrowed(part.coat.normals),
                  .colours = narrowed(part.coat.colours),
                  .indices = {}};
  for (const Triangle& t : part.solid.triangles) mesh.indices.insert(mesh.indices.end(), t.begin(), t.end());
  return mesh;
}

tinygltf::Material gltf_material(const Material& material) {
  tinygltf::Material result;
  result.name = material.name;
  const auto& c = material.base_colour;
  result.pbrMetallicRoughness.baseColorFactor = {c[0], c[1], c[2], 1.0};
  result.pbrMetallicRoughness.metallicFactor = material.metallic;
  result.pbrMetallicRoughness.roughnessFactor = material.roughness;
  return result;
}

void add_part(tinygltf::Model* gltf, const Part& part) {
  const ShadedMesh shaded =
      part.coat.normals.empty() ? shade(part.solid, part.crease, part.coat.colours) : coated(part);
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  primitive.material = static_cast<int>(part.material);
  primitive.attributes["POSITION"] = add_vectors(gltf, shaded.positions);
  primitive.attributes["NORMAL"] = add_vectors(gltf, shaded.normals);
  if (!shaded.colours.empty()) primitive.attributes["COLOR_0"] = add_vectors(gltf, shaded.colours);
  primitive.indices = add_indices(gltf, shaded.indices);
  tinygltf::Mesh mesh;
  mesh.name = part.name;
  mesh.primitives.push_back(primitive);
  gltf->meshes.push_back(mesh);

  tinygltf::Node node;
  node.name = part.name;
  node.mesh = static_cast<int>(gltf->meshes.size() - 1);
  gltf->nodes.push_back(node);
  gltf->scenes[0].nodes.push_back(static_cast<int>(gltf->nodes.size() - 1));
}

}  // namespace

std::string write_glb(const Model& model, const std::string& path, const std::string& program) {
  tinygltf::Model gltf;
  gltf.asset.version = "2.0";
  gltf.asset.generator = "Fulcrum " + program;
  gltf.buffers.emplace_back();
  gltf.scenes.emplace_back();
  gltf.scenes[0].name = model.name;
  gltf.defaultScene = 0;
  for (const Material& material : model.materials) gltf.materials.push_back(gltf_material(material));
  for (const Part& part : model.parts) add_part(&gltf, part);

  constexpr bool embed_images = true;
  constexpr bool embed_buffers = true;
  constexpr bool pretty = false;
  constexpr bool binary = true;
  tinygltf::TinyGLTF writer;
  if (!writer.WriteGltfSceneToFile(&gltf, path, embed_images, embed_buffers, pretty, binary))
    return "cannot write " + path;
  return {};
}

bool write_models(const std::vector<Model>& models, const std::string& folder, const std::string& program) {
  std::error_code ignored;  // writing says what is wrong
  std::filesystem::create_directories(folder, ignored);
  for (const Model& model : models) {
    const std::string trouble = write_glb(model, folder + "/" + model.name + ".glb", program);
    if (!trouble.empty()) {
      std::cerr << trouble << "\n";
      return false;
    }
    std::printf("%s: {parts: %zu, triangles: %zu}\n", model.name.c_str(), model.parts.size(),
                triangle_count(model));
  }
  return true;
}

}  // namespace fulcrum::content
