// Where a direction is on the map of the surroundings (engine/render/octahedral_map.h). Included by shading.glsl and
// background_around.frag.

vec2 place_on_map(vec3 d) {
  d /= abs(d.x) + abs(d.y) + abs(d.z);
  vec2 folded = (1.0 - abs(d.zx)) * vec2(d.x < 0.0 ? -1.0 : 1.0, d.z < 0.0 ? -1.0 : 1.0);
  vec2 at = d.y < 0.0 ? folded : d.xz;
  return 0.5 + 0.375 * at;
}
