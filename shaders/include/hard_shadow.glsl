// Shadows with edges of one width, that of a few texels. Included by shading.glsl.

// The mean of 3 x 3 bilinear comparisons, taken with four gathers: their 4 x 4 texels are all that the nine would read,
// on a software rasteriser the nine alone cost half a frame. A texel between two samples counts fully, one at the rim by
// how far the filter reaches into it.
float filtered_shadow(vec2 uv, float depth) {
  depth = min(depth, 1.0);  // what is beyond the map's depth has all of the map before it
  vec2 texel = uv / frame.shadow.x - 0.5;
  vec2 first = floor(texel);
  vec2 part = texel - first;
  vec2 low = first * frame.shadow.x;  // the corner that the texels of a gather have in common
  vec2 high = low + 2.0 * frame.shadow.x;
  vec4 a = textureGather(shadow_map, low, depth);
  vec4 b = textureGather(shadow_map, vec2(high.x, low.y), depth);
  vec4 c = textureGather(shadow_map, vec2(low.x, high.y), depth);
  vec4 d = textureGather(shadow_map, high, depth);
  // A gather's order: lower left, lower right, upper right, upper left, where lower is the greater v.
  vec4 left = vec4(1.0 - part.x, 1.0, 1.0, 1.0 - part.x);
  vec4 right = vec4(1.0, part.x, part.x, 1.0);
  vec4 top = vec4(1.0, 1.0, 1.0 - part.y, 1.0 - part.y);
  vec4 bottom = vec4(part.y, part.y, 1.0, 1.0);
  return (dot(a, left * top) + dot(b, right * top) + dot(c, left * bottom) + dot(d, right * bottom)) / 9.0;
}
