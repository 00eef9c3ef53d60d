#pragma once
// What the command line says of pictures for two eyes.

#include <glm/glm.hpp>
#include <optional>

#include "engine/render/stereo.h"
#include "haptics/math/result.h"

namespace fulcrum::app {

class Arguments;

struct StereoOptions {
  std::optional<render::StereoMode> mode{};  // --stereo; none: for one eye
  std::optional<double> eye_distance_mm{};   // before the screen where its height is known, else in the scene
  std::optional<double> convergence_mm{};    // in the scene
  std::optional<double> screen_height_mm{};
  std::optional<glm::vec3> head_mm{};  // (3) right and up of the picture's middle, and before the screen
};

void add_stereo(Arguments& arguments, StereoOptions& options);       // all of them
void add_stereo_mode(Arguments& arguments, StereoOptions& options);  // --stereo alone

// The first of them beside --stereo that was given: --eye-distance, ...; null: none.
const char* given_length(const StereoOptions& options);

// Why one of them does not go without another; absent: they go together.
std::optional<Error> refuse_stereo(const StereoOptions& options);

// None: for one eye.
std::optional<render::Stereo> stereo_of(const StereoOptions& options);

// In place of what a view says of its two eyes.
void set_eyes(const StereoOptions& options, render::Camera& camera);

// What an eye in the middle sees: where one eye is asked for, the camera itself.
render::Camera seen_by_middle(const std::optional<render::Stereo>& stereo, const render::Camera& camera);

}  // namespace fulcrum::app
