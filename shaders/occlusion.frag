// How much of the light from all around reaches what the camera sees: the part of the hemisphere over each place,
// weighed by the cosine, that nothing else in the depth image hides.
//
// Slices through the line of sight and their cosine weighted arcs: J. Jimenez et al., "Practical Real-Time Strategies
// for Accurate Indirect Occlusion", SIGGRAPH 2016 (eq. 7). A slice's arcs as bits of a word, so that thin things hide
// what is behind them alone: O. Therrien et al., "Screen Space Indirect Lighting with Visibility Bitmask", 2023.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/frame.h"

layout(std140, set = 0, binding = 0) uniform Frame { FrameData frame; };
layout(set = 0, binding = 1) uniform sampler2D depths;

layout(location = 0) in vec2 uv;
layout(location = 0) out vec2 found;  // x the part that is open, y distance along the way ahead (m)

const float kPi = 3.14159265;
const int kSlices = 2;
const int kSteps = 6;             // to each side
const float kReach = 0.25;        // of the picture's height, to each side
const float kThickness = 0.1;    // of the distance: how far things are taken to reach behind what is seen of them
const float kInfinitelyFar = 6e4;  // a half float holds it

float ahead(ivec2 at) {
  float depth = texelFetch(depths, at, 0).r;
  return depth > 0.0 ? min(frame.occlusion.z / depth, kInfinitelyFar) : kInfinitelyFar;
}

// Of the middle of a pixel, as the camera has it: x to the right, y up, z to the back.
vec3 place(ivec2 at, float z) {
  vec2 across = (vec2(at) + 0.5) / frame.occlusion.xy * vec2(2.0, -2.0) + vec2(-1.0, 1.0);
  return z * vec3(across * frame.lens.xy + frame.lens.zw, -1.0);
}

// Towards the neighbour that is less likely to be of another surface.
vec3 along(ivec2 here, vec3 p, ivec2 by) {
  ivec2 last = ivec2(frame.occlusion.xy) - 1;
  ivec2 next = min(here + by, last);
  ivec2 before = max(here - by, ivec2(0));
  float z_next = ahead(next);
  float z_before = ahead(before);
  bool forward = next != here && (before == here || abs(z_next + p.z) < abs(z_before + p.z));
  return forward ? place(next, z_next) - p : p - place(before, z_before);
}

// Within 7e-3 (S. Lagarde, "Inverse trigonometric functions GPU optimization for AMD GCN", 2014).
float angle(float cosine) {
  float x = abs(cosine);
  float positive = (1.5707963 - 0.156583 * x) * sqrt(1.0 - x);
  return cosine < 0.0 ? kPi - positive : positive;
}

struct Slice {
  vec3 side;     // unit, across the line of sight
  float sine;    // of the angle from the line of sight to the normal in the slice, positive towards the side
  float cosine;
  float lowest;  // what weight() is at the two ends of the hemisphere
  float whole;
};

// The integral of |sin h| cos(h - normal's angle) over angles from the line of sight to one with this sine and cosine.
float weight(Slice slice, float s, float c, float h) {
  float half_sum = 0.5 * (s * s * slice.cosine + (h - s * c) * slice.sine);
  return h < 0.0 ? -half_sum : half_sum;
}

// Where an angle lies in the hemisphere's weights, 0..1. d: unit, seen from the place.
float share(Slice slice, vec3 v, vec3 d, float sign_of_side) {
  float c = clamp(dot(d, v), -1.0, 1.0);
  float s = dot(d, slice.side);
  if (s * slice.sine + c * slice.cosine <= 0.0) {  // below the surface
    return sign_of_side < 0.0 ? 0.0 : 1.0;
  }
  float h = sign_of_side * angle(c);
  return clamp((weight(slice, s, c, h) - slice.lowest) / slice.whole, 0.0, 1.0);
}

uint bits(float from, float to) {
  int first = int(from * 32.0 + 0.5);
  int count = int(to * 32.0 + 0.5) - first;
  return count > 0 ? (0xFFFFFFFFu >> (32 - count)) << first : 0u;
}

void main() {
  ivec2 here = ivec2(uv * frame.occlusion.xy);
  float z = ahead(here);
  if (z >= kInfinitelyFar) {
    found = vec2(1.0, kInfinitelyFar);
    return;
  }
  vec3 p = place(here, z);
  vec3 v = normalize(-p);
  vec3 n = cross(along(here, p, ivec2(0, 1)), along(here, p, ivec2(1, 0)));
  float n_squared = dot(n, n);
  n = n_squared > 0.0 ? n * inversesqrt(n_squared) : v;  // a picture of one pixel has no neighbours

  // Sixteen neighbours look along sixteen slices and at other distances; occlusion_smooth.frag puts them together.
  int pattern = (here.x & 3) * 4 + (here.y & 3);
  float turn = float((pattern * 7) & 15) / 16.0;
  float jitter = float((pattern * 11 + 5) & 15) / 16.0;
  float reach = kReach * frame.occlusion.y;  // pixels
  float open = 0.0;
  float all = 0.0;
  for (int i = 0; i < kSlices; ++i) {
    float azimuth = kPi * (float(i) + turn) / float(kSlices);
    vec2 way = vec2(cos(azimuth), sin(azimuth));  // in the picture, y down
    Slice slice;
    vec3 flat_way = vec3(way.x, -way.y, 0.0);
    slice.side = normalize(flat_way - v * dot(flat_way, v));
    float n_v = dot(n, v);
    float n_side = dot(n, slice.side);
    float n_length = max(length(vec2(n_v, n_side)), 1e-4);
    slice.sine = n_side / n_length;
    slice.cosine = n_v / n_length;
    float to_normal = sign(slice.sine) * angle(clamp(slice.cosine, -1.0, 1.0));
    float up = slice.cosine * slice.cosine * slice.cosine;
    float both = slice.cosine * slice.sine;
    slice.lowest = -0.5 * (up + (to_normal - 0.5 * kPi + both) * slice.sine);
    float highest = 0.5 * (up + (to_normal + 0.5 * kPi + both) * slice.sine);
    slice.whole = max(highest - slice.lowest, 1e-4);
    uint hidden = 0u;
    for (int to = -1; to <= 1; to += 2) {
      for (int k = 0; k < kSteps; ++k) {
        float part = (float(k) + jitter) / float(kSteps);
        ivec2 at = here + ivec2(round(float(to) * way * (part * part * reach + 1.0)));
        if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, ivec2(frame.occlusion.xy)))) {
          break;
        }
        float there = ahead(at);
        if (there >= kInfinitelyFar) {
          continue;
        }
        vec3 front = place(at, there) - p;
        vec3 back = front - v * (kThickness * there);
        float a = share(slice, v, normalize(front), float(to));
        float b = share(slice, v, normalize(back), float(to));
        hidden |= bits(min(a, b), max(a, b));
      }
    }
    float whole = n_length * slice.whole;
    open += whole * (1.0 - float(bitCount(hidden)) / 32.0);
    all += whole;
  }
  found = vec2(open / all, z);
}
