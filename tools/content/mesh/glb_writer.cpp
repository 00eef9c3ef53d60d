#include "tools/content/mesh/glb_writer.h"

#include <cstdio>
#include <filesystem>
#include <iostream>

#include "engine/assets/gltf_builder.h"
#include "tools/content/mesh/shading.h"

namespace fulcrum::content {
namespace {

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

void add(tinygltf::Model& gltf, const Part& part) {
  const ShadedMesh shaded =
      part.coat.normals.empty() ? shade(part.solid, part.crease, part.coat.colours) : coated(part);
  add_part(gltf, {part.name, static_cast<int>(part.material), shaded.positions, shaded.normals,
                  shaded.colours, shaded.indices});
}

}  // namespace

std::string write_glb(const Model& model, const std::string& path, const std::string& program) {
  tinygltf::Model gltf = empty_gltf(model.name, "Fulcrum " + program);
  for (const Material& material : model.materials)
    gltf.materials.push_back(
        gltf_material(material.name, material.base_colour, material.metallic, material.roughness));
  for (const Part& part : model.parts) add(gltf, part);

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
