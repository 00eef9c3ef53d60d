// A surface with what else glTF 2.0 and its extensions know. Included by detailed.frag and its variants. What
// a material does not have is not in its pipeline: LOOK is a constant when that is made.
//
// Tangents from derivatives: after C. Schueler, "Normal Mapping without Precomputed Tangents", ShaderX 5, 2006. Clear coat and
// the layering of sheen: glTF 2.0, KHR_materials_clearcoat and KHR_materials_sheen. Sheen: A. Estevez and C. Kulla,
// "Production Friendly Microfacet Sheen BRDF", 2017, with the visibility of D. Neubelt and M. Pettineo, "Crafting a
// Next-Gen Material Pipeline for The Order: 1886", 2013.

#include "holes.glsl"
#include "shading.glsl"

layout(set = 1, binding = 0) uniform Material { MaterialData material; };
layout(set = 1, binding = 1) uniform sampler2D base_map;
layout(set = 1, binding = 2) uniform sampler2D metal_rough_map;
layout(set = 1, binding = 3) uniform sampler2D normal_map;
layout(set = 1, binding = 4) uniform sampler2D occlusion_map;
layout(set = 1, binding = 5) uniform sampler2D emissive_map;

layout(location = 5) in vec4 uv;
#if !defined(FULCRUM_ENTERING) && !defined(FULCRUM_SCATTERED)
// `hidden` says of each colour how much of what is behind is not seen. It is written where light passes, and read where the
// device blends by two colours; elsewhere the alpha of `colour` says so of all three.
layout(location = 0, index = 1) out vec4 hidden;
#endif

#ifdef FULCRUM_SCATTERED
#include "scattered.glsl"
#endif

bool has_texture(int which) { return has(1u << which); }

vec2 uv_of(int which) {
  vec2 from = material.uv_shift[which].z > 0.5 ? uv.zw : uv.xy;
  vec4 turn = material.uv_turn[which];
  return vec2(dot(turn.xy, from), dot(turn.zw, from)) + material.uv_shift[which].xy;
}

// A normal of a map, whose frame is that of glTF 2.0 (3.9.3): along the surface the way in which u alone grows, and square to
// it; both of unit length, however much a picture is stretched. v grows downwards in it, and a map's green points up.
vec3 mapped(vec3 n, vec2 at, vec3 bend) {
  vec3 dx = dFdx(world_position);
  vec3 dy = dFdy(world_position);
  vec2 du = dFdx(at);
  vec2 dv = dFdy(at);
  vec3 across_y = cross(dy, n);
  vec3 across_x = cross(n, dx);
  vec3 along_u = across_y * du.x + across_x * dv.x;  // where u grows fastest, and v
  vec3 along_v = across_y * du.y + across_x * dv.y;
  float length2 = dot(along_v, along_v);
  float other2 = dot(along_u, along_u);
  if (!(min(length2, other2) > 1e-8 * max(length2, other2))) {
    return n;  // no coordinates, one of the two is the same all over the triangle, or they differ beyond all numbers
  }
  vec3 tangent = cross(along_v, n);  // v stays as it is that way
  tangent *= sign(dot(tangent, along_u));
  float scale = sign(dot(dx, across_y)) * inversesqrt(length2);
  return normalize(tangent * (scale * bend.x) - along_v * (scale * bend.y) + n * bend.z);
}

// The part of light that gets to a bent normal past the surface that it stands for: all where the light is higher above that
// than above the bent one, none from below it. M. J.-Y. Chiang, Y. K. Li and B. Burley, "Taming the Shadow Terminator", 2019.
float past_surface(vec3 n, vec3 geometric, vec3 l, float n_dot_l) {
  if (!has_texture(FULCRUM_TEXTURE_NORMAL)) {
    return 1.0;
  }
  float part = clamp(dot(geometric, l) / max(n_dot_l * dot(geometric, n), 1e-6), 0.0, 1.0);
  return part * (1.0 + part * (1.0 - part));
}

const float kLeastSheen = 0.2;  // of its roughness: below, this lobe sends on more light than it gets

// The part of even light from all around that a sheen sends to the eye: the integral of its lobe, at most 1, fitted over
// roughnesses of 0.2 to 1.
float sheen_albedo(float n_dot_v, float roughness) {
  vec3 s = vec3(1.0, 1.0 / roughness, 1.0 / (roughness * roughness));
  float k0 = dot(s, vec3(-0.967, 0.500, -0.038));
  float k1 = dot(s, vec3(-0.406, -1.716, 0.078));
  float k2 = dot(s, vec3(-0.404, 2.366, -0.312));
  float k3 = dot(s, vec3(0.883, -2.024, 0.082));
  return min(exp(k0 + n_dot_v * (k1 + n_dot_v * (k2 + n_dot_v * k3))), 1.0);
}

float sheen_lobe(float n_dot_h, float n_dot_l, float n_dot_v, float roughness) {
  float inverse = 1.0 / (roughness * roughness);
  float sine2 = max(1.0 - n_dot_h * n_dot_h, 0.0078125);
  float d = (2.0 + inverse) * pow(sine2, 0.5 * inverse) / (2.0 * kPi);
  return d / (4.0 * (n_dot_l + n_dot_v - n_dot_l * n_dot_v));
}

// As sent_by(), of all that is below a clear coat.
vec3 sent_from_below(Lobes lobes, float below_sheen, vec3 n, vec3 v, float n_dot_v, vec3 h, float n_dot_l, float half_width) {
  vec3 sent = sent_by(lobes, n, v, n_dot_v, h, n_dot_l, half_width) * below_sheen;
  if (has(FULCRUM_LOOK_SHEEN)) {
    float n_dot_h = max(dot(n, h), 0.0);
    sent += material.sheen.rgb * (kPi * sheen_lobe(n_dot_h, n_dot_l, n_dot_v, max(material.coat.w, kLeastSheen)));
  }
  return sent;
}

// What a clear coat mirrors of light from l, where `lit`, the cosine to it, is above 0 and its irradiance / pi is 1.
float sent_by_coat(float alpha, vec3 geometric, vec3 v, float g_dot_v, vec3 h, float lit, float half_width) {
  float fresnel = 0.04 + 0.96 * pow(1.0 - clamp(dot(v, h), 0.0, 1.0), 5.0);
  float g_dot_h = max(dot(geometric, h), 0.0);
  return fresnel * kPi * ggx(g_dot_h, widened(alpha, half_width)) * visibility(lit, g_dot_v, alpha);
}

// A texture cuts the surface out at this pixel. It is discarded only at the end, since derivatives in the pixels beside it
// need its values until then.
bool is_cut_out = false;
float alpha_of_pixel = 1.0;  // of one that has several samples, and holes

void find_colour() {
  vec4 base = vec4(base_colour.rgb * (1.0 - absorbed), material.amounts.z);
  is_cut_out = has(FULCRUM_LOOK_MASK) && base.a < material.emission.w;
  if (has_texture(FULCRUM_TEXTURE_BASE)) {
    vec2 at = uv_of(FULCRUM_TEXTURE_BASE);
    vec4 texel = texture(base_map, at);
    base *= texel;
    if (has(FULCRUM_LOOK_MASK)) {
      vec2 part = part_there(base_map, at, texel.a, material.emission.w / max(material.amounts.z, 1e-6));
      alpha_of_pixel = alpha_of_samples(part);
      is_cut_out = has(FULCRUM_LOOK_SAMPLES) ? alpha_of_pixel <= 0.0 : !is_there(part);
    }
  }
  float cover = has(FULCRUM_LOOK_COVER) ? base.a : 1.0;
#ifndef FULCRUM_ENTERING
  if (has(FULCRUM_LOOK_UNLIT)) {
    colour = vec4(to_target(base.rgb) * cover, cover);
    return;
  }
#endif

  vec3 geometric = unit_normal();
  float curved = curved_in_pixel(geometric);
  vec3 n = geometric;
  float spread = 0.0;
  if (has_texture(FULCRUM_TEXTURE_NORMAL)) {
    vec2 at = uv_of(FULCRUM_TEXTURE_NORMAL);
    vec4 relief = texture(normal_map, at);
    vec3 scale = vec3(material.amounts.xx, 1.0);
    n = mapped(geometric, at, (relief.xyz * 2.0 - 1.0) * scale);
    spread = relief.a * material.amounts.x;
  }
  if (has(FULCRUM_LOOK_DOUBLE_SIDED) && !gl_FrontFacing) {  // a bump is a dent from behind
    geometric = -geometric;
    n = -n;
  }
  vec3 v = normalize(frame.eye.xyz - world_position);
  float n_dot_v = clamp(dot(n, v), 1e-3, 1.0);  // rounding takes it above 1, where powers of the rest are not defined
  float metallic = surface.x;
  float roughness = surface.y;
  if (has_texture(FULCRUM_TEXTURE_METAL_ROUGH)) {
    vec4 found = texture(metal_rough_map, uv_of(FULCRUM_TEXTURE_METAL_ROUGH));
    metallic *= found.b;
    roughness *= found.g;
  }
  roughness = clamp(roughness, 0.045, 1.0);
  float alpha = seen_alpha(roughness * roughness, curved + spread * spread);
  roughness = sqrt(alpha);
  float coat_rough = clamp(material.coat.y, 0.045, 1.0);
  float coat_alpha = seen_alpha(coat_rough * coat_rough, curved);  // textures do not bend it
  vec3 f0 = mix(material.specular.rgb, base.rgb, metallic);
  float f90 = mix(material.specular.w, 1.0, metallic);
  vec3 diffuse = base.rgb * (1.0 - metallic);
  vec3 through = vec3(0.0);  // the part of what is behind that is seen
  if (has(FULCRUM_LOOK_TRANSMISSION)) {
    float passes = material.amounts.w * (1.0 - metallic);
    diffuse *= 1.0 - passes;
    vec3 reflected = f0 + (f90 - f0) * pow(1.0 - n_dot_v, 5.0);
    through = passes * (1.0 - reflected) * base.rgb * material.passed.rgb;
  }
  float open = 1.0;
  if (has_texture(FULCRUM_TEXTURE_OCCLUSION)) {
    float found = texture(occlusion_map, uv_of(FULCRUM_TEXTURE_OCCLUSION)).r;
    open = 1.0 + material.amounts.y * (found - 1.0);
  }

  vec3 mirrored = mirrored_from(n, v, roughness);
  Reached reached = what_reaches(n, mirrored, n_dot_v, roughness);
  vec3 around = mix(reached.sent_on, light_around(n), reached.facing) * open;
  vec2 scale_bias = environment_scale_bias(roughness, n_dot_v);
  vec3 reflected_around = f0 * scale_bias.x + f90 * scale_bias.y;
#ifdef FULCRUM_ENTERING
  vec3 entering = (1.0 - reflected_around) * around;  // irradiance / pi
  vec3 radiance = vec3(0.0);
#else
  vec3 radiance = diffuse * (1.0 - reflected_around) * around;
#endif
  radiance += reflected_around *
              mirror_shows(reached, n, mirrored, roughness, metallic) * open;
  float below_sheen = 1.0;
  if (has(FULCRUM_LOOK_SHEEN)) {
    float albedo = sheen_albedo(n_dot_v, max(material.coat.w, kLeastSheen));
    below_sheen = 1.0 - max(material.sheen.r, max(material.sheen.g, material.sheen.b)) * albedo;
    radiance = radiance * below_sheen + material.sheen.rgb * albedo * around;
    through *= below_sheen;
  }

#ifdef FULCRUM_ENTERING
  Lobes lobes = Lobes(vec3(0.0), f0, f90, alpha);  // what it does not mirror enters it
#else
  Lobes lobes = Lobes(diffuse, f0, f90, alpha);
#endif
  vec3 l;
  float half_width;
  vec3 arriving = key_light(world_position, l, half_width);
  float n_dot_l = dot(n, l);
  float lit = dot(geometric, l);
#ifdef FULCRUM_SHADOWED
  if (lit > 0.0) {
    arriving *= lit_by_key(world_position, geometric, lit);
  }
#endif
  vec3 h = normalize(v + l);
  if (n_dot_l > 0.0) {
    vec3 past = arriving * (n_dot_l * past_surface(n, geometric, l, n_dot_l));
    radiance += past * sent_from_below(lobes, below_sheen, n, v, n_dot_v, h, n_dot_l, half_width);
#ifdef FULCRUM_ENTERING
    entering += past * (1.0 - fresnel_of(lobes, v, h));
#endif
  }
#ifdef FULCRUM_PUNCTUAL
  vec3 coat_lit = vec3(0.0);
  for (int i = 0; i < lights_of_models(); ++i) {
    vec3 from;
    vec3 light = punctual_light(i, world_position, from);
    vec3 half_way = normalize(v + from);
    float n_dot_from = dot(n, from);
    if (n_dot_from > 0.0) {
      vec3 past = light * (n_dot_from * past_surface(n, geometric, from, n_dot_from));
      radiance += past * sent_from_below(lobes, below_sheen, n, v, n_dot_v, half_way, n_dot_from, kPointHalfWidth);
#ifdef FULCRUM_ENTERING
      entering += past * (1.0 - fresnel_of(lobes, v, half_way));
#endif
    }
    float lit_from = dot(geometric, from);
    if (has(FULCRUM_LOOK_COAT) && lit_from > 0.0) {
      coat_lit += light * lit_from * sent_by_coat(coat_alpha, geometric, v, clamp(dot(geometric, v), 1e-3, 1.0), half_way, lit_from, kPointHalfWidth);
    }
  }
#endif
  if (has(FULCRUM_LOOK_EMISSION)) {
    vec3 emitted = material.emission.rgb;
    if (has_texture(FULCRUM_TEXTURE_EMISSIVE)) {
      emitted *= texture(emissive_map, uv_of(FULCRUM_TEXTURE_EMISSIVE)).rgb;
    }
    radiance += emitted;
  }
  if (has(FULCRUM_LOOK_COAT)) {
    float g_dot_v = clamp(dot(geometric, v), 1e-3, 1.0);
    float rough = sqrt(coat_alpha);
    vec2 coat = environment_scale_bias(rough, g_dot_v);
    vec3 on_top = vec3(0.0);
    on_top += (0.04 * coat.x + coat.y) *
              mix(reached.sent_on, light_mirrored(mirrored_from(geometric, v, rough), rough), reached.mirrored) * open;
    if (lit > 0.0) {
      on_top += arriving * lit * sent_by_coat(coat_alpha, geometric, v, g_dot_v, h, lit, half_width);
    }
#ifdef FULCRUM_PUNCTUAL
    on_top += coat_lit;
#endif
    float taken = material.coat.x * (0.04 + 0.96 * pow(1.0 - g_dot_v, 5.0));
    radiance = radiance * (1.0 - taken) + material.coat.x * on_top;
    through *= 1.0 - taken;
  }
#ifdef FULCRUM_ENTERING
  colour = packed_light(entering, radiance, tag_of(1.0 / gl_FragCoord.w, uint(surface.z + 0.5)));
#elif defined(FULCRUM_SCATTERED)
  // The light that this pass has found itself is not used, and not compiled.
  float below_coat = 1.0;
  if (has(FULCRUM_LOOK_COAT)) {
    below_coat -= material.coat.x * (0.04 + 0.96 * pow(1.0 - clamp(dot(geometric, v), 1e-3, 1.0), 5.0));
  }
  Below below = light_from_below(light_around(n));
  colour = vec4(to_target(diffuse * (below_sheen * below_coat) * below.comes_out + below.gloss), 1.0);
#else
  colour = vec4(to_target(radiance) * cover, cover * (1.0 - dot(through, vec3(0.2126, 0.7152, 0.0722))));
  if (has(FULCRUM_LOOK_TRANSMISSION)) hidden = vec4(cover * (1.0 - through), colour.a);
#endif
}

void main() {
  find_colour();
  if (is_cut_out) {
    discard;
  }
#ifndef FULCRUM_ENTERING
  if (has(FULCRUM_LOOK_SAMPLES)) {
    colour.a = alpha_of_pixel;
  }
#endif
}
