#pragma once
// What a scene looks like, in plain data: no GPU, no window, no file.
//
// Right-handed, Y up, metres, radians. Colours are linear Rec. 709, 0..1 unless a comment says otherwise.
// A VisualDesc is only read while a Renderer is planned and built; what moves afterwards is in FrameState.

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/render/levels_of_detail.h"
#include "engine/render/surface_detail.h"

namespace fulcrum::render {

// Triangles in the mesh frame M. Counter-clockwise seen from outside; back faces are not drawn.
struct Mesh {
  std::string name;
  std::vector<glm::vec3> positions;        // (n) m
  std::vector<glm::vec3> normals;          // (n) unit, one for each position
  std::vector<glm::vec3> colours;          // (n) linear, times the material's; or none
  std::vector<glm::vec4> uv;               // (n) two places in textures, xy and zw; or none
  std::vector<std::uint32_t> indices;      // (3 x triangles) into positions
  std::optional<LevelsOfDetail> levels{};  // of it as it is; none: it is drawn whole, however far away
};

// Metal-rough material, as in glTF 2.0.
struct Material {
  std::string name;
  glm::vec3 base_colour{0.8F};            // linear; for a metal its reflectance at normal incidence
  float metallic = 0.0F;                  // 0 dielectric .. 1 metal
  float roughness = 0.5F;                 // 0 mirror .. 1 matt (perceptual: alpha = roughness^2)
  std::optional<SurfaceDetail> detail{};  // none: nothing is built for more than that
};

// One mesh placed in the world.
struct Instance {
  std::size_t mesh = 0;      // index into VisualDesc::meshes
  std::size_t material = 0;  // index into VisualDesc::materials
  std::string name;
  glm::mat4 X_WM{1.0F};  // mesh to world, affine (it may scale); of a movable one: where it starts
  bool movable = false;  // its pose comes with every FrameState
  bool casts_shadow =
      true;  // false for a floor or wall: the shadow map then covers only what throws a shadow, sharper
  std::uint32_t layers = 1;  // bits; a camera sees it that has one of them
  std::size_t follows = 0;   // of a movable one: 0 the tool, which a ghost copies; else what poses it knows
};

// Of a disc that is 1 degree across, seen from 1 m away (m).
inline constexpr float kSunDiameter = 0.017455065F;

// The one light that throws shadows.
struct KeyLight {
  enum class Kind { directional, spot };
  Kind kind = Kind::directional;
  glm::vec3 position{0.0F, 2.0F, 0.0F};      // m, world; spot only
  glm::vec3 direction{-0.4F, -1.0F, -0.5F};  // the way the light travels; need not be unit
  glm::vec3 colour{1.0F, 0.96F, 0.90F};      // linear
  float intensity =
      3.0F;  // irradiance / pi: a white matt surface facing it reads this value; for a spot at 1 m
  float cone_rad = 0.9F;          // full angle; spot only
  float diameter = kSunDiameter;  // m, of its disc; of a directional one as seen from 1 m away
  bool casts_shadow = true;
};

inline constexpr std::size_t kMostLights = 8;  // of VisualDesc::lights

// A point that gives light, or light from infinitely far away, that throws no shadow; as glTF's
// KHR_lights_punctual has it.
struct PunctualLight {
  enum class Kind { directional, point, spot };
  std::string name;
  Kind kind = Kind::point;
  glm::vec3 position{0.0F};                 // m; not of a directional one
  glm::vec3 direction{0.0F, 0.0F, -1.0F};   // the way the light travels, unit; not of a point
  glm::vec3 colour{1.0F};                   // linear
  float intensity = 1.0F;                   // irradiance / pi facing it; of one that has a place, at 1 m
  std::optional<float> range{};             // m, where it ends; none: nowhere
  float inner_cone_rad = 0.0F;              // from a spot's axis: where it begins to fade
  float outer_cone_rad = 0.785398163F;      // and where it ends
  std::optional<std::size_t> carried_by{};  // a movable instance that it is fixed to, in whose mesh's frame M
                                            // position and direction are; none: in W
  std::uint32_t layers = 1;                 // of the cameras for which it shines, as of an instance
};

// What is seen in all directions, as a picture whose rows are circles of equal height (equirectangular), from
// the top (+y). The middle of column i is towards azimuth (i + 0.5) / width turns from -z over +x.
struct Panorama {
  std::uint32_t width = 0, height = 0;  // pixels
  std::vector<glm::vec3> pixels{};      // (height x width) radiance in the world, linear; any brightness
  bool seen = false;                    // where nothing else is, in place of the background
};

// Light from everywhere else: a studio of this sky and this ground, with soft boxes that metal can mirror.
struct Ambient {
  glm::vec3 sky{0.36F, 0.40F, 0.46F};     // linear
  glm::vec3 ground{0.10F, 0.09F, 0.08F};  // linear
  float intensity = 1.0F;
  bool mirrored = false;              // the boxes that stand at the left are at the right
  std::optional<Panorama> picture{};  // in place of the studio; intensity times it
};

// Two eyes in place of one, for stereo (stereo.h); lengths in the scene.
struct EyePair {
  std::optional<float> distance{};     // m, between them; none: what suits the picture
  std::optional<float> convergence{};  // m, to the plane that is seen at the screen; none: the target's
};

struct Camera {
  glm::vec3 eye{0.6F, 0.5F, 0.8F};  // m, world
  glm::vec3 target{0.0F};           // m, world
  float vertical_fov_rad = 0.7F;    // where it does not lean: twice the angle of half the picture's height
  std::uint32_t layers = 1;         // bits of the instances that it sees
  EyePair eyes{};
  glm::vec2 lean{0.0F};  // (2) right and up, tangents: where from its way ahead the picture's middle is
  glm::vec3 up{0.0F, 1.0F, 0.0F};  // unit, world: what is up in the picture
  std::optional<float> aspect{};   // width by height of what is seen; none: the picture's
};

// A place that the trainee has to reach, drawn as a glowing sphere.
struct Marker {
  std::string name;
  glm::vec3 position{0.0F};  // m, world
  float radius = 0.01F;      // m
};

// The tool once more, as lines: where the hand has turned to while the scene holds the tool, or where another
// hand would have it. A copy of all instances that follow it, in one pose that comes with every FrameState.
struct Ghost {
  glm::vec3 colour{0.03F, 0.80F, 1.0F};  // linear; shown as it is, whatever the light
  float line_width = 0.0032F;            // of the picture's height; never less than 1.3 pixels
  float crease_rad = 0.6F;               // edges where the surface bends by more than this are always drawn
};

struct Background {
  glm::vec3 top{0.20F, 0.24F, 0.30F};     // linear
  glm::vec3 bottom{0.06F, 0.07F, 0.08F};  // linear
};

struct VisualDesc {
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<Texture> textures;  // of materials
  std::vector<Instance> instances;
  std::optional<KeyLight> key_light =
      KeyLight{};                       // absent: ambient light alone, and nothing is built for shadows
  std::vector<PunctualLight> lights{};  // at most kMostLights; empty: nothing is built for them
  Ambient ambient;
  Camera camera;                // where a view starts
  std::vector<Marker> markers;  // empty: nothing is built for markers
  std::vector<Ghost> ghosts;    // later ones are drawn over earlier ones; empty: nothing is built for them
  Background background;
};

}  // namespace fulcrum::render
