#pragma once
// A small scene for tests of drawing: a floor, a box, a chromed ball that moves, a marker, a ghost of the
// ball.

#include <memory>

#include "engine/render/renderer.h"

namespace fulcrum::test {

render::Mesh make_box(const glm::vec3& half_size);
render::Mesh make_ball(float radius);

// Instances: 0 the floor, 1 the box, 2 the ball (movable). One marker. A ghost, shown only where a frame
// says so.
render::VisualDesc make_scene();

// A device with the validation layers on.
struct Gpu {
  vulkan::Instance instance;
  std::unique_ptr<vulkan::Device> device;
};

// Fails the running test and throws where there is no device: llvmpipe comes with mesa-vulkan-drivers.
// `name`: a part of its name; empty: the best one. Goldens are drawn with llvmpipe.
Gpu make_gpu(const std::string& name = "");

// The mean of the red, green and blue values, 0..255, of a rectangle given in fractions of the picture.
glm::vec3 mean(const render::Picture& picture, float left, float top, float right, float bottom);

// Of the light that a picture shows as a grey of that value, 0..255.
double radiance_of(float value);

}  // namespace fulcrum::test
