#pragma once
// What a renderer will build for a scene, decided before there is a graphics device: `fulcrum explain` prints
// it, and Renderer builds exactly this.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/render/quality.h"
#include "engine/render/stereo.h"
#include "engine/render/visual_desc.h"
#include "engine/vulkan/result.h"

namespace fulcrum::render {

using vulkan::Error;
using vulkan::Result;

// Width and height in pixels.
struct Extent {
  std::uint32_t width = 1280;
  std::uint32_t height = 720;

  bool operator==(const Extent&) const = default;
};

struct RenderOptions {
  Extent extent;  // of the picture
  Quality quality;
  std::filesystem::path
      shader_folder;  // empty: the built-in shaders; else GLSL from here, reloaded when it changes
  std::optional<Extent> inset{};   // of a second view; none: there is none
  std::optional<Stereo> stereo{};  // none: for one eye
  bool at_screen = true;           // in stereo, panels or a second view may lie at the screen
};

// The repository's shaders/ in a Debug build, else empty: what `shader_folder` should be in a program.
std::filesystem::path development_shader_folder();

struct BuildItem {
  std::string name;         // "shadow map"
  std::string kind;         // "image", "buffer", "pipeline"
  std::uint64_t bytes = 0;  // on the device, without the driver's padding; 0 for a pipeline
  std::string note;         // what it is for; of something left out, why
};

struct RenderPlan {
  Extent picture;
  Extent eye;                     // what one eye sees of it: the picture, or in stereo its squeezed part
  Extent scene;                   // eye times resolution_scale
  int samples = 4;                // per pixel
  float coarseness = 0.0F;        // pixels of the scene that coarser triangles may be off by
  int shadow_size = 0;            // pixels on a side; 0: nothing is built for shadows
  bool standing_shadows = false;  // those of what never moves have a map of their own
  bool soft_shadows = false;      // with edges as wide as the light's size makes them
  bool occlusion = false;         // ambient
  int scattering = 0;             // samples per pixel; 0: nothing is built for light below surfaces
  bool reflections = false;       // metal mirrors what stands near it
  bool surfaces = false;
  bool plain_surfaces = false;            // of one colour, one metallic and one roughness
  std::vector<std::uint32_t> looks = {};  // of the others (look.h), each once
  std::uint32_t lights = 0;               // beside the key light: that models bring
  bool seen_around = false;               // the surroundings are the background
  bool markers = false;
  bool ghosts = false;
  std::optional<Extent> inset{};       // its scene is as large
  std::optional<StereoMode> stereo{};  // none: nothing is built for a second eye
  bool screen_layer = false;           // in stereo: for what lies at the screen
  std::vector<BuildItem> built;
  std::vector<BuildItem> left_out;

  // The scene is drawn smaller than it is shown.
  bool enlarged() const { return !(scene == eye); }
};

// What a plan depends on, so that a renderer need not keep the meshes to plan again at another size.
struct SceneFacts {
  std::uint64_t vertices = 0;
  std::uint64_t indices = 0;
  std::uint64_t levelled = 0;  // triangles that have coarser ones
  std::uint64_t coarser = 0;   // indices of these
  std::uint64_t coarsest = 0;  // triangles, where all of it is as coarse as it gets
  std::uint64_t pieces = 0;    // of the meshes that have coarser ones
  std::uint64_t instances = 0;
  std::uint64_t casters = 0;              // instances that throw a shadow
  std::uint64_t moving_casters = 0;       // of those, the ones that may move
  std::uint64_t plain = 0;                // instances without a detailed material
  std::vector<std::uint32_t> looks = {};  // of those with one, each once
  std::uint64_t detailed = 0;             // materials of these
  std::uint64_t placed_vertices = 0;      // of their meshes that have places in textures
  std::uint64_t textures = 0;             // that they show
  std::uint64_t texture_bytes = 0;        // of those, in all their sizes
  std::uint64_t voxels = 0;               // of light volumes
  std::uint64_t mirrored = 0;             // voxels of what metal mirrors; 0: nothing mirrors its neighbours
  std::uint64_t lights = 0;               // beside the key light
  std::uint64_t scattering = 0;           // instances that light spreads below
  std::uint64_t markers = 0;
  std::vector<std::uint64_t> ghost_edges;  // of each ghost that has some
  bool picture = false;                    // the surroundings are one
  bool picture_seen = false;
  bool key_light = false;
  bool key_light_casts = false;
  bool key_light_wide = false;  // it has a size
};

SceneFacts facts_of(const VisualDesc& desc);

// What one eye's picture is to be drawn in.
Extent eye_extent(Extent picture, const std::optional<Stereo>& stereo);

// Fails with a sentence that names the option out of range.
Result<RenderPlan> plan(const SceneFacts& facts, const RenderOptions& options);

// The same from a whole description; fails also with a sentence that names the mesh or instance that is
// wrong.
Result<RenderPlan> plan(const VisualDesc& desc, const RenderOptions& options);

}  // namespace fulcrum::render
