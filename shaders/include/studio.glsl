// The surroundings that metal mirrors: a photographer's studio, written as formulas so that no image has to be made,
// stored or filtered. Radiance for a direction, already blurred for the roughness of the surface that mirrors it.
#ifndef FULCRUM_STUDIO_GLSL
#define FULCRUM_STUDIO_GLSL

// A rectangular light infinitely far away: direction to its middle, half width and half height as tangents. The list
// is a macro and not an array: each use is then a formula with constants, where an index would be a memory access.
struct SoftBox {
  vec3 towards;
  vec3 across;
  vec2 half_size;
  vec3 radiance;
};

#define FULCRUM_FOR_EACH_BOX(use)                                                                                \
  /* two tubes above */                                                                                          \
  use(SoftBox(vec3(0.3162, 0.9487, 0.0), vec3(0.0, 0.0, 1.0), vec2(1.1, 0.17), vec3(7.0, 6.8, 6.4)))             \
  use(SoftBox(vec3(-0.2425, 0.9701, 0.0), vec3(0.0, 0.0, 1.0), vec2(1.1, 0.17), vec3(7.0, 6.8, 6.4)))            \
  /* a tall strip at the left */                                                                                 \
  use(SoftBox(vec3(-0.8729, 0.2182, 0.4364), vec3(0.4472, 0.0, 0.8944), vec2(0.22, 0.95), vec3(3.6, 3.6, 3.6)))  \
  /* a cool strip behind at the right */                                                                         \
  use(SoftBox(vec3(0.7715, 0.3086, -0.5563), vec3(0.5849, 0.0, 0.8111), vec2(0.30, 0.80), vec3(2.3, 2.7, 3.2)))

float soft_box(SoftBox box, vec3 d, float blur) {
  float facing = dot(d, box.towards);
  if (facing <= 0.05) {
    return 0.0;
  }
  vec2 at = vec2(dot(d, box.across), dot(d, cross(box.towards, box.across))) / facing;
  vec2 inside = smoothstep(box.half_size + blur, box.half_size - blur, abs(at));
  // Blurred beyond its own size, a box grows and so must fade, or rough surfaces would gain light.
  vec2 grown = min(vec2(1.0), box.half_size / max(vec2(blur), vec2(0.001)));
  return inside.x * inside.y * grown.x * grown.y * smoothstep(0.05, 0.35, facing);
}

vec3 studio(vec3 d, float roughness, vec3 sky, vec3 ground) {
  float blur = 0.08 + 0.9 * roughness * roughness;
  float up = smoothstep(-blur, blur, d.y);
  // Walls fall off towards the horizon: this is the dark line that makes a chromed tube read as round.
  vec3 above = sky * mix(0.35, 1.0, mix(smoothstep(0.0, 0.7, d.y), 0.5, roughness));
  vec3 below = ground * mix(0.45, 1.0, mix(smoothstep(0.0, -0.8, d.y), 0.5, roughness));
  vec3 radiance = mix(below, above, up);
  float brightness = max(sky.r, max(sky.g, sky.b));
#define FULCRUM_ADD(box) radiance += box.radiance * (brightness * soft_box(box, d, blur));
  FULCRUM_FOR_EACH_BOX(FULCRUM_ADD)
#undef FULCRUM_ADD
  return radiance;
}

float lit_from(SoftBox box, vec3 n) {
  float wrapped = max(0.0, 0.25 + 0.75 * dot(n, box.towards));
  return wrapped * wrapped * box.half_size.x * box.half_size.y;
}

// Irradiance / pi of the same studio, smooth enough to be written down directly.
vec3 studio_diffuse(vec3 n, vec3 sky, vec3 ground) {
  vec3 boxes = vec3(0.0);
#define FULCRUM_ADD(box) boxes += box.radiance * lit_from(box, n);
  FULCRUM_FOR_EACH_BOX(FULCRUM_ADD)
#undef FULCRUM_ADD
  return mix(ground, sky, 0.5 + 0.5 * n.y) * 0.65 + boxes * (0.22 * max(sky.r, max(sky.g, sky.b)));
}

#endif
