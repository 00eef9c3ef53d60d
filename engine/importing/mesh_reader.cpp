#include "engine/importing/mesh_reader.h"

#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>

#include "engine/assets/gltf.h"
#include "engine/importing/ending_files.h"
#include "engine/importing/left_out.h"

namespace fulcrum::importing {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxCorners = 150'000'000;
constexpr std::uintmax_t kMaxBytes = std::uintmax_t{4} << 30;
constexpr double kCrease_deg = 40;  // sharper edges are drawn sharp, where the file has no normals

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

// The line among the first of the file that speaks of units, as a person would find it: in a comment of an
// OBJ or PLY file, in the header of an STL file.
std::string line_about_units(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string head(4096, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(stream.gcount()));
  for (char& c : head)
    if (!std::isprint(static_cast<unsigned char>(c))) c = '\n';
  std::size_t begin = 0;
  while (begin < head.size()) {
    const std::size_t end = std::min(head.find('\n', begin), head.size());
    const std::string line = head.substr(begin, end - begin);
    if (lower(line).find("unit") != std::string::npos) return line.substr(0, 120);
    begin = end + 1;
  }
  return {};
}

Vec3 widened(const aiVector3D& v) {
  return {v.x, v.y, v.z};
}

// Colours that were chosen on a screen: IEC 61966-2-1.
double linear(double screen) {
  const double c = std::clamp(screen, 0.0, 1.0);
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

ModelMaterial material_from(const aiMaterial& source, std::size_t& images) {
  ModelMaterial material;
  material.name = source.GetName().C_Str();
  aiColor4D colour;
  const bool has_colour = source.Get(AI_MATKEY_BASE_COLOR, colour) == aiReturn_SUCCESS ||
                          source.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == aiReturn_SUCCESS;
  if (has_colour)
    material.base_colour = {static_cast<float>(linear(colour.r)), static_cast<float>(linear(colour.g)),
                            static_cast<float>(linear(colour.b))};
  float number = 0;
  if (source.Get(AI_MATKEY_METALLIC_FACTOR, number) == aiReturn_SUCCESS)
    material.metallic = std::clamp(number, 0.0F, 1.0F);
  if (source.Get(AI_MATKEY_ROUGHNESS_FACTOR, number) == aiReturn_SUCCESS)
    material.roughness = std::clamp(number, 0.0F, 1.0F);
  for (unsigned int type = aiTextureType_DIFFUSE; type <= AI_TEXTURE_TYPE_MAX; ++type)
    images += source.GetTextureCount(static_cast<aiTextureType>(type));
  return material;
}

// Vertices that are the same to the last bit are one: readers give each triangle its own.
class Joined {
public:
  Joined(const aiMesh& mesh, ModelPart& part) : mesh_(mesh), part_(part) {}

  std::uint32_t add(unsigned int i) {
    const Vec3 p = widened(mesh_.mVertices[i]);
    const Vec3 n = mesh_.HasNormals() ? widened(mesh_.mNormals[i]) : Vec3(Vec3::UnitY());
    Vec3 c = Vec3::Ones();
    if (mesh_.HasVertexColors(0)) {
      const aiColor4D& colour = mesh_.mColors[0][i];
      c = Vec3(linear(colour.r), linear(colour.g), linear(colour.b));
    }
    const auto key = std::tuple(p.x(), p.y(), p.z(), n.x(), n.y(), n.z(), c.x(), c.y(), c.z());
    const auto [entry, is_new] = known_.try_emplace(key, static_cast<std::uint32_t>(part_.positions.size()));
    if (is_new) {
      part_.positions.push_back(p);
      part_.normals.push_back(n);
      if (mesh_.HasVertexColors(0)) part_.colours.push_back(c);
    }
    return entry->second;
  }

private:
  using Key = std::tuple<double, double, double, double, double, double, double, double, double>;
  const aiMesh& mesh_;
  ModelPart& part_;
  std::map<Key, std::uint32_t> known_;
};

// Absent: a corner is no finite number.
bool take_part(const aiMesh& mesh, const aiNode& node, const aiMatrix4x4& X_FN, Model& model) {
  ModelPart part;
  // 3DS numbers its meshes and names their nodes.
  part.name = std::isalpha(static_cast<unsigned char>(mesh.mName.C_Str()[0])) ? mesh.mName.C_Str()
                                                                              : node.mName.C_Str();
  if (part.name.empty()) part.name = "part " + std::to_string(model.parts.size() + 1);
  part.material = mesh.mMaterialIndex;
  Joined joined(mesh, part);
  for (unsigned int f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    if (face.mNumIndices != 3) continue;
    for (unsigned int k = 0; k < 3; ++k) {
      const aiVector3D& p = mesh.mVertices[face.mIndices[k]];
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return false;
      part.indices.push_back(joined.add(face.mIndices[k]));
    }
  }
  Eigen::Affine3d X;
  for (unsigned int row = 0; row < 4; ++row)
    for (unsigned int column = 0; column < 4; ++column)
      X.matrix()(row, column) = static_cast<double>(X_FN[row][column]);
  if (!X.matrix().allFinite() || X.linear().determinant() == 0) return false;
  if (!part.indices.empty()) {
    transform(part, X);
    model.parts.push_back(std::move(part));
  }
  return true;
}

std::string take_nodes(const aiScene& scene, Model& model) {
  std::vector<std::pair<const aiNode*, aiMatrix4x4>> waiting{{scene.mRootNode, aiMatrix4x4()}};
  std::size_t corners = 0;
  while (!waiting.empty()) {
    const auto [node, X_FP] = waiting.back();
    waiting.pop_back();
    const aiMatrix4x4 X_FN = X_FP * node->mTransformation;
    for (unsigned int i = 0; i < node->mNumMeshes; ++i) {
      const aiMesh& mesh = *scene.mMeshes[node->mMeshes[i]];
      corners += std::size_t{3} * mesh.mNumFaces;
      if (corners > kMaxCorners) return "it has more than 50 million triangles: simplify it before export";
      if (!take_part(mesh, *node, X_FN, model))
        return "a corner or a transform in it is not made of finite numbers: export it again";
    }
    for (unsigned int i = node->mNumChildren; i-- > 0;) waiting.emplace_back(node->mChildren[i], X_FN);
  }
  return model.parts.empty() ? "it holds no triangles: export it with its surfaces, as triangles" : "";
}

// m for one unit, where the file's own figures say so.
std::optional<double> unit_in_figures(const aiScene& scene) {
  double factor = 0;  // cm, of FBX
  float single = 0;
  if (scene.mMetaData == nullptr) return std::nullopt;
  if (scene.mMetaData->Get("UnitScaleFactor", factor) && factor > 0) return 0.01 * factor;
  if (scene.mMetaData->Get("UnitScaleFactor", single) && single > 0)
    return 0.01 * static_cast<double>(single);
  return std::nullopt;
}

// Each name once, of the materials that a part is made of: a file may hold others. left_out: of each.
std::vector<std::string> left_out_of_parts(const Model& model,
                                           const std::vector<std::vector<std::string>>& left_out) {
  std::vector<std::string> names;
  for (const ModelPart& part : model.parts)
    for (const std::string& name : left_out[part.material])
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  return names;
}

Result<ReadMesh> read_gltf(const fs::path& file) {
  auto model = load_gltf(fs::absolute(file).parent_path(), fs::absolute(file));
  if (!model) return model.error();
  const std::size_t images = model->images.size(), lights = model->lights.size();
  std::vector<std::vector<std::string>> left_out;
  for (const ModelMaterial& material : model->materials)
    left_out.push_back(material.detail ? left_out_of(*material.detail) : std::vector<std::string>{});
  std::vector<std::string> names = left_out_of_parts(*model, left_out);
  return ReadMesh{.model = std::move(*model),
                  .format = "glTF",
                  .said_of_unit = {},
                  .unit_m = 1.0,
                  .y_is_up = true,
                  .images = images,
                  .lights = lights,
                  .materials_left_out = std::move(names)};
}

}  // namespace

Result<ReadMesh> read_mesh(const fs::path& file) {
  const auto refused = [&](const std::string& why) { return Error{file.string() + ": " + why + "."}; };
  std::error_code fault;
  const auto bytes = fs::file_size(file, fault);
  if (fault) return refused(fault.message() + ": name a mesh file that can be read");
  if (bytes > kMaxBytes) return refused("it is larger than 4 GB: simplify it before export");
  const std::string extension = lower(file.extension().string());
  if (extension == ".glb" || extension == ".gltf") return read_gltf(file);

  Assimp::Importer importer;
  importer.SetIOHandler(new EndingFiles);  // which the importer owns
  if (!importer.IsExtensionSupported(extension))
    return refused("no format is known by '" + extension +
                   "': export it as OBJ, STL, PLY, 3DS or glTF (of a CAD program, STL or OBJ)");
  // STL has a normal for each triangle, which says no more than its corners, and is often wrong; of 3DS the
  // reader makes some that are round at every edge.
  const bool drops_normals = extension == ".stl" || extension == ".3ds";
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, static_cast<float>(kCrease_deg));
  if (drops_normals) importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, aiComponent_NORMALS);
  const unsigned int steps = aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_GenSmoothNormals |
                             (drops_normals ? aiProcess_RemoveComponent : 0U);
  const aiScene* scene = importer.ReadFile(file.string(), steps);
  if (scene == nullptr || scene->mRootNode == nullptr || (scene->mFlags & AI_SCENE_FLAGS_INCOMPLETE) != 0)
    return refused("it cannot be read (" + std::string(importer.GetErrorString()) +
                   "): it is damaged, or not what its name says; export it again");
  ReadMesh read;
  read.format = upper(extension.substr(1));
  read.said_of_unit = line_about_units(file);
  read.unit_m = unit_in_figures(*scene);
  read.lights = scene->mNumLights;
  read.y_is_up = extension == ".3ds" || extension == ".dae" || extension == ".fbx";
  std::vector<std::vector<std::string>> left_out;
  for (unsigned int i = 0; i < scene->mNumMaterials; ++i) {
    read.model.materials.push_back(material_from(*scene->mMaterials[i], read.images));
    left_out.push_back(left_out_of(*scene->mMaterials[i]));
  }
  if (read.model.materials.empty()) read.model.materials.push_back({});
  left_out.resize(read.model.materials.size());
  if (const std::string why = take_nodes(*scene, read.model); !why.empty()) return refused(why);
  read.materials_left_out = left_out_of_parts(read.model, left_out);
  return read;
}

}  // namespace fulcrum::importing
