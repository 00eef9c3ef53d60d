// What a surface has beyond one colour, one metallic and one roughness.
#ifndef FULCRUM_SHADERS_SHARED_MATERIAL_H
#define FULCRUM_SHADERS_SHARED_MATERIAL_H

#include "types.h"

// Numbers for both languages. Textures of a material, in the order of their bindings:
#define FULCRUM_TEXTURE_BASE 0
#define FULCRUM_TEXTURE_METAL_ROUGH 1
#define FULCRUM_TEXTURE_NORMAL 2
#define FULCRUM_TEXTURE_OCCLUSION 3
#define FULCRUM_TEXTURE_EMISSIVE 4
#define FULCRUM_TEXTURES 5

// What a pipeline is built for, bits of its one specialisation constant. Bit i below 5: it has texture i.
#define FULCRUM_LOOK_EMISSION 32u
#define FULCRUM_LOOK_MASK 64u
#define FULCRUM_LOOK_BLEND 128u
#define FULCRUM_LOOK_DOUBLE_SIDED 256u
#define FULCRUM_LOOK_UNLIT 512u
#define FULCRUM_LOOK_COAT 1024u
#define FULCRUM_LOOK_SHEEN 2048u
#define FULCRUM_LOOK_TRANSMISSION 4096u
#define FULCRUM_LOOK_COVER 8192u  // of those that are blended: its alpha says how much of it is there
#define FULCRUM_LOOK_SCATTERING 16384u
// Of all surfaces, from the plan: metal mirrors what stands near it.
#define FULCRUM_LOOK_NEIGHBOURS 32768u
// Of those that have holes: a pixel has several samples, of which as many are covered as there is of the
// surface.
#define FULCRUM_LOOK_SAMPLES 65536u
#define FULCRUM_LOOK_LIGHTS_SHIFT 17  // bits from here on: how many lights models bring

FULCRUM_GPU_BEGIN

struct MaterialData {
  vec4 emission;                   // rgb radiance; w where alpha is cut off
  vec4 amounts;                    // x normal scale, y occlusion strength, z opacity, w transmission
  vec4 specular;                   // rgb reflectance of the dielectric part at normal incidence, w at grazing
  vec4 coat;                       // x clear coat, y its roughness, w roughness of the sheen
  vec4 sheen;                      // rgb
  vec4 passed;                     // rgb, the part of what it transmits that its thickness lets through
  vec4 scattering;                 // rgb distances that light spreads below it, w the greatest (m)
  vec4 uv_turn[FULCRUM_TEXTURES];  // rows of a 2 x 2 matrix
  vec4 uv_shift[FULCRUM_TEXTURES];  // xy; z 1: of the second set of coordinates
};

FULCRUM_GPU_SIZE(MaterialData, (7 + 2 * FULCRUM_TEXTURES) * 16);

FULCRUM_GPU_END

#endif
