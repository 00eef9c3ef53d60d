// A surface of one colour, one metallic and one roughness. Included by surface.frag and its variants.

#include "shading.glsl"

void main() {
  vec3 n = normalize(world_normal);
  vec3 v = normalize(frame.eye.xyz - world_position);
  float n_dot_v = max(dot(n, v), 1e-3);
  float metallic = surface.x;
  float roughness = clamp(surface.y, 0.045, 1.0);
  float alpha = roughness * roughness;
  vec3 base = base_colour.rgb * (1.0 - absorbed);
  vec3 f0 = mix(vec3(0.04), base, metallic);
  vec3 diffuse = base * (1.0 - metallic);

  vec3 mirrored = mirrored_from(n, v, roughness);
  Reached reached = what_reaches(n, mirrored, n_dot_v, roughness);
  vec3 radiance = diffuse * mix(reached.sent_on, light_around(n), reached.facing);
  radiance += environment_brdf(f0, roughness, n_dot_v) * mix(reached.sent_on, light_mirrored(mirrored, roughness), reached.mirrored);

  vec3 l;
  float half_width;
  vec3 arriving = key_light(world_position, l, half_width);
  float n_dot_l = dot(n, l);
  if (n_dot_l > 0.0) {
#ifdef FULCRUM_SHADOWED
    arriving *= lit_by_key(world_position, n, n_dot_l);
#endif
    vec3 h = normalize(v + l);
    float n_dot_h = max(dot(n, h), 0.0);
    // Clamped on both sides: seen along the light, rounding takes the product above 1, and no power is defined there.
    vec3 fresnel = f0 + (1.0 - f0) * pow(1.0 - clamp(dot(v, h), 0.0, 1.0), 5.0);
    // Intensity is irradiance / pi, so pi stands before the specular lobe and not under the diffuse one.
    vec3 specular = fresnel * (kPi * ggx(n_dot_h, widened(alpha, half_width)) * visibility(n_dot_l, n_dot_v, alpha));
    radiance += arriving * n_dot_l * (diffuse * (1.0 - fresnel) + specular);
  }
  colour = vec4(to_target(radiance), 1.0);
}
