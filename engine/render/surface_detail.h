#pragma once
// What a surface has beyond one colour, one metallic and one roughness: pictures laid onto it, holes,
// transparency and the layers of glTF 2.0's material extensions, in plain data.

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum::render {

// A picture, row by row from the top.
struct Texture {
  std::string name;
  std::uint32_t width = 1, height = 1;  // pixels, at most 8192
  std::vector<std::uint8_t> rgba;       // (4 x width x height)
  bool srgb = false;                    // red, green and blue are sRGB encoded, alpha never
  bool holes = false;  // where alpha is 0 there is no colour: none of it is mixed into others
  // Where alpha is less, there is nothing: mip_chain() makes it 1 / 2 there. None: it is what it is.
  std::optional<float> cut_off{};
};

enum class Wrap { repeat, mirror, clamp };

// A texture on a surface: its coordinates are turn * uv + shift, (0, 0) at the picture's top left.
struct TextureLayer {
  std::size_t texture = 0;  // index into VisualDesc::textures
  int uv_set = 0;           // 0: xy of Mesh::uv, 1: zw
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
  bool nearest = false;  // texels are seen as squares
  glm::mat2 turn{1.0F};
  glm::vec2 shift{0.0F};
};

enum class Alpha {
  opaque,
  mask,  // it is there where alpha reaches the cut-off
  blend  // drawn over what is behind, the farthest first, and throws no shadow
};

// Numbers are times what the textures have. Colours linear.
struct SurfaceDetail {
  enum Kind : std::size_t { base_colour, metal_rough, normal, occlusion, emissive };
  static constexpr std::size_t kKinds = 5;

  std::array<std::optional<TextureLayer>, kKinds> layers;
  float normal_scale = 1.0F;
  float occlusion_strength = 1.0F;
  glm::vec3 emission{0.0F};  // radiance
  float opacity = 1.0F;
  Alpha alpha = Alpha::opaque;
  float alpha_cutoff = 0.5F;
  bool double_sided = false;
  bool unlit = false;      // the base colour is what is seen
  glm::vec3 f0{0.04F};     // of its dielectric part, at normal incidence
  float f90 = 1.0F;        // the same at grazing incidence
  float clearcoat = 0.0F;  // of a coat of n = 1.5
  float clearcoat_roughness = 0.0F;
  glm::vec3 sheen{0.0F};  // of fibres
  float sheen_roughness = 0.0F;
  float transmission = 0.0F;  // what is behind is seen through it, unbent
  glm::vec3 passed{1.0F};     // the part of that which its thickness lets through
  // m, of light that spreads below it: d of Burley's profile (scatter_taps.h)
  glm::vec3 scatter_distance{0.0F};
};

}  // namespace fulcrum::render
