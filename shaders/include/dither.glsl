// So that smooth gradients show no steps in the eight bits of a picture.
#ifndef FULCRUM_DITHER_GLSL
#define FULCRUM_DITHER_GLSL

// J. Jimenez, "Next Generation Post Processing in Call of Duty", 2014: interleaved gradient noise, within half a step.
float dither(vec2 pixel) {
  return (fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0;
}

#endif
