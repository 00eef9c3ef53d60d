// The lights that models bring. Included by shading.glsl.
//
// How they fade: glTF 2.0, KHR_lights_punctual, "Range Property" and "Inner and Outer Cone Angles".

#include "../shared/light.h"

layout(std140, set = 0, binding = 10) uniform Lights { LightsData lights; };

// A point of no size would be a spark that comes and goes from pixel to pixel where something mirrors it: there it is a
// degree across, as the key light is by default.
const float kPointHalfWidth = 0.0087275;

int lights_of_models() { return int(LOOK >> FULCRUM_LOOK_LIGHTS_SHIFT); }

// Light that arrives from one of them, and the direction to it.
vec3 punctual_light(int which, vec3 position, out vec3 l) {
  LightData light = lights.each[which];
  // One formula for both kinds: where a shader branches on uniforms alone, lavapipe compiles it anew at each binding.
  vec3 to_light = mix(-light.direction.xyz, light.position.xyz - position, light.position.w);
  float distance2 = max(dot(to_light, to_light), 1e-12);
  l = to_light * inversesqrt(distance2);
  float cone = clamp(dot(-l, light.direction.xyz) * light.fade.x + light.fade.y, 0.0, 1.0);
  float part = distance2 * light.fade.z;
  float within = max(1.0 - part * part, 0.0);
  return light.colour.rgb * (cone * cone * within / distance2);
}
