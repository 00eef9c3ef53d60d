// What a mirror shows of what stands near it, by a cone that is followed through a volume. Included by shading.glsl.
//
// C. Crassin et al., "Interactive Indirect Illumination Using Voxel Cone Tracing", 2011.

const int kMostSteps = 32;
const int kFineSteps = 20;  // of these: the others go as far as the volume does, however long they are for that
const float kStep = 0.6;    // of the cone's width
const float kWall = 1.25;   // what two steps find together of a wall one voxel thick, wherever and at whichever level they meet it
const float kOff = 1.5;     // voxels: off the surface, which fills those that it lies in

// standing_mirrored_sides has in its lower half (part 0) how surfaces face in the mean, in its upper one (1) the same weighted by
// the light that they send on. This is one of the two, with nothing of the other mixed in.
vec3 of_sides(vec3 at, float level, float part) {
  float rim = 1.0 / float(textureSize(standing_mirrored_sides, int(ceil(level))).z);  // half a voxel, of one half
  return textureLod(standing_mirrored_sides, vec3(at.xy, 0.5 * (clamp(at.z, rim, 1.0 - rim) + part)), level).xyz;
}

// How much brighter what is there looks along d than in the mean of its sides. A wall that is bright on one side may have both
// in a voxel, and is seen from one: a surface of normal n weighs 1 - longer * dot(n, d), where `longer` is such that the side
// that faces away, along the axis in which the two differ, weighs nothing.
float seen_side(vec3 at, float level, vec3 d) {
  vec4 mean = textureLod(standing_mirrored, at, level);
  float luminance = max(dot(mean.rgb, vec3(0.2126, 0.7152, 0.0722)), 1e-6);
  vec3 facing = of_sides(at, level - 1.0, 0.0) / max(mean.a, 1e-3);
  vec3 bright = of_sides(at, level - 1.0, 1.0) / luminance;
  vec3 differ = bright - facing;
  float longer = 1.0 / max(abs(dot(d, differ)) / max(length(differ), 1e-3), 0.4);
  return min(max(1.0 - longer * dot(bright, d), 0.02) / max(1.0 - longer * dot(facing, d), 0.02), 2.0);
}

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
  float coarsest = voxel * exp2(frame.mirror_low.w);
  // Half of what GGX mirrors is within twice the angle whose tangent is alpha; voxels are as wide again as their edges.
  float spread = 2.0 * roughness * roughness;
  float climb = max(dot(n, d), 0.0);
  // Steps that begin with a voxel and grow by this of the way get through the volume: the sum of a geometric series, fitted.
  float growth = 0.097 * log(max((end - way) / voxel, 19.2) / 19.2);
  float hidden = 0.0;
  vec4 colour = vec4(0.0);  // a: what those before it weigh together, as in `place`
  vec2 place = vec2(0.0);   // how far away that is and at which level
  vec4 before = vec4(0.0);
  float before_way = -1.0;  // where the last step was; none further on: the ray has reached its last place
  for (int i = 0; i < kMostSteps && way > before_way && way < end && hidden < 0.98; ++i) {
    // No wider than it is high above the surface, or it met that.
    float widest = (kOff * voxel + climb * way) / 1.5;
    float crossing = i < kFineSteps ? 0.0 : (end - way) / float(kMostSteps - i);
    float width = clamp(max(max(spread * way, voxel + growth * way), crossing / kStep), voxel, max(min(widest, coarsest), voxel));
    float level = log2(width / voxel);
    vec4 here = textureLod(standing_mirrored, from + along * way, level);
    vec4 both = before + here;
    // What is behind something is mostly hidden by the same of it: of both, the more counts. And its back is behind its
    // front, less than a step away perhaps: what is met first shows most.
    float more = max(min(both.a / kWall, 1.0) - hidden, 0.0);
    float first = more * (1.0 - hidden) * (1.0 - hidden);
    colour += vec4(both.rgb / max(both.a, 1e-3), 1.0) * first;
    place += vec2(way, level) * first;
    hidden += more;
    before = here;
    before_way = way;
    way = min(way + max(kStep * width, crossing), end - 0.5 * width);  // the last: a wall may stand where the ray goes out
  }
  if (hidden <= 0.0) {
    return vec4(0.0);
  }
  place /= colour.a;
  return vec4(colour.rgb * (hidden * seen_side(from + along * place.x, max(place.y, 1.0), d) / colour.a), hidden);
}
