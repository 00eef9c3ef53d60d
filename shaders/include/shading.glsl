// Metal-rough shading: a key light and what is all around. Included by surface.glsl and detailed.glsl.
//
// GGX: B. Walter et al., "Microfacet Models for Refraction", EGSR 2007. Joint Smith visibility, fast form, and
// Schlick's Fresnel: glTF 2.0 specification, appendix B; S. Lagarde, "Moving Frostbite to PBR", 2014.
// Split sum: B. Karis, "Real Shading in Unreal Engine 4", 2013; here without a table.

#include "../shared/frame.h"
#include "../shared/material.h"
#include "octahedral.glsl"
#include "range.glsl"

layout(std140, set = 0, binding = 0) uniform Frame { FrameData frame; };
layout(set = 0, binding = 4) uniform sampler2D surroundings;  // engine/render/environment.h
layout(set = 0, binding = 6) uniform sampler3D standing_open;      // engine/render/light_volume.h
layout(set = 0, binding = 7) uniform sampler3D standing_received;
layout(set = 0, binding = 8) uniform sampler3D standing_sent_on;
layout(set = 0, binding = 13) uniform sampler3D standing_mirrored;  // engine/render/mirror_volume.h
layout(set = 0, binding = 14) uniform sampler3D standing_mirrored_sides;
#ifdef FULCRUM_OCCLUDED
layout(set = 0, binding = 5) uniform sampler2D occlusion;
#endif
#ifdef FULCRUM_SHADOWED
layout(set = 0, binding = 3) uniform sampler2DShadow shadow_map;
#endif

layout(location = 0) in vec3 world_position;
layout(location = 1) in vec3 world_normal;
layout(location = 2) flat in vec4 base_colour;
layout(location = 3) flat in vec4 surface;
// Within the triangle: extrapolated to the middle of a pixel at an outline, colours that change fast get out of range.
layout(location = 4) centroid in vec3 absorbed;
#ifdef FULCRUM_ENTERING
#include "scatter_tag.glsl"
layout(location = 0) out uvec4 colour;
#else
layout(location = 0) out vec4 colour;
#endif

// What the pipeline is built for: bits FULCRUM_LOOK_.
layout(constant_id = 0) const uint LOOK = 0u;

bool has(uint look) { return (LOOK & look) != 0u; }

const float kPi = 3.14159265;

#ifdef FULCRUM_SHADOWED
#ifdef FULCRUM_SOFT
#include "soft_shadow.glsl"
#else
#include "hard_shadow.glsl"
#endif

// 0 in shadow .. 1 lit.
float lit_by_key(vec3 position, vec3 n, float n_dot_l) {
  // Moved off the surface by more where light grazes it: depth in the map is constant over a whole texel. It is
  // moved as well by what its coarse triangles may be off the surface that they stand for, since other triangles of it are
  // in the map. w is the distance along a spot's axis, and 1 of directional light.
  vec4 axis = vec4(frame.shadow_from_world[0].w, frame.shadow_from_world[1].w, frame.shadow_from_world[2].w,
                   frame.shadow_from_world[3].w);
  float texel = frame.shadow.y * dot(axis, vec4(position, 1.0));
  float off = frame.camera_up.w * distance(position, frame.eye.xyz);
  vec3 moved = position + n * (texel * (0.6 + 1.8 * (1.0 - n_dot_l)) + off);
  vec4 clip = frame.shadow_from_world * vec4(moved, 1.0);
  vec3 at = clip.xyz / clip.w;
  return filtered_shadow(vec2(0.5 + 0.5 * at.x, 0.5 - 0.5 * at.y), at.z);
}
#endif

// A mesh may have normals of no length, which have no direction; one that is no number would spoil the pixels beside it.
vec3 unit_normal() { return world_normal * inversesqrt(max(dot(world_normal, world_normal), 1e-30)); }

// How much a surface turns within a pixel: the sum of the variances of its slopes in both directions, where places within a
// pixel have a variance of 1 / 12 along each side. n: unit, before textures bend it.
// Y. Tokuyoshi and A. Kaplanyan, "Improved Geometric Specular Antialiasing", 2019, with a narrower pixel, and its limit.
float curved_in_pixel(vec3 n) {
  vec3 dx = dFdx(n);
  vec3 dy = dFdy(n);
  return min((dot(dx, dx) + dot(dy, dy)) / 12.0, 0.18);
}

// The alpha of what a pixel shows: a piece of surface that faces many ways mirrors as a rougher one does. variances: the sum
// of those of its slopes in both directions. Of Beckmann's lobe, which GGX's is taken for here, alpha^2 is twice the variance
// in one direction, and the mean of the two stands for both.
float seen_alpha(float alpha, float variances) { return sqrt(min(alpha * alpha + variances, 1.0)); }

// Irradiance / pi from all around, of a surface that faces n.
vec3 light_around(vec3 n) {
  vec4 first = vec4(n, 1.0);
  vec4 second = n.xyzz * n.yzzx;
  vec3 sum = vec3(dot(frame.around_linear[0], first), dot(frame.around_linear[1], first), dot(frame.around_linear[2], first));
  sum += vec3(dot(frame.around_quadratic[0], second), dot(frame.around_quadratic[1], second), dot(frame.around_quadratic[2], second));
  return max(sum + frame.around_rest.rgb * (n.x * n.x - n.y * n.y), vec3(0.0));
}

// Where a mirror of this roughness has most of its light from: the rougher it is, the nearer to its normal (Lagarde 2014,
// 4.9.3). Unit.
vec3 mirrored_from(vec3 n, vec3 v, float roughness) {
  float alpha = roughness * roughness;
  float smoothness = 1.0 - alpha;
  return normalize(mix(n, reflect(-v, n), smoothness * (sqrt(smoothness) + alpha)));
}

// Radiance from all around that a mirror of this roughness shows there, where nothing hides it.
vec3 light_mirrored(vec3 d, float roughness) {
  float level = max(roughness - 0.08, 0.0) * (5.0 / 0.92);
  return textureLod(surroundings, place_on_map(d), level).rgb;
}

// The part of the light from all around that near things let through, from the four nearest pixels of an image of half
// the size, of those that lie on this surface; 1 where none does.
float open_part() {
#ifdef FULCRUM_OCCLUDED
  float z = 1.0 / gl_FragCoord.w;
  float near_enough = 0.01 * z + 3.0 * fwidth(z);
  vec2 clip = (frame.clip_from_world * vec4(world_position, 1.0)).xy * gl_FragCoord.w;
  vec2 at = (vec2(0.5) + vec2(0.5, -0.5) * clip) * frame.occlusion.xy - 0.5;
  vec2 low = floor(at);
  vec2 part = at - low;
  vec2 corner = (low + 1.0) / frame.occlusion.xy;
  // A gather's order: lower left, lower right, upper right, upper left, where lower is the greater v.
  vec4 open = textureGather(occlusion, corner, 0);
  vec4 far = textureGather(occlusion, corner, 1);
  vec4 weights = vec4(1.0 - part.x, part.x, part.x, 1.0 - part.x) * vec4(part.y, part.y, 1.0 - part.y, 1.0 - part.y);
  weights *= max(1.0 - abs(far - z) / near_enough, 0.0);
  return (dot(weights, open) + 1e-3) / (dot(weights, vec4(1.0)) + 1e-3);
#else
  return 1.0;
#endif
}

// The parts of the light from all around that reach a surface, and what its mirror shows.
struct Reached {
  float facing;
  float mirrored;
  float near;    // of what is mirrored, by what the image shows alone
  vec3 sent_on;  // radiance from where the rest is hidden
};

// What stands hides by the volume, what is near and seen by the image; most of it is in both. The image's part of what a
// mirror shows: S. Lagarde, 2014.
Reached what_reaches(vec3 n, vec3 d, float n_dot_v, float roughness) {
  vec3 at = frame.volume_from_world.xyz * (world_position + n * frame.volume_from_world.w) + frame.volume_low.xyz;
  // Beyond the volume, what is in it hides less and less.
  float away = length(max(abs(at - 0.5) - 0.5, vec3(0.0)) / frame.volume_from_world.xyz) * frame.volume_low.w;
  float held = 1.0 / (1.0 + away * away);
  vec4 received = mix(frame.unhidden, texture(standing_received, at), held);
  vec4 open = mix(vec4(0.0, 0.0, 0.0, 1.0), texture(standing_open, at), held);
  // The part of the light that there is; where there is next to none this way, of an even sky.
  float nothing_hidden = dot(frame.unhidden.xyz, n) + frame.unhidden.w;
  float part = nothing_hidden > max(0.02 * frame.unhidden.w, 1e-6) ? (dot(received.xyz, n) + received.w) / nothing_hidden
                                                                   : dot(open.xyz, n) * (2.0 / 3.0) + open.w;
  float near = open_part();
  float near_mirrored = clamp(pow(n_dot_v + near, exp2(-16.0 * roughness - 1.0)) - 1.0 + near, 0.0, 1.0);
  Reached reached;
  reached.sent_on = texture(standing_sent_on, at).rgb;
  reached.facing = min(clamp(part, 0.0, 1.0), near);
  reached.near = near_mirrored;
  reached.mirrored = min(clamp(dot(open.xyz, d) + open.w, 0.0, 1.0), near_mirrored);
  return reached;
}

#include "neighbours.glsl"

// What a mirror shows of all around it. Of metal, neighbours are followed, not only their mean, unless it is so rough that
// this tells as much, or so smooth that voxels would be seen. The rim of what GGX mirrors, which is wider the rougher the metal
// is, is beside the cone that is followed, and shows their mean.
vec3 mirror_shows(Reached reached, vec3 n, vec3 d, float roughness, float metallic) {
  vec3 far = light_mirrored(d, roughness);
  vec3 shown = mix(reached.sent_on, far, reached.mirrored);
  float rim = 1.2 * roughness * roughness;
  float follows = metallic * (1.0 - rim) * smoothstep(0.06, 0.12, roughness) * (1.0 - smoothstep(0.6, 0.7, roughness));
  if (has(FULCRUM_LOOK_NEIGHBOURS) && follows > 0.0) {
    vec4 near = neighbours(n, d, roughness);
    shown = mix(shown, near.rgb + mix(reached.sent_on, far, reached.near) * (1.0 - near.a), follows);
  }
  return shown;
}

float ggx(float n_dot_h, float alpha) {
  float a2 = alpha * alpha;
  float d = n_dot_h * n_dot_h * (a2 - 1.0) + 1.0;
  return a2 / (kPi * d * d);
}

float visibility(float n_dot_l, float n_dot_v, float alpha) {
  float l = n_dot_v * (n_dot_l * (1.0 - alpha) + alpha);
  float v = n_dot_l * (n_dot_v * (1.0 - alpha) + alpha);
  return 0.5 / max(l + v, 1e-4);
}

// What stands before the reflectances at normal and at grazing incidence, of even light from all around: the integrals of
// GGX with the exact visibility of height-correlated masking, of which lights have the fast form above; fitted to 0.013
// and 0.012, root mean square.
vec2 environment_scale_bias(float roughness, float n_dot_v) {
  vec4 r = vec4(1.0, roughness, roughness * roughness, roughness * roughness * roughness);
  vec4 v = vec4(1.0, n_dot_v, n_dot_v * n_dot_v, n_dot_v * n_dot_v * n_dot_v);
  const mat4 kBoth = mat4(1.015, 0.291, -1.016, 0.661,   //
                          -0.911, 1.702, 3.124, -3.266,  //
                          2.157, -9.751, 4.163, 1.677,   //
                          -1.372, 6.285, -4.771, 0.286);
  float both = clamp(dot(v, kBoth * r), 0.0, 1.0);
  float grazing = 1.0 - n_dot_v;
  float grazing3 = grazing * grazing * grazing;
  float bias = grazing3 * grazing * grazing * dot(r, vec4(1.331, -6.166, 9.104, -4.266)) +
               grazing3 * dot(r, vec4(-0.106, 2.798, -5.968, 3.324));
  bias = clamp(bias, 0.0, both);
  return vec2(both - bias, bias);
}

vec3 environment_brdf(vec3 f0, float roughness, float n_dot_v) {
  vec2 scale_bias = environment_scale_bias(roughness, n_dot_v);
  return f0 * scale_bias.x + scale_bias.y;
}

// Light that arrives from the key light, the direction to it, and half its width as it is seen from there. A directional
// light is one that is 1 m away from everywhere. No branch tells the two apart: where one depends on uniforms alone, Mesa's
// lavapipe compiles the shader anew whenever a descriptor set is bound.
vec3 key_light(vec3 position, out vec3 l, out float half_width) {
  vec3 to_light = frame.key_position.xyz - frame.key_position.w * position;
  float distance2 = max(dot(to_light, to_light), 1e-8);
  float inverse = inversesqrt(distance2);
  l = to_light * inverse;
  half_width = frame.shadow.w;
  float cone = smoothstep(frame.key_direction.w, frame.key_colour.w, dot(-l, frame.key_direction.xyz));
  float received = cone / (distance2 + half_width * half_width);  // of a disc that faces the place
  half_width *= inverse;
  return frame.key_colour.rgb * received;
}

// The alpha with which a light of no size looks as one of this half width does, which a mirror shows as a disc: the mean
// of GGX over half vectors up to half as far from its middle is the middle of GGX with this alpha.
float widened(float alpha, float half_width) {
  return sqrt(alpha * alpha + 0.25 * half_width * half_width);
}

// What a surface is to a light.
struct Lobes {
  vec3 diffuse;
  vec3 f0;  // reflectance at normal incidence, and at grazing
  float f90;
  float alpha;
};

// The part of light that the surface itself mirrors; h: half way between v and the light.
vec3 fresnel_of(Lobes lobes, vec3 v, vec3 h) {
  // Clamped on both sides: seen along the light, rounding takes the product above 1, and no power is defined there.
  return lobes.f0 + (lobes.f90 - lobes.f0) * pow(1.0 - clamp(dot(v, h), 0.0, 1.0), 5.0);
}

// Radiance that is sent on to v of light from l, where n_dot_l is above 0 and its irradiance / pi facing l is 1; h: half way
// between the two.
vec3 sent_by(Lobes lobes, vec3 n, vec3 v, float n_dot_v, vec3 h, float n_dot_l, float half_width) {
  float n_dot_h = max(dot(n, h), 0.0);
  vec3 fresnel = fresnel_of(lobes, v, h);
  // Intensity is irradiance / pi, so pi stands before the specular lobe and not under the diffuse one.
  vec3 specular =
      fresnel * (kPi * ggx(n_dot_h, widened(lobes.alpha, half_width)) * visibility(n_dot_l, n_dot_v, lobes.alpha));
  return lobes.diffuse * (1.0 - fresnel) + specular;
}

#ifdef FULCRUM_PUNCTUAL
#include "punctual.glsl"
#endif

