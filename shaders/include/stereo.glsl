// Two eyes' pictures and what lies at the screen. Included by stereo_*.frag, of which each is one mode.

// Whether anything can lie at the screen; else its image is another.
layout(constant_id = 0) const uint kHasScreen = 1;

layout(set = 0, binding = 0) uniform sampler2D left_eye;  // sRGB encoded, as all here
layout(set = 0, binding = 1) uniform sampler2D right_eye;
layout(set = 0, binding = 2) uniform sampler2D at_screen;  // premultiplied; as large as the picture

vec3 left_at(ivec2 pixel) { return texelFetch(left_eye, pixel, 0).rgb; }
vec3 right_at(ivec2 pixel) { return texelFetch(right_eye, pixel, 0).rgb; }

vec4 with_screen(vec3 seen, vec2 uv) {
  if (kHasScreen == 0) {
    return vec4(seen, 1.0);
  }
  vec4 over = texture(at_screen, uv);
  return vec4(over.rgb + (1.0 - over.a) * seen, 1.0);
}
