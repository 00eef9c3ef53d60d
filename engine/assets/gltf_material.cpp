#include "engine/assets/gltf_material.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "engine/assets/gltf_accessor.h"
#include "engine/assets/image.h"
#include "engine/files/plain_text.h"
#include "haptics/math/functions.h"

namespace fulcrum {
namespace {

constexpr float kLargestFactor = 1e4F;   // of what may be above one: emission, a texture's scale
constexpr float kLongestLength = 1e12F;  // in the file's unit, which may be a micrometre

float within(double x, float least, float most, float otherwise) {
  return std::isfinite(x) ? std::clamp(static_cast<float>(x), least, most) : otherwise;
}

float fraction(double x) {
  return within(x, 0.0F, 1.0F, 1.0F);
}

float number_in(const tinygltf::Value& object, const char* key, float least, float most, float otherwise) {
  if (!object.IsObject() || !object.Has(key)) return otherwise;
  const tinygltf::Value& value = object.Get(key);
  return value.IsNumber() ? within(value.GetNumberAsDouble(), least, most, otherwise) : otherwise;
}

std::array<float, 3> colour_in(const tinygltf::Value& object, const char* key, std::array<float, 3> otherwise,
                               float most) {
  if (!object.IsObject() || !object.Has(key)) return otherwise;
  const tinygltf::Value& value = object.Get(key);
  for (std::size_t i = 0; i < 3 && value.IsArray() && i < value.ArrayLen(); ++i) {
    const tinygltf::Value& part = value.Get(static_cast<int>(i));
    if (part.IsNumber()) otherwise[i] = within(part.GetNumberAsDouble(), 0.0F, most, otherwise[i]);
  }
  return otherwise;
}

TextureWrap wrap_of(int gltf) {
  switch (gltf) {
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
      return TextureWrap::clamp;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
      return TextureWrap::mirror;
    default:
      return TextureWrap::repeat;
  }
}

constexpr std::size_t kMostTold = 12;     // of what is left out, so that a sentence can be read
constexpr std::size_t kLongestName = 80;  // bytes, of what a file calls something, for the same reason

// What this program draws of extensions; the pictures that some of a material's may have are not drawn.
const std::set<std::string>& drawn_extensions() {
  static const std::set<std::string> known{"KHR_lights_punctual",     "KHR_texture_transform",
                                           "KHR_materials_clearcoat", "KHR_materials_emissive_strength",
                                           "KHR_materials_ior",       "KHR_materials_sheen",
                                           "KHR_materials_specular",  "KHR_materials_transmission",
                                           "KHR_materials_unlit",     "KHR_materials_volume"};
  return known;
}

class MaterialReader {
public:
  MaterialReader(const tinygltf::Model& file, const std::vector<std::string>& why_unread, Model& model)
      : file_(file), why_unread_(why_unread), model_(model) {}

  // facts: of each part.
  void read(const std::vector<PartFacts>& facts) {
    std::vector<bool> is_shown(file_.materials.size() + 1, false);
    for (const ModelPart& part : model_.parts) is_shown[part.material] = true;
    std::set<std::string> of_no_part;
    for (std::size_t i = 0; i < file_.materials.size(); ++i) {
      const tinygltf::Material& material = file_.materials[i];
      model_.materials.push_back(is_shown[i] ? material_from(material) : plain_from(material));
      if (!is_shown[i])
        for (const auto& [extension, value] : material.extensions) of_no_part.insert(extension);
    }
    model_.materials.push_back({});
    for (const std::string& extension : file_.extensionsUsed)
      if (!drawn_extensions().contains(extension) && !of_no_part.contains(extension))
        leave_out(short_text(extension, kLongestName));
    for (const tinygltf::Mesh& mesh : file_.meshes)
      for (const tinygltf::Primitive& primitive : mesh.primitives) tell_of_faint_vertices(primitive);
    size_volumes(facts);
    drop_textures_without_places(facts);
  }

private:
  void leave_out(std::string clause) {
    if (model_.left_out.size() > kMostTold ||
        std::ranges::find(model_.left_out, clause) != model_.left_out.end())
      return;
    if (model_.left_out.size() == kMostTold) clause = "more of that kind";
    model_.left_out.push_back(std::move(clause));
  }

  void tell_of_faint_vertices(const tinygltf::Primitive& primitive) {
    const auto colours = primitive.attributes.find("COLOR_0");
    if (colours == primitive.attributes.end() || primitive.material < 0) return;
    const auto accessor = static_cast<std::size_t>(colours->second);
    const auto material = static_cast<std::size_t>(primitive.material);
    if (colours->second < 0 || accessor >= file_.accessors.size() || material >= file_.materials.size())
      return;
    if (file_.accessors[accessor].type == TINYGLTF_TYPE_VEC4 &&
        (file_.materials[material].alphaMode == "BLEND" || file_.materials[material].alphaMode == "MASK"))
      leave_out("the alpha of vertices (COLOR_0)");
  }

  // The image that a texture shows, kept once; none: it cannot be drawn, which is told.
  std::optional<std::size_t> image_of(int texture) {
    if (texture < 0 || static_cast<std::size_t>(texture) >= file_.textures.size())
      throw GltfFault("a material refers to a texture that the file does not hold; export it again");
    const int source = file_.textures[static_cast<std::size_t>(texture)].source;
    if (source < 0) {
      leave_out("a texture that is neither PNG nor JPEG");
      return std::nullopt;
    }
    if (static_cast<std::size_t>(source) >= file_.images.size())
      throw GltfFault("a texture refers to an image that the file does not hold; export it again");
    if (const auto known = kept_.find(source); known != kept_.end()) return known->second;
    const tinygltf::Image& image = file_.images[static_cast<std::size_t>(source)];
    const std::string number = "number " + std::to_string(source);
    std::string name = short_text(!image.name.empty()  ? image.name
                                  : !image.uri.empty() ? image.uri
                                                       : number,
                                  kLongestName);
    std::optional<std::size_t>& index = kept_[source];
    std::vector<std::uint8_t> encoded =
        image.bufferView >= 0 ? read_bytes(file_, image.bufferView) : image.image;
    if (const std::string& why = why_unread_[static_cast<std::size_t>(source)]; !why.empty()) {
      leave_out("the texture " + (image.uri.empty() ? name : short_text(image.uri, kLongestName)) +
                ", which cannot be read (" + why + "): export the model as .glb, which holds its textures");
    } else if (!is_picture(encoded)) {
      leave_out("the texture " + name + ", which is neither PNG nor JPEG");
    } else {
      index = model_.images.size();
      model_.images.push_back({std::move(name), std::move(encoded)});
    }
    return index;
  }

  std::optional<TextureUse> texture(int index, int uv_set, const tinygltf::ExtensionMap& extensions) {
    if (index < 0) return std::nullopt;
    const std::optional<std::size_t> image = image_of(index);
    if (!image) return std::nullopt;
    TextureUse use{.image = *image, .uv_set = uv_set};
    const int sampler = file_.textures[static_cast<std::size_t>(index)].sampler;
    if (sampler >= 0 && static_cast<std::size_t>(sampler) < file_.samplers.size()) {
      const tinygltf::Sampler& how = file_.samplers[static_cast<std::size_t>(sampler)];
      use.wrap_u = wrap_of(how.wrapS);
      use.wrap_v = wrap_of(how.wrapT);
      use.nearest = how.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
    }
    if (const auto found = extensions.find("KHR_texture_transform"); found != extensions.end())
      transform(use, found->second);
    if (use.uv_set == 0 || use.uv_set == 1) return use;
    leave_out("textures on a third set of coordinates");
    return std::nullopt;
  }

  static void transform(TextureUse& use, const tinygltf::Value& extension) {
    const auto pair = [&](const char* key, std::array<float, 2>& to) {
      if (!extension.IsObject() || !extension.Has(key)) return;
      const tinygltf::Value& value = extension.Get(key);
      for (std::size_t i = 0; i < 2 && value.IsArray() && i < value.ArrayLen(); ++i)
        if (value.Get(static_cast<int>(i)).IsNumber())
          to[i] = within(value.Get(static_cast<int>(i)).GetNumberAsDouble(), -kLargestFactor, kLargestFactor,
                         to[i]);
    };
    pair("offset", use.offset);
    pair("scale", use.scale);
    use.rotation = number_in(extension, "rotation", -kLargestFactor, kLargestFactor, 0.0F);
    if (extension.IsObject() && extension.Has("texCoord") && extension.Get("texCoord").IsInt())
      use.uv_set = extension.Get("texCoord").Get<int>();
  }

  // Without what has to be found elsewhere in the file.
  static ModelMaterial plain_from(const tinygltf::Material& source) {
    const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
    ModelMaterial material;
    material.name = plain_text(source.name);
    for (std::size_t i = 0; i < 3; ++i)
      material.base_colour[i] = i < pbr.baseColorFactor.size() ? fraction(pbr.baseColorFactor[i]) : 1.0F;
    material.metallic = fraction(pbr.metallicFactor);
    material.roughness = fraction(pbr.roughnessFactor);
    return material;
  }

  ModelMaterial material_from(const tinygltf::Material& source) {
    const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
    ModelMaterial material = plain_from(source);
    MaterialDetail detail;
    read_textures(source, detail);
    detail.alpha = pbr.baseColorFactor.size() > 3 ? fraction(pbr.baseColorFactor[3]) : 1.0F;
    if (source.alphaMode == "MASK") detail.alpha_mode = AlphaMode::mask;
    if (source.alphaMode == "BLEND") detail.alpha_mode = AlphaMode::blend;
    if (detail.alpha_mode == AlphaMode::opaque) detail.alpha = 1;
    if (detail.alpha_mode == AlphaMode::mask)
      detail.alpha_cutoff = within(source.alphaCutoff, 0.0F, kLargestFactor, 0.5F);
    detail.double_sided = source.doubleSided;
    read_extensions(source, detail);
    if (detail != MaterialDetail{}) material.detail = detail;
    return material;
  }

  void read_textures(const tinygltf::Material& source, MaterialDetail& detail) {
    const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
    const auto of = [&](const auto& info) { return texture(info.index, info.texCoord, info.extensions); };
    detail.base_colour = of(pbr.baseColorTexture);
    detail.metal_rough = of(pbr.metallicRoughnessTexture);
    if ((detail.normal = of(source.normalTexture)))
      detail.normal_scale = within(source.normalTexture.scale, -kLargestFactor, kLargestFactor, 1.0F);
    if ((detail.occlusion = of(source.occlusionTexture)))
      detail.occlusion_strength = fraction(source.occlusionTexture.strength);
    for (std::size_t i = 0; i < 3 && i < source.emissiveFactor.size(); ++i)
      detail.emission[i] = within(source.emissiveFactor[i], 0.0F, 1.0F, 0.0F);
    if (detail.emission != std::array<float, 3>{0, 0, 0}) detail.emissive = of(source.emissiveTexture);
  }

  void read_extensions(const tinygltf::Material& source, MaterialDetail& detail) {
    static const tinygltf::Value nothing;
    for (const auto& [name, value] : source.extensions)
      if (!drawn_extensions().contains(name)) leave_out(short_text(name, kLongestName));
    const auto get = [&](const char* name) -> const tinygltf::Value& {
      const auto found = source.extensions.find(name);
      if (found == source.extensions.end()) return nothing;
      if (found->second.IsObject())
        for (const std::string& key : found->second.Keys())
          if (key.ends_with("Texture")) leave_out(std::string(name) + "'s own textures");
      return found->second;
    };
    detail.unlit = source.extensions.contains("KHR_materials_unlit");
    const float strength =
        number_in(get("KHR_materials_emissive_strength"), "emissiveStrength", 0.0F, kLargestFactor, 1.0F);
    for (float& part : detail.emission) part *= strength;
    detail.ior = number_in(get("KHR_materials_ior"), "ior", 0.0F, 10.0F, 1.5F);
    if (detail.ior > 0) detail.ior = std::max(detail.ior, 1.0F);
    const tinygltf::Value& specular = get("KHR_materials_specular");
    detail.specular = number_in(specular, "specularFactor", 0.0F, 1.0F, 1.0F);
    detail.specular_colour = colour_in(specular, "specularColorFactor", {1, 1, 1}, kLargestFactor);
    const tinygltf::Value& coat = get("KHR_materials_clearcoat");
    detail.clearcoat = number_in(coat, "clearcoatFactor", 0.0F, 1.0F, 0.0F);
    if (detail.clearcoat > 0)
      detail.clearcoat_roughness = number_in(coat, "clearcoatRoughnessFactor", 0.0F, 1.0F, 0.0F);
    const tinygltf::Value& sheen = get("KHR_materials_sheen");
    detail.sheen = colour_in(sheen, "sheenColorFactor", {0, 0, 0}, 1.0F);
    if (detail.sheen != std::array<float, 3>{0, 0, 0})
      detail.sheen_roughness = number_in(sheen, "sheenRoughnessFactor", 0.0F, 1.0F, 0.0F);
    detail.transmission =
        number_in(get("KHR_materials_transmission"), "transmissionFactor", 0.0F, 1.0F, 0.0F);
    const tinygltf::Value& volume = get("KHR_materials_volume");
    if (detail.transmission > 0) {
      detail.passed = passed_by(volume, 1.0);
      // A volume's far side is part of its thickness, and not another pane.
      if (number_in(volume, "thicknessFactor", 0.0F, kLongestLength, 0.0F) > 0) detail.double_sided = false;
    }
  }

  // What is left of light behind the volume's thickness, which is the file's colour behind its distance. The
  // distance is one in the scene, the thickness one in the mesh, which is `size` times as large there.
  static std::array<float, 3> passed_by(const tinygltf::Value& volume, double size) {
    constexpr float kShortest = 1e-6F;
    const float thickness = number_in(volume, "thicknessFactor", 0.0F, kLongestLength, 0.0F);
    const float distance = number_in(volume, "attenuationDistance", kShortest, kLongestLength, 0.0F);
    if (thickness == 0.0F || distance == 0.0F) return {1, 1, 1};  // a wall, or clear however thick
    std::array<float, 3> passed = colour_in(volume, "attenuationColor", {1, 1, 1}, 1.0F);
    for (float& part : passed)
      part = static_cast<float>(math::pow(
          static_cast<double>(part), size * static_cast<double>(thickness) / static_cast<double>(distance)));
    return passed;
  }

  // Parts of one material that their nodes make smaller or larger differ in how thick they are.
  void size_volumes(const std::vector<PartFacts>& facts) {
    constexpr double kSteps = 1024;  // sizes that differ by less are one: that is seen by nobody
    std::map<std::pair<std::uint32_t, double>, std::uint32_t> made;
    for (std::size_t i = 0; i < model_.parts.size(); ++i) {
      std::uint32_t& material = model_.parts[i].material;
      int exponent = 0;
      const double mantissa = std::frexp(facts[i].size, &exponent);
      const double size = std::ldexp(std::round(mantissa * kSteps) / kSteps, exponent);
      if (size == 1.0 || !std::isfinite(size) || !has_volume(model_.materials[material])) continue;
      const auto [found, is_new] =
          made.try_emplace({material, size}, static_cast<std::uint32_t>(model_.materials.size()));
      if (is_new) {
        model_.materials.push_back(model_.materials[material]);
        model_.materials.back().detail->passed =
            passed_by(file_.materials[material].extensions.at("KHR_materials_volume"), size);
      }
      material = found->second;
    }
  }

  // A mesh that does not say where a texture lies is drawn without it.
  void drop_textures_without_places(const std::vector<PartFacts>& facts) {
    std::map<std::pair<std::uint32_t, std::array<bool, 2>>, std::uint32_t> made;
    for (std::size_t i = 0; i < model_.parts.size(); ++i) {
      std::uint32_t& material = model_.parts[i].material;
      const std::array<bool, 2>& has_uv = facts[i].has_uv;
      const auto [found, is_new] = made.try_emplace({material, has_uv}, material);
      if (is_new) {
        ModelMaterial without = model_.materials[material];
        if (drop_textures(without, has_uv)) {
          found->second = static_cast<std::uint32_t>(model_.materials.size());
          model_.materials.push_back(std::move(without));
        }
      }
      material = found->second;
    }
  }

  // false: it has none to drop.
  bool drop_textures(ModelMaterial& material, const std::array<bool, 2>& has_uv) {
    if (!material.detail) return false;
    MaterialDetail& detail = *material.detail;
    bool dropped = false;
    for (std::optional<TextureUse>* use :
         {&detail.base_colour, &detail.metal_rough, &detail.normal, &detail.occlusion, &detail.emissive}) {
      if (!*use || has_uv[static_cast<std::size_t>((*use)->uv_set)]) continue;
      leave_out("textures on a mesh without their coordinates (TEXCOORD_" + std::to_string((*use)->uv_set) +
                ")");
      use->reset();
      dropped = true;
    }
    if (!detail.normal) detail.normal_scale = 1;
    if (!detail.occlusion) detail.occlusion_strength = 1;
    if (detail == MaterialDetail{}) material.detail.reset();
    return dropped;
  }

  static bool has_volume(const ModelMaterial& material) {
    return material.detail && material.detail->passed != std::array<float, 3>{1, 1, 1};
  }

  const tinygltf::Model& file_;
  const std::vector<std::string>& why_unread_;  // of each image
  Model& model_;
  std::map<int, std::optional<std::size_t>> kept_;  // by the file's image
};

}  // namespace

bool names_pictures(const tinygltf::Model& file, int material) {
  if (material < 0 || static_cast<std::size_t>(material) >= file.materials.size()) return false;
  const tinygltf::Material& of = file.materials[static_cast<std::size_t>(material)];
  const tinygltf::PbrMetallicRoughness& pbr = of.pbrMetallicRoughness;
  return pbr.baseColorTexture.index >= 0 || pbr.metallicRoughnessTexture.index >= 0 ||
         of.normalTexture.index >= 0 || of.occlusionTexture.index >= 0 || of.emissiveTexture.index >= 0;
}

void read_materials(const tinygltf::Model& file, const std::vector<PartFacts>& facts,
                    const std::vector<std::string>& why_unread, Model& model) {
  MaterialReader(file, why_unread, model).read(facts);
}

}  // namespace fulcrum
