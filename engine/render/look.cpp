#include "engine/render/look.h"

#include <array>
#include <vector>

#include "shaders/shared/material.h"

namespace fulcrum::render {

std::optional<std::uint32_t> look_of(const Material& material) {
  if (!material.detail) return std::nullopt;
  const SurfaceDetail& detail = *material.detail;
  std::uint32_t look = 0;
  for (std::size_t i = 0; i < SurfaceDetail::kKinds; ++i)
    if (detail.layers[i]) look |= 1U << i;
  const auto has = [&](bool it, std::uint32_t bit) { look |= it ? bit : 0U; };
  has(detail.emission != glm::vec3(0.0F), FULCRUM_LOOK_EMISSION);
  // Without a picture it is all there, or none of it is.
  has(detail.alpha == Alpha::mask &&
          (detail.layers[SurfaceDetail::base_colour] || detail.opacity < detail.alpha_cutoff),
      FULCRUM_LOOK_MASK);
  // glTF: what is unlit has no other layers, and no light enters metal.
  const bool all_metal = material.metallic >= 1.0F && !detail.layers[SurfaceDetail::metal_rough];
  const bool passes = detail.transmission > 0.0F && !detail.unlit && !all_metal;
  has(detail.alpha == Alpha::blend || passes, FULCRUM_LOOK_BLEND);
  has(detail.alpha == Alpha::blend, FULCRUM_LOOK_COVER);
  has(detail.double_sided, FULCRUM_LOOK_DOUBLE_SIDED);
  has(detail.unlit, FULCRUM_LOOK_UNLIT);
  has(detail.clearcoat > 0.0F, FULCRUM_LOOK_COAT);
  has(detail.sheen != glm::vec3(0.0F), FULCRUM_LOOK_SHEEN);
  has(passes, FULCRUM_LOOK_TRANSMISSION);
  has(detail.scatter_distance != glm::vec3(0.0F) && !detail.unlit && !all_metal && !is_blended(look),
      FULCRUM_LOOK_SCATTERING);
  return look;
}

bool is_blended(std::uint32_t look) {
  return (look & FULCRUM_LOOK_BLEND) != 0;
}

bool throws_shadow(const Instance& instance, const Material& material) {
  const std::uint32_t look = look_of(material).value_or(0);
  return instance.casts_shadow && !is_blended(look) && !is_all_cut_out(look);
}

bool is_all_cut_out(std::uint32_t look) {
  return is_masked(look) && (look & (1U << FULCRUM_TEXTURE_BASE)) == 0;
}

bool lets_light_through(std::uint32_t look) {
  return (look & FULCRUM_LOOK_TRANSMISSION) != 0;
}

bool is_masked(std::uint32_t look) {
  return (look & FULCRUM_LOOK_MASK) != 0 && !is_blended(look);
}

bool is_scattering(std::uint32_t look) {
  return (look & FULCRUM_LOOK_SCATTERING) != 0;
}

std::uint32_t without_scattering(std::uint32_t look) {
  return look & ~FULCRUM_LOOK_SCATTERING;
}

bool is_two_sided(std::uint32_t look) {
  return (look & FULCRUM_LOOK_DOUBLE_SIDED) != 0;
}

bool reads_places(std::uint32_t look) {
  constexpr std::uint32_t kTextures = (1U << SurfaceDetail::kKinds) - 1U;
  return (look & (kTextures | FULCRUM_LOOK_MASK)) != 0;
}

std::string describe_look(std::uint32_t look) {
  struct Word {
    std::uint32_t bit;
    const char* text;
  };
  constexpr std::array<Word, 14> kWords = {{{1U << FULCRUM_TEXTURE_BASE, "base colour texture"},
                                            {1U << FULCRUM_TEXTURE_METAL_ROUGH, "metal-rough texture"},
                                            {1U << FULCRUM_TEXTURE_NORMAL, "normal texture"},
                                            {1U << FULCRUM_TEXTURE_OCCLUSION, "occlusion texture"},
                                            {1U << FULCRUM_TEXTURE_EMISSIVE, "emissive texture"},
                                            {FULCRUM_LOOK_EMISSION, "emission"},
                                            {FULCRUM_LOOK_MASK, "holes"},
                                            {FULCRUM_LOOK_COVER, "blending"},
                                            {FULCRUM_LOOK_DOUBLE_SIDED, "both sides"},
                                            {FULCRUM_LOOK_UNLIT, "no light"},
                                            {FULCRUM_LOOK_COAT, "clear coat"},
                                            {FULCRUM_LOOK_SHEEN, "sheen"},
                                            {FULCRUM_LOOK_TRANSMISSION, "transmission"},
                                            {FULCRUM_LOOK_SCATTERING, "subsurface scattering"}}};
  std::string text;
  for (const Word& word : kWords)
    if ((look & word.bit) != 0) text.append(text.empty() ? "" : ", ").append(word.text);
  return text.empty() ? "reflectance of its own" : text;
}

}  // namespace fulcrum::render
