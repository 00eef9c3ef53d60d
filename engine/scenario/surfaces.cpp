#include "engine/scenario/surfaces.h"

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "engine/assets/image.h"
#include "engine/render/mip_chain.h"
#include "haptics/math/functions.h"

namespace fulcrum::scenario {
namespace {

using render::SurfaceDetail;

glm::vec3 colour_of(const std::array<float, 3>& c) {
  return {c[0], c[1], c[2]};
}

render::Wrap wrap_of(TextureWrap wrap) {
  switch (wrap) {
    case TextureWrap::mirror:
      return render::Wrap::mirror;
    case TextureWrap::clamp:
      return render::Wrap::clamp;
    default:
      return render::Wrap::repeat;
  }
}

// KHR_texture_transform: shift(offset) turn(rotation) scale, where v grows downwards.
render::TextureLayer layer_of(const TextureUse& use, std::size_t texture) {
  const auto angle = static_cast<double>(use.rotation);
  const auto c = static_cast<float>(math::cos(angle)), s = static_cast<float>(math::sin(angle));
  render::TextureLayer layer{texture, use.uv_set, wrap_of(use.wrap_u), wrap_of(use.wrap_v), use.nearest};
  layer.turn = glm::mat2(c * use.scale[0], -s * use.scale[0], s * use.scale[1], c * use.scale[1]);
  layer.shift = {use.offset[0], use.offset[1]};
  return layer;
}

std::uint64_t bytes_of(const std::vector<render::Texture>& textures) {
  std::uint64_t bytes = 0;
  for (const render::Texture& texture : textures) bytes += render::mip_bytes(texture);
  return bytes;
}

// The model's images as textures, each decoded once; one that is shown as colours and as numbers, or cut off
// at two values of alpha, is there twice.
class Textures {
public:
  Textures(render::VisualDesc& desc, const Model& model, std::uint64_t most_bytes)
      : desc_(desc), model_(model), most_bytes_(most_bytes) {}

  enum class Meaning {
    numbers,
    colours,
    colours_with_holes  // where alpha is 0 there is none
  };

  // cut_off: of colours with holes, the alpha below which there is nothing.
  std::optional<render::TextureLayer> layer(const std::optional<TextureUse>& use, Meaning meaning,
                                            std::optional<float> cut_off = {}) {
    if (!use || error_) return std::nullopt;
    const auto [known, is_new] = made_.try_emplace({use->image, meaning, cut_off}, desc_.textures.size());
    if (is_new) {
      const ModelImage& image = model_.images[use->image];
      Result<Image> decoded = decode_image(image.encoded);
      if (!decoded) {
        error_ = Error{"the texture " + image.name + " cannot be used: " + decoded.error().sentence + "."};
        return std::nullopt;
      }
      desc_.textures.push_back({image.name, decoded->width, decoded->height, std::move(decoded->rgba),
                                meaning != Meaning::numbers, meaning == Meaning::colours_with_holes,
                                cut_off});
      if (bytes_of(desc_.textures) > most_bytes_) {
        error_ = Error{"the textures of the scene take more than 1 GB with this one, " + image.name +
                       ": make them smaller."};
        return std::nullopt;
      }
    }
    return layer_of(*use, known->second);
  }

  const std::optional<Error>& error() const { return error_; }

private:
  render::VisualDesc& desc_;
  const Model& model_;
  std::uint64_t most_bytes_ = 0;  // of all textures, in all their sizes
  std::map<std::tuple<std::size_t, Meaning, std::optional<float>>, std::size_t> made_;
  std::optional<Error> error_;
};

SurfaceDetail detail_of(const MaterialDetail& from, Textures& textures) {
  SurfaceDetail to;
  using enum Textures::Meaning;
  std::optional<float> cut_off;
  if (from.alpha_mode == AlphaMode::mask) cut_off = from.alpha_cutoff / std::max(from.alpha, 1e-6F);
  to.layers[SurfaceDetail::base_colour] = textures.layer(
      from.base_colour, from.alpha_mode == AlphaMode::opaque ? colours : colours_with_holes, cut_off);
  to.opacity = from.alpha;
  to.alpha = from.alpha_mode == AlphaMode::mask    ? render::Alpha::mask
             : from.alpha_mode == AlphaMode::blend ? render::Alpha::blend
                                                   : render::Alpha::opaque;
  to.alpha_cutoff = from.alpha_cutoff;
  to.double_sided = from.double_sided;
  to.unlit = from.unlit;
  if (to.unlit) return to;  // the rest is for those who do not know KHR_materials_unlit
  to.layers[SurfaceDetail::metal_rough] = textures.layer(from.metal_rough, numbers);
  to.layers[SurfaceDetail::normal] = textures.layer(from.normal, numbers);
  to.layers[SurfaceDetail::occlusion] = textures.layer(from.occlusion, numbers);
  to.layers[SurfaceDetail::emissive] = textures.layer(from.emissive, colours);
  to.normal_scale = from.normal_scale;
  to.occlusion_strength = from.occlusion_strength;
  to.emission = colour_of(from.emission);
  const float mirrored = from.ior > 0.0F ? (from.ior - 1.0F) / (from.ior + 1.0F) : 1.0F;
  to.f0 = from.specular * glm::min(mirrored * mirrored * colour_of(from.specular_colour), glm::vec3(1.0F));
  to.f90 = from.specular;
  to.clearcoat = from.clearcoat;
  to.clearcoat_roughness = from.clearcoat_roughness;
  to.sheen = colour_of(from.sheen);
  to.sheen_roughness = from.sheen_roughness;
  to.transmission = from.transmission;
  to.passed = colour_of(from.passed);
  return to;
}

}  // namespace

std::optional<Error> add_materials(render::VisualDesc& desc, const Model& model, std::uint64_t most) {
  std::vector<bool> is_shown(model.materials.size(), false);
  for (const ModelPart& part : model.parts) is_shown[part.material] = true;
  const std::size_t first_texture = desc.textures.size();
  Textures textures(desc, model, most);
  for (std::size_t i = 0; i < model.materials.size(); ++i) {
    const ModelMaterial& from = model.materials[i];
    render::Material to{from.name, colour_of(from.base_colour), from.metallic, from.roughness};
    if (from.detail && is_shown[i]) to.detail = detail_of(*from.detail, textures);
    desc.materials.push_back(std::move(to));
  }
  // Else those of the next models were told to be too many with these.
  if (textures.error()) desc.textures.resize(first_texture);
  return textures.error();
}

}  // namespace fulcrum::scenario
