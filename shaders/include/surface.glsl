// A surface of one colour, one metallic and one roughness. Included by surface.frag and its variants.

#include "shading.glsl"

void main() {
  vec3 n = unit_normal();
  vec3 v = normalize(frame.eye.xyz - world_position);
  float n_dot_v = max(dot(n, v), 1e-3);
  float metallic = surface.x;
  float given = clamp(surface.y, 0.045, 1.0);
  float alpha = seen_alpha(given * given, curved_in_pixel(n));
  float roughness = sqrt(alpha);
  vec3 base = base_colour.rgb * (1.0 - absorbed);
  vec3 f0 = mix(vec3(0.04), base, metallic);
  vec3 diffuse = base * (1.0 - metallic);

  vec3 mirrored = mirrored_from(n, v, roughness);
  Reached reached = what_reaches(n, mirrored, n_dot_v, roughness);
  vec3 reflected = environment_brdf(f0, roughness, n_dot_v);
  vec3 radiance = diffuse * (1.0 - reflected) * mix(reached.sent_on, light_around(n), reached.facing);
  radiance += reflected * mirror_shows(reached, n, mirrored, roughness, metallic);

  Lobes lobes = Lobes(diffuse, f0, 1.0, alpha);
  vec3 l;
  float half_width;
  vec3 arriving = key_light(world_position, l, half_width);
  float n_dot_l = dot(n, l);
  if (n_dot_l > 0.0) {
#ifdef FULCRUM_SHADOWED
    arriving *= lit_by_key(world_position, n, n_dot_l);
#endif
    radiance += arriving * n_dot_l * sent_by(lobes, n, v, n_dot_v, normalize(v + l), n_dot_l, half_width);
  }
#ifdef FULCRUM_PUNCTUAL
  for (int i = 0; i < lights_of_models(); ++i) {
    arriving = punctual_light(i, world_position, l);
    n_dot_l = dot(n, l);
    if (n_dot_l > 0.0) {
      radiance += arriving * n_dot_l * sent_by(lobes, n, v, n_dot_v, normalize(v + l), n_dot_l, kPointHalfWidth);
    }
  }
#endif
  colour = vec4(to_target(radiance), 1.0);
}
