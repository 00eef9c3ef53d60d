#include "engine/app/cli/stereo_options.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/app/cli/program.h"
#include "engine/scenario/words.h"

namespace fulcrum::app {
namespace {

constexpr double kNarrowest_mm = 0, kWidest_mm = 1000;  // between eyes: of an insect, of a giant
constexpr double kLeast_mm = 1, kMost_mm = 100'000;     // of lengths before a screen, and into a scene

// What is wrong with the text; empty: nothing.
std::string read_mode(const std::string& text, std::optional<render::StereoMode>& mode) {
  const auto& names = render::kStereoModeNames;
  const auto* const named = std::ranges::find(names, text);
  if (named != names.end()) {
    mode = static_cast<render::StereoMode>(named - names.begin());
    return {};
  }
  return "there is no stereo mode " + scenario::in_quotes(text) +
         scenario::did_you_mean(text, names, "use " + scenario::joined(names));
}

std::string read_head(const std::string& text, std::optional<glm::vec3>& head_mm) {
  glm::vec3 read(0.0F);
  char rest = 0;
  const bool whole = std::sscanf(text.c_str(), "%f,%f,%f%c", &read.x, &read.y, &read.z, &rest) == 3;
  const auto most = static_cast<float>(kMost_mm);
  const bool fits = std::abs(read.x) <= most && std::abs(read.y) <= most && read.z >= 1.0F && read.z <= most;
  if (!whole || !fits)
    return scenario::in_quotes(text) +
           " is no place of a head: give RIGHT,UP,BEFORE in mm from the picture's middle, such as 0,0,600, "
           "each within 100000, and before it by 1 at least";
  head_mm = read;
  return {};
}

float metres(double mm) {
  return static_cast<float>(1e-3 * mm);
}

}  // namespace

void add_stereo_mode(Arguments& arguments, StereoOptions& options) {
  arguments.text(
      {"--stereo", "MODE", "For two eyes: side-by-side, top-bottom, interlaced or anaglyph (red/cyan)"},
      [&options](const std::string& text) { return read_mode(text, options.mode); });
}

void add_stereo(Arguments& arguments, StereoOptions& options) {
  add_stereo_mode(arguments, options);
  arguments.number(
      {"--eye-distance", "MM", "With --stereo: between the eyes, in the scene or before a screen"},
      options.eye_distance_mm, kNarrowest_mm, kWidest_mm);
  arguments.number({"--convergence", "MM",
                    "With --stereo: from the view's eye to what is seen at the screen (default: its target)"},
                   options.convergence_mm, kLeast_mm, kMost_mm);
  arguments.number({"--screen-height", "MM",
                    "With --stereo: of the picture on the screen, which becomes a window into the scene"},
                   options.screen_height_mm, kLeast_mm, kMost_mm);
  arguments.text(
      {"--head", "X,Y,Z",
       "With --screen-height: mm right and up of the picture's middle, and before it (default 0,0,600)"},
      [&options](const std::string& text) { return read_head(text, options.head_mm); });
}

const char* given_length(const StereoOptions& options) {
  return options.eye_distance_mm    ? "--eye-distance"
         : options.convergence_mm   ? "--convergence"
         : options.screen_height_mm ? "--screen-height"
         : options.head_mm          ? "--head"
                                    : nullptr;
}

std::optional<Error> refuse_stereo(const StereoOptions& options) {
  if (options.head_mm && !options.screen_height_mm)
    return Error{"--head is a place before a screen of known size: add --screen-height."};
  if (const char* const alone = given_length(options); alone != nullptr && !options.mode)
    return Error{std::string(alone) + " is of pictures for two eyes: add --stereo."};
  return std::nullopt;
}

std::optional<render::Stereo> stereo_of(const StereoOptions& options) {
  if (!options.mode) return std::nullopt;
  render::Stereo stereo{*options.mode};
  if (options.screen_height_mm) {
    render::Screen& screen = stereo.screen.emplace();
    screen.height = metres(*options.screen_height_mm);
    if (options.head_mm) screen.head = 1e-3F * *options.head_mm;
    if (options.eye_distance_mm) screen.eye_distance = metres(*options.eye_distance_mm);
  }
  return stereo;
}

void set_eyes(const StereoOptions& options, render::Camera& camera) {
  if (options.convergence_mm) camera.eyes.convergence = metres(*options.convergence_mm);
  if (options.eye_distance_mm && !options.screen_height_mm)
    camera.eyes.distance = metres(*options.eye_distance_mm);
}

render::Camera seen_by_middle(const std::optional<render::Stereo>& stereo, const render::Camera& camera) {
  return stereo ? seen_by(render::Eye::middle, *stereo, camera) : camera;
}

}  // namespace fulcrum::app
