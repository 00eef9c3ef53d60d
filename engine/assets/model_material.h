#pragma once
// What a model's surface is made of, as glTF 2.0 and its extensions say it (registry.khronos.org/glTF). A
// material without a detail is metal-rough in one colour.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum {

// A picture as its file has it, PNG or JPEG; decoded by decode_image().
struct ModelImage {
  std::string name;
  std::vector<std::uint8_t> encoded;
};

enum class TextureWrap { repeat, mirror, clamp };

// One picture laid onto a surface.
struct TextureUse {
  std::size_t image = 0;  // into Model::images
  int uv_set = 0;         // 0 or 1, of ModelPart::uv
  TextureWrap wrap_u = TextureWrap::repeat, wrap_v = TextureWrap::repeat;
  bool nearest = false;  // texels are seen as squares
  // KHR_texture_transform: u' = offset + turn(rotation) (scale * u)
  std::array<float, 2> offset{0, 0}, scale{1, 1};
  float rotation = 0;  // rad

  bool operator==(const TextureUse&) const = default;
};

enum class AlphaMode {
  opaque,
  mask,  // it is there where alpha reaches the cut-off
  blend  // what is behind is seen through it
};

// All colours linear; factors times what the pictures have.
struct MaterialDetail {
  std::optional<TextureUse> base_colour;  // sRGB and alpha
  std::optional<TextureUse> metal_rough;  // green roughness, blue metallic
  std::optional<TextureUse> normal;       // tangent space
  std::optional<TextureUse> occlusion;    // red
  std::optional<TextureUse> emissive;     // sRGB
  float normal_scale = 1;
  float occlusion_strength = 1;
  std::array<float, 3> emission{0, 0, 0};  // with KHR_materials_emissive_strength
  float alpha = 1;
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
  bool double_sided = false;
  bool unlit = false;                             // KHR_materials_unlit
  float ior = 1.5f;                               // KHR_materials_ior; 0: without end, all is mirrored
  float specular = 1;                             // KHR_materials_specular
  std::array<float, 3> specular_colour{1, 1, 1};  // the same
  float clearcoat = 0, clearcoat_roughness = 0;   // KHR_materials_clearcoat
  std::array<float, 3> sheen{0, 0, 0};            // KHR_materials_sheen
  float sheen_roughness = 0;
  float transmission = 0;  // KHR_materials_transmission: what is behind is seen through it
  std::array<float, 3> passed{1, 1,
                              1};  // KHR_materials_volume: the part of that which its thickness lets through

  bool operator==(const MaterialDetail&) const = default;
};

struct ModelMaterial {
  std::string name;
  std::array<float, 3> base_colour{0.8f, 0.8f, 0.8f};  // linear RGB
  float metallic = 0.0f;                               // 0 to 1
  float roughness = 0.6f;                              // 0 to 1
  std::optional<MaterialDetail> detail{};              // none: there is no more to it
};

}  // namespace fulcrum
