#include "tools/content/mesh/glb_writer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <map>
#include <utility>

#include "engine/assets/gltf_builder.h"
#include "tools/content/mesh/raster.h"
#include "tools/content/mesh/shading.h"
#include "tools/content/mesh/tangents.h"

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

// How much a surface with that normal faces the projector: 1 if it looks into it.
double facing(const Projection& projection, const Eigen::Vector3f& normal) {
  return projection.along_v.cross(projection.along_u).normalized().dot(normal.cast<double>());
}

std::vector<Eigen::Vector2f> projected(const ShadedMesh& mesh, const std::vector<Projection>& projections) {
  std::vector<Eigen::Vector2f> uv;
  if (projections.empty()) return uv;
  uv.reserve(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Projection& projection = *std::ranges::max_element(projections, {}, [&](const Projection& each) {
      // What looks between two of them is the same one's everywhere, however its normal is rounded.
      return std::round(1e3 * facing(each, mesh.normals[i]));
    });
    const Eigen::Vector3d p = mesh.positions[i].cast<double>() - projection.origin;
    uv.emplace_back(p.dot(projection.along_u), p.dot(projection.along_v));
  }
  return uv;
}

void add(tinygltf::Model& gltf, const Part& part, const Material& material) {
  ShadedMesh shaded =
      part.coat.normals.empty() ? shade(part.solid, part.crease, part.coat.colours) : coated(part);
  const std::vector<Eigen::Vector2f> uv =
      part.uv.empty() ? projected(shaded, part.projections) : split_at_seams(&shaded, part.uv);
  const bool has_relief = material.pictures && material.pictures->normal && !uv.empty();
  add_part(gltf,
           {part.name, static_cast<int>(part.material), shaded.positions, shaded.normals, shaded.colours,
            shaded.indices, uv, has_relief ? tangents(shaded, uv) : std::vector<Eigen::Vector4f>()});
}

using PicturesOfFile = std::map<std::vector<std::uint8_t>, int>;  // their bytes, and which they are

// Materials that look alike but for their colour share their pictures.
void lay_on(tinygltf::Model& gltf, tinygltf::Material& made, const Pictures& pictures,
            PicturesOfFile& pictures_of_file) {
  const auto index_of = [&](const char* what, const Raster& picture) {
    std::vector<std::uint8_t> png = png_of(picture);
    const auto known = pictures_of_file.find(png);
    if (known != pictures_of_file.end()) return known->second;
    const int index = add_picture(gltf, made.name + " " + what, png);
    pictures_of_file.emplace(std::move(png), index);
    return index;
  };
  if (pictures.base_colour)
    made.pbrMetallicRoughness.baseColorTexture.index = index_of("colour", *pictures.base_colour);
  if (pictures.metal_rough)
    made.pbrMetallicRoughness.metallicRoughnessTexture.index = index_of("finish", *pictures.metal_rough);
  if (pictures.normal) made.normalTexture.index = index_of("relief", *pictures.normal);
}

// What no part is made of keeps its name and its numbers alone.
void add_materials(tinygltf::Model& gltf, const Model& model) {
  PicturesOfFile pictures_of_file;
  for (std::size_t i = 0; i < model.materials.size(); ++i) {
    const Material& material = model.materials[i];
    tinygltf::Material made =
        gltf_material(material.name, material.base_colour, material.metallic, material.roughness);
    const bool is_seen = std::ranges::find(model.parts, i, &Part::material) != model.parts.end();
    if (material.pictures && is_seen) lay_on(gltf, made, *material.pictures, pictures_of_file);
    gltf.materials.push_back(made);
  }
}

}  // namespace

std::string write_glb(const Model& model, const std::string& path, const std::string& program) {
  tinygltf::Model gltf = empty_gltf(model.name, "Fulcrum " + program);
  add_materials(gltf, model);
  for (const Part& part : model.parts) add(gltf, part, model.materials[part.material]);

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
