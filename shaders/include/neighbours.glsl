// What a mirror shows of what stands near it, by a cone that is followed through a volume. Included by shading.glsl.
//
// C. Crassin et al., "Interactive Indirect Illumination Using Voxel Cone Tracing", 2011.

const int kMostSteps = 32;
const int kFineSteps = 20;  // of these: the others go as far as the volume does, however long they are for that
const float kStep = 0.6;   // of the cone's width
const float kGain = 1.15;   // a wall that a step just misses is still one
const float kOff = 1.5;    // voxels: off the surface, which fills those that it lies in

// rgb: radiance from what the cone meets, a: the part of it that this hides.
vec4 neighbours(vec3 n, vec3 d, float roughness) {
  vec3 scale = frame.mirror_from_world.xyz;
  float voxel = frame.mirror_from_world.w;
  vec3 from = (world_position + n * (kOff * voxel)) * scale + frame.mirror_low.xyz;
  vec3 along = d * scale;
  // Where the ray goes in and out of the volume.
  vec3 slope = 1.0 / (abs(along) + 1e-9);
  vec3 middle = (0.5 - from) * sign(along) * slope;
  vec3 ins = middle - 0.5 * slope;
  vec3 outs = middle + 0.5 * slope;
  float way = max(max(ins.x, ins.y), max(ins.z, 0.5 * voxel));
  float end = min(outs.x, min(outs.y, outs.z));
  // Half of what GGX mirrors is within twice the angle whose tangent is alpha; voxels are as wide again as their edges.
  float spread = 2.0 * roughness * roughness;
  float climb = max(dot(n, d), 0.0);
  vec4 met = vec4(0.0);
  for (int i = 0; i < kMostSteps && way < end && met.a < 0.98; ++i) {
    // No wider than it is high above the surface, or it met that.
    float widest = (kOff * voxel + climb * way) / 1.5;
    float crossing = i < kFineSteps ? 0.0 : (end - way) / float(kMostSteps - i);
    float width = max(min(max(spread * way, crossing / kStep), widest), voxel);
    vec4 here = textureLod(standing_mirrored, from + along * way, min(log2(width / voxel), frame.mirror_low.w));
    // What is behind something is mostly hidden by the same of it: of both, the more counts.
    float hides = min(kGain * here.a, 1.0);
    met += vec4(here.rgb / max(here.a, 1e-3), 1.0) * max(hides - met.a, 0.0);
    way += max(kStep * width, crossing);
  }
  return met;
}
