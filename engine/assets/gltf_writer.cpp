#include "engine/assets/gltf_writer.h"

#include <sstream>

#include "engine/assets/gltf_builder.h"

namespace fulcrum {
namespace {

std::vector<Eigen::Vector3f> single(const std::vector<Vec3>& vectors) {
  std::vector<Eigen::Vector3f> result;
  result.reserve(vectors.size());
  for (const Vec3& v : vectors) result.push_back(v.cast<float>());
  return result;
}

}  // namespace

std::string to_glb(const Model& model, const std::string& name, const std::string& generator) {
  tinygltf::Model gltf = empty_gltf(name, generator);
  for (const ModelMaterial& material : model.materials) {
    const auto& c = material.base_colour;
    gltf.materials.push_back(
        gltf_material(material.name, {c[0], c[1], c[2]}, material.metallic, material.roughness));
  }
  for (const ModelPart& part : model.parts) {
    if (part.indices.empty()) continue;
    add_part(gltf, {part.name,
                    static_cast<int>(part.material),
                    single(part.positions),
                    single(part.normals),
                    single(part.colours),
                    part.indices,
                    {},
                    {}});
  }
  std::ostringstream bytes;
  tinygltf::TinyGLTF().WriteGltfSceneToStream(&gltf, bytes, false, true);
  return std::move(bytes).str();
}

}  // namespace fulcrum
