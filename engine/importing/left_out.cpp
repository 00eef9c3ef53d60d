#include "engine/importing/left_out.h"

#include <algorithm>
#include <array>

namespace fulcrum::importing {
namespace {

constexpr const char *kOpacity = "opacity", *kTransmission = "transmission", *kEmission = "emission",
                     *kClearcoat = "clearcoat", *kSheen = "sheen";

float number_of(const aiMaterial& material, const char* key, unsigned int type, unsigned int index,
                float otherwise) {
  float number = otherwise;
  material.Get(key, type, index, number);
  return number;
}

bool has_colour(const aiMaterial& material, const char* key, unsigned int type, unsigned int index) {
  aiColor3D colour;
  return material.Get(key, type, index, colour) == aiReturn_SUCCESS && !colour.IsBlack();
}

bool is_some(const std::array<float, 3>& colour) {
  return std::ranges::any_of(
      colour, [](float part) { return part > 0; });
}

}  // namespace

std::vector<std::string> left_out_of(const aiMaterial& material) {
  std::vector<std::string> names;
  const auto note = [&](bool is_there, const char* name) {
    if (is_there) names.emplace_back(name);
  };
  note(number_of(material, AI_MATKEY_OPACITY, 1) < 1 || material.GetTextureCount(aiTextureType_OPACITY) > 0,
       kOpacity);
  note(number_of(material, AI_MATKEY_TRANSMISSION_FACTOR, 0) > 0, kTransmission);
  note((has_colour(material, AI_MATKEY_COLOR_EMISSIVE) &&
        number_of(material, AI_MATKEY_EMISSIVE_INTENSITY, 1) > 0) ||
           material.GetTextureCount(aiTextureType_EMISSIVE) > 0 ||
           material.GetTextureCount(aiTextureType_EMISSION_COLOR) > 0,
       kEmission);
  // Of J. F. Blinn's and B. T. Phong's models, which have it in place of a roughness.
  float roughness = 0;
  note(material.Get(AI_MATKEY_ROUGHNESS_FACTOR, roughness) != aiReturn_SUCCESS &&
           number_of(material, AI_MATKEY_SHININESS, 0) > 0 && has_colour(material, AI_MATKEY_COLOR_SPECULAR),
       "shininess");
  note(number_of(material, AI_MATKEY_CLEARCOAT_FACTOR, 0) > 0, kClearcoat);
  note(has_colour(material, AI_MATKEY_SHEEN_COLOR_FACTOR), kSheen);
  return names;
}

std::vector<std::string> left_out_of(const MaterialDetail& material) {
  const MaterialDetail plain;
  std::vector<std::string> names;
  const auto note = [&](bool is_there, const char* name) {
    if (is_there) names.emplace_back(name);
  };
  note(material.alpha_mode != AlphaMode::opaque, kOpacity);
  note(material.transmission > 0, kTransmission);
  note(is_some(material.emission), kEmission);
  note(material.ior != plain.ior, "index of refraction");
  note(material.specular != plain.specular || material.specular_colour != plain.specular_colour, "specular");
  note(material.clearcoat > 0, kClearcoat);
  note(is_some(material.sheen), kSheen);
  note(material.unlit, "unlit colour");
  note(material.double_sided, "visible back faces");
  return names;
}

}  // namespace fulcrum::importing
