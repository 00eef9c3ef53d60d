#include "engine/render/plan.h"

#include <algorithm>
#include <cmath>

#include "engine/render/environment.h"
#include "engine/render/look.h"
#include "engine/render/occlusion_pass.h"
#include "engine/render/scatter_taps.h"
#include "engine/render/validate.h"
#include "engine/render/vertex.h"
#include "shaders/shared/frame.h"
#include "shaders/shared/ghost.h"
#include "shaders/shared/instance.h"
#include "shaders/shared/light.h"
#include "shaders/shared/marker.h"
#include "shaders/shared/material.h"

namespace fulcrum::render {
namespace {

constexpr std::uint64_t kSceneTexel = 8;      // R16G16B16A16_SFLOAT
constexpr std::uint64_t kDepthTexel = 4;      // D32_SFLOAT
constexpr std::uint64_t kPictureTexel = 4;    // R8G8B8A8_UNORM
constexpr std::uint64_t kGhostTexel = 2;      // R8G8_UNORM
constexpr std::uint64_t kOcclusionTexel = 4;  // R16G16_SFLOAT
constexpr std::uint64_t kScatterTexel = 16;   // R32G32B32A32_UINT, and _SFLOAT

std::uint64_t texels(Extent extent) {
  return std::uint64_t{extent.width} * extent.height;
}

std::string size_of(Extent extent) {
  return std::to_string(extent.width) + " x " + std::to_string(extent.height);
}

std::optional<Error> check_options(const RenderOptions& options) {
  const Quality& quality = options.quality;
  if (options.extent.width == 0 || options.extent.height == 0 || options.extent.width > 16384 ||
      options.extent.height > 16384) {
    return Error{"A picture of " + size_of(options.extent) +
                 " cannot be drawn; use 1 to 16384 pixels a side."};
  }
  if (quality.samples != 1 && quality.samples != 4) {
    return Error{"A picture with " + std::to_string(quality.samples) +
                 " samples per pixel cannot be drawn; use 1 or 4."};
  }
  if (quality.shadow_size < 0 || quality.shadow_size > 8192) {
    return Error{"A shadow map of " + std::to_string(quality.shadow_size) +
                 " pixels a side cannot be made; use 0 (none) to 8192."};
  }
  if (!(quality.resolution_scale >= 0.25F && quality.resolution_scale <= 1.0F))
    return Error{"The resolution scale is " + std::to_string(quality.resolution_scale) + "; use 0.25 to 1."};
  if (quality.scattering < 0 || quality.scattering > kMostScatterTaps) {
    return Error{"Light cannot spread below surfaces with " + std::to_string(quality.scattering) +
                 " samples per pixel; use 0 (it does not) to " + std::to_string(kMostScatterTaps) + "."};
  }
  if (!(quality.coarseness >= 0.0F && quality.coarseness <= 16.0F))
    return Error{"Triangles may be off by " + std::to_string(quality.coarseness) +
                 " pixels; use 0 (none are coarser) to 16."};
  if (options.stereo && options.stereo->screen &&
      !(options.stereo->screen->height > 0.0F && options.stereo->screen->head.z > 0.0F))
    return Error{"A screen has a height, and a head is before it; give both more than 0."};
  const auto& inset = options.inset;
  if (inset && (inset->width == 0 || inset->height == 0 || inset->width > options.extent.width ||
                inset->height > options.extent.height))
    return Error{"A second view of " + size_of(*inset) + " cannot be laid into a picture of " +
                 size_of(options.extent) + "; use 1 pixel a side up to the picture's."};
  if (inset && options.stereo && !options.at_screen)
    return Error{
        "A second view lies at the screen, where this picture for two eyes has nothing; leave it out."};
  return {};
}

// Why nothing is built for shadows; empty: it is.
std::string no_shadow_because(const SceneFacts& facts, const Quality& quality) {
  if (!facts.key_light) return "the scene has no key light";
  if (!facts.key_light_casts) return "the scene's key light throws no shadow";
  if (facts.casters == 0) return "nothing in the scene throws a shadow";
  return quality.shadow_size == 0 ? "the quality setting switches shadows off" : "";
}

void add_levels(const SceneFacts& facts, const Quality& quality, RenderPlan& plan) {
  if (facts.levelled == 0) {
    plan.left_out.push_back({"levels of detail", "buffer", 0,
                             "no mesh has " + std::to_string(kTrianglesWorthLevels) + " triangles"});
    return;
  }
  plan.coarseness = quality.coarseness;
  const char* const chosen = quality.coarseness > 0.0F
                                 ? " pieces that are chosen by their size in the picture"
                                 : " pieces, for a quality setting that uses them";
  plan.built.push_back({"levels of detail", "buffer", facts.coarser * sizeof(std::uint32_t),
                        std::to_string(facts.levelled) + " triangles down to " +
                            std::to_string(facts.coarsest) + ", in " + std::to_string(facts.pieces) +
                            chosen});
}

void add_geometry(const SceneFacts& facts, RenderPlan& plan) {
  if (!plan.surfaces) {
    plan.left_out.push_back({"surfaces", "pipeline", 0, "the scene has no instances"});
    plan.left_out.push_back({"surroundings", "image", 0, "the scene has no instances"});
    plan.left_out.push_back({"light volume", "image", 0, "the scene has no instances"});
    return;
  }
  plan.built.push_back(
      {"vertices", "buffer", facts.vertices * sizeof(Vertex), std::to_string(facts.vertices) + " of them"});
  plan.built.push_back({"indices", "buffer", facts.indices * sizeof(std::uint32_t),
                        std::to_string(facts.indices / 3) + " triangles"});
  plan.built.push_back({"instances", "buffer", facts.instances * sizeof(gpu::InstanceData),
                        std::to_string(facts.instances) + " of them"});
  plan.built.push_back(
      {"surroundings", "image", environment_bytes(),
       std::string(facts.picture ? "a picture" : "the studio") + " as mirrors of six roughnesses show it"});
  if (!facts.picture)
    plan.left_out.push_back(
        {"picture of the surroundings", "image", 0, "the scene has its light from the studio"});
  if (facts.voxels > 1)
    plan.built.push_back({"light volume", "image", 3 * facts.voxels * kSceneTexel,
                          std::to_string(facts.voxels) +
                              " voxels: what standing things hide of the surroundings, and send on"});
  else
    plan.left_out.push_back({"light volume", "image", 0, "nothing in the scene stands: one voxel says so"});
  if (plan.plain_surfaces)
    plan.built.push_back({"surfaces", "pipeline", 0, "metal-rough, lit from all around"});
  else
    plan.left_out.push_back({"surfaces", "pipeline", 0, "no material is of one colour alone"});
}

void add_reflections(const SceneFacts& facts, const Quality& quality, RenderPlan& plan) {
  plan.reflections = plan.surfaces && facts.mirrored > 0 && quality.reflections;
  if (plan.surfaces && facts.mirrored > 0)
    plan.built.push_back(
        {"mirror volume", "image", facts.mirrored * kSceneTexel,
         std::to_string(facts.mirrored) + " voxels in two images: what metal mirrors of standing things"});
  else
    plan.left_out.push_back({"mirror volume", "image", 0,
                             "no lit metal of a roughness below 0.7 has anything that stands near it"});
  if (plan.reflections)
    plan.built.push_back(
        {"reflections", "pipeline", 0, "in those of surfaces: metal mirrors its neighbours"});
  else
    plan.left_out.push_back(
        {"reflections", "pipeline", 0,
         facts.mirrored > 0 ? "the quality setting switches them off" : "there is no mirror volume"});
}

void add_detail(const SceneFacts& facts, RenderPlan& plan) {
  plan.looks = facts.looks;
  if (plan.looks.empty()) {
    plan.left_out.push_back({"detailed surfaces", "pipeline", 0, "no material has more than one colour"});
    return;
  }
  plan.built.push_back({"materials", "buffer", facts.detailed * sizeof(gpu::MaterialData),
                        std::to_string(facts.detailed) + " detailed ones"});
  plan.built.push_back(
      {"white", "image", kPictureTexel, "one pixel, in the place of textures that a material has not"});
  for (const std::uint32_t look : plan.looks)
    plan.built.push_back({"detailed surfaces", "pipeline", 0,
                          describe_look(plan.scattering > 0 ? look : without_scattering(look))});
  if (facts.placed_vertices > 0)
    plan.built.push_back({"places in textures", "buffer", facts.placed_vertices * sizeof(glm::vec4),
                          "of " + std::to_string(facts.placed_vertices) + " vertices"});
  else
    plan.left_out.push_back({"places in textures", "buffer", 0, "no material has a texture or is cut out"});
  if (facts.textures > 0)
    plan.built.push_back({"textures", "image", facts.texture_bytes,
                          std::to_string(facts.textures) + " of them, in all their sizes"});
  else
    plan.left_out.push_back({"textures", "image", 0, "no material has one"});
  const bool masked = std::ranges::any_of(plan.looks, is_masked);
  if (masked && plan.shadow_size > 0)
    plan.built.push_back({"shadows with holes", "pipeline", 0, "of materials that are cut out"});
  else
    plan.left_out.push_back(
        {"shadows with holes", "pipeline", 0, masked ? "there are no shadows" : "no material is cut out"});
}

void add_shadow(const SceneFacts& facts, const Quality& quality, RenderPlan& plan) {
  const std::string why_not = no_shadow_because(facts, quality);
  if (!why_not.empty()) {
    plan.left_out.push_back({"shadow map", "image", 0, why_not});
    plan.left_out.push_back({"shadows", "pipeline", 0, why_not});
    plan.left_out.push_back({"soft shadows", "pipeline", 0, why_not});
    return;
  }
  plan.shadow_size = quality.shadow_size;
  const auto side = static_cast<std::uint32_t>(quality.shadow_size);
  plan.built.push_back(
      {"shadow map", "image", texels({side, side}) * kDepthTexel,
       size_of({side, side}) + ", drawn again only when something that throws a shadow has moved"});
  plan.standing_shadows = facts.moving_casters > 0 && facts.moving_casters < facts.casters;
  if (plan.standing_shadows)
    plan.built.push_back({"standing shadow map", "image", texels({side, side}) * kDepthTexel,
                          "of what never moves, so that it is not drawn again when something else does"});
  else
    plan.left_out.push_back({"standing shadow map", "image", 0,
                             facts.moving_casters > 0 ? "all that throws a shadow may move"
                                                      : "nothing that throws a shadow moves"});
  plan.built.push_back({"shadows", "pipeline", 0, "depth as the key light sees it"});
  plan.soft_shadows = facts.key_light_wide && quality.soft_shadows;
  if (plan.soft_shadows)
    plan.built.push_back({"soft shadows", "pipeline", 0,
                          "in those of surfaces: edges as wide as the light's diameter makes them"});
  else
    plan.left_out.push_back({"soft shadows", "pipeline", 0,
                             facts.key_light_wide ? "the quality setting switches them off"
                                                  : "the scene's key light has no diameter"});
}

void add_lights(const SceneFacts& facts, RenderPlan& plan) {
  plan.lights = plan.surfaces ? static_cast<std::uint32_t>(facts.lights) : 0;
  if (plan.lights == 0) {
    plan.left_out.push_back(
        {"lights of models", "buffer", 0,
         facts.lights == 0 ? "no model brings one (KHR_lights_punctual)" : "the scene has no instances"});
    return;
  }
  plan.built.push_back({"lights of models", "buffer", sizeof(gpu::LightsData),
                        std::to_string(facts.lights) + ", in those of surfaces: without shadows"});
}

void add_occlusion(const Quality& quality, RenderPlan& plan) {
  plan.occlusion = plan.surfaces && quality.occlusion;
  if (!plan.occlusion) {
    const std::string why =
        plan.surfaces ? "the quality setting switches it off" : "the scene has no instances";
    plan.left_out.push_back({"ambient occlusion", "image", 0, why});
    plan.left_out.push_back({"ambient occlusion", "pipeline", 0, why});
    return;
  }
  const Extent half = occlusion_extent(plan.scene);
  plan.built.push_back({"ambient occlusion", "image", texels(half) * (kDepthTexel + 2 * kOcclusionTexel),
                        size_of(half) + ": depth, what it hides, and that made smooth"});
  plan.built.push_back(
      {"ambient occlusion", "pipeline", 0, "what near things hide of the light from all around"});
}

std::uint64_t scatter_bytes(Extent scene) {
  return texels(scene) * (2 * kScatterTexel + kDepthTexel);
}

void add_scattering(const SceneFacts& facts, const Quality& quality, RenderPlan& plan) {
  plan.scattering = facts.scattering > 0 ? quality.scattering : 0;
  if (plan.scattering == 0) {
    const std::string why =
        facts.scattering > 0
            ? "the quality setting switches it off"
            : "no material that is lit, no metal and not seen through says how far light spreads below it";
    for (const char* kind : {"image", "buffer", "pipeline"})
      plan.left_out.push_back({"subsurface scattering", kind, 0, why});
    return;
  }
  const std::uint64_t numbers =
      facts.scattering + kScatterPatterns * static_cast<std::uint64_t>(plan.scattering);
  plan.built.push_back({"subsurface scattering", "image", scatter_bytes(plan.scene),
                        size_of(plan.scene) + ": depth, the light that enters, and that spread"});
  plan.built.push_back({"subsurface scattering", "buffer", numbers * sizeof(glm::vec4),
                        std::to_string(facts.scattering) + " distances, and " +
                            std::to_string(plan.scattering) + " samples in " +
                            std::to_string(kScatterPatterns) + " patterns"});
  plan.built.push_back(
      {"subsurface scattering", "pipeline", 0, "the light that enters surfaces, and spreads"});
}

void add_markers(const SceneFacts& facts, RenderPlan& plan) {
  if (!plan.markers) {
    plan.left_out.push_back({"markers", "buffer", 0, "the scene has no checkpoints"});
    plan.left_out.push_back({"markers", "pipeline", 0, "the scene has no checkpoints"});
    return;
  }
  plan.built.push_back({"markers", "buffer", facts.markers * sizeof(gpu::MarkerData),
                        std::to_string(facts.markers) + " checkpoints"});
  plan.built.push_back({"markers", "pipeline", 0, "glowing spheres"});
}

void add_ghosts(const SceneFacts& facts, RenderPlan& plan) {
  if (!plan.ghosts) {
    plan.left_out.push_back({"ghost", "buffer", 0, "the scene has no ghost"});
    plan.left_out.push_back({"ghost", "pipeline", 0, "the scene has no ghost"});
    return;
  }
  const std::string size = size_of(plan.picture);
  for (const std::uint64_t edges : facts.ghost_edges) {
    plan.built.push_back(
        {"ghost", "buffer", edges * sizeof(gpu::GhostLine), "room for " + std::to_string(edges) + " edges"});
    plan.built.push_back({"ghost depth", "image", texels(plan.picture) * kDepthTexel, size});
    plan.built.push_back({"ghost lines", "image", texels(plan.picture) * kGhostTexel, size});
  }
  plan.built.push_back({"ghost depth", "pipeline", 0, "its surface, which hides its rear lines"});
  plan.built.push_back({"ghost lines", "pipeline", 0, "creases and silhouettes, fainter behind the scene"});
  plan.built.push_back({"ghost", "pipeline", 0, "its lines over the picture"});
}

// Of a scene that is tone mapped before it is enlarged.
std::uint64_t finished_bytes(const RenderPlan& plan) {
  if (!plan.enlarged()) return 0;
  const Extent wide{plan.eye.width, plan.scene.height};
  return (texels(plan.scene) + texels(wide)) * kPictureTexel;
}

// Of one more view.
std::uint64_t view_bytes(const SceneFacts& facts, const RenderPlan& plan, Extent scene, Extent picture) {
  const auto each = static_cast<std::uint64_t>(plan.samples);
  const std::uint64_t colour = kSceneTexel * (each > 1 ? each + 1 : 1), depth = kDepthTexel * each;
  const std::uint64_t hidden =
      plan.occlusion ? texels(occlusion_extent(scene)) * (kDepthTexel + 2 * kOcclusionTexel) : 0;
  const std::uint64_t scattered = plan.scattering > 0 ? scatter_bytes(scene) : 0;
  return texels(scene) * (colour + depth) + hidden + scattered +
         texels(picture) * facts.ghost_edges.size() * (kDepthTexel + kGhostTexel);
}

// Of one more view as well: camera, lights, samples of light below surfaces, and room for ghosts' edges.
std::uint64_t view_numbers(const SceneFacts& facts, const RenderPlan& plan) {
  std::uint64_t bytes = sizeof(gpu::FrameData) + (plan.lights > 0 ? sizeof(gpu::LightsData) : 0) +
                        kScatterPatterns * static_cast<std::uint64_t>(plan.scattering) * sizeof(glm::vec4);
  for (const std::uint64_t edges : facts.ghost_edges) bytes += edges * sizeof(gpu::GhostLine);
  return bytes;
}

void add_inset(const SceneFacts& facts, RenderPlan& plan) {
  if (!plan.inset) {
    plan.left_out.push_back({"second view", "image", 0, "it is switched on in a window"});
    return;
  }
  plan.built.push_back({"second view", "image", view_bytes(facts, plan, *plan.inset, *plan.inset),
                        size_of(*plan.inset) + ", the same passes once more"});
  plan.built.push_back({"second view", "buffer", view_numbers(facts, plan), "its camera, lights and ghosts"});
}

void add_stereo(const SceneFacts& facts, RenderPlan& plan) {
  if (!plan.stereo) {
    plan.left_out.push_back({"stereo", "image", 0, "--stereo asks for it"});
    plan.left_out.push_back({"stereo", "pipeline", 0, "--stereo asks for it"});
    return;
  }
  const std::string size = size_of(plan.eye);
  plan.built.push_back({"second eye", "image",
                        view_bytes(facts, plan, plan.scene, plan.picture) + finished_bytes(plan),
                        size_of(plan.scene) + ", the same passes once more; the shadow map is for both"});
  plan.built.push_back({"second eye", "buffer", view_numbers(facts, plan), "its camera, lights and ghosts"});
  plan.built.push_back(
      {"eyes", "image", 2 * texels(plan.eye) * kPictureTexel, size + ", twice: tone mapped"});
  if (plan.screen_layer)
    plan.built.push_back({"screen layer", "image", texels(plan.picture) * kPictureTexel,
                          size_of(plan.picture) + ", what lies at the screen: panels, a second view"});
  else
    plan.left_out.push_back({"screen layer", "image", 0, "no panel or second view lies at the screen"});
  plan.built.push_back(
      {"stereo", "pipeline", 0, std::string(kStereoModeNames[static_cast<std::size_t>(*plan.stereo)])});
}

void add_targets(RenderPlan& plan) {
  const std::string size = size_of(plan.scene);
  const auto samples = static_cast<std::uint64_t>(plan.samples);
  if (plan.samples > 1) {
    plan.built.push_back({"scene samples", "image", texels(plan.scene) * kSceneTexel * samples,
                          size + ", " + std::to_string(plan.samples) + " samples a pixel"});
  } else {
    plan.left_out.push_back({"scene samples", "image", 0, "the quality setting asks for one sample a pixel"});
  }
  plan.built.push_back({"scene", "image", texels(plan.scene) * kSceneTexel, size + ", half floats"});
  plan.built.push_back({"scene depth", "image", texels(plan.scene) * kDepthTexel * samples, size});
  plan.built.push_back(
      {"picture", "image", texels(plan.picture) * kPictureTexel, size_of(plan.picture) + ", sRGB"});
  if (plan.enlarged()) {
    plan.built.push_back({"finished scene", "image", finished_bytes(plan),
                          size + ", sRGB, before it is enlarged to " + size_of(plan.eye)});
    plan.built.push_back({"enlargement", "pipeline", 0, "Catmull-Rom along rows, without ringing"});
    plan.built.push_back({"enlargement", "pipeline", 0, "the same along columns"});
  } else {
    const char* whole = "the scene is drawn as large as it is shown";
    plan.left_out.push_back({"finished scene", "image", 0, whole});
    plan.left_out.push_back({"enlargement", "pipeline", 0, whole});
  }
  plan.built.push_back({"background", "pipeline", 0, plan.seen_around ? "the surroundings" : "a gradient"});
  plan.built.push_back({"tone mapping", "pipeline", 0, "AgX, with a little contrast"});
  plan.built.push_back({"frame", "buffer", sizeof(gpu::FrameData), "camera and lights"});
}

}  // namespace

Extent eye_extent(Extent picture, const std::optional<Stereo>& stereo) {
  // Of an odd number the first eye has one more.
  if (stereo && stereo->mode == StereoMode::side_by_side) picture.width = (picture.width + 1) / 2;
  if (stereo && stereo->mode == StereoMode::top_bottom) picture.height = (picture.height + 1) / 2;
  return picture;
}

Result<RenderPlan> plan(const SceneFacts& facts, const RenderOptions& options) {
  if (auto error = check_options(options)) return *error;
  const auto scaled = [&](std::uint32_t pixels) {
    return std::max(1U, static_cast<std::uint32_t>(
                            std::lround(static_cast<float>(pixels) * options.quality.resolution_scale)));
  };
  RenderPlan plan;
  plan.picture = options.extent;
  plan.eye = eye_extent(options.extent, options.stereo);
  plan.scene = {scaled(plan.eye.width), scaled(plan.eye.height)};
  plan.samples = options.quality.samples;
  plan.surfaces = facts.instances > 0;
  plan.plain_surfaces = facts.plain > 0;
  plan.seen_around = plan.surfaces && facts.picture_seen;
  plan.markers = facts.markers > 0;
  plan.ghosts = !facts.ghost_edges.empty();
  plan.inset = options.inset;
  if (options.stereo) plan.stereo = options.stereo->mode;
  plan.screen_layer = options.stereo && options.at_screen;
  add_geometry(facts, plan);
  add_levels(facts, options.quality, plan);
  add_shadow(facts, options.quality, plan);
  add_lights(facts, plan);
  add_reflections(facts, options.quality, plan);
  add_scattering(facts, options.quality, plan);
  add_detail(facts, plan);
  add_occlusion(options.quality, plan);
  add_markers(facts, plan);
  add_ghosts(facts, plan);
  add_targets(plan);
  add_inset(facts, plan);
  add_stereo(facts, plan);
  return plan;
}

Result<RenderPlan> plan(const VisualDesc& desc, const RenderOptions& options) {
  if (auto error = validate(desc)) return *error;
  return plan(facts_of(desc), options);
}

std::filesystem::path development_shader_folder() {
#ifdef FULCRUM_SHADER_FOLDER
  return FULCRUM_SHADER_FOLDER;
#else
  return {};
#endif
}

}  // namespace fulcrum::render
