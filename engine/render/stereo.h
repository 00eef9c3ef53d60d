#pragma once
// A view for two eyes: where each of them is, and how what they see becomes one picture.
//
// Both look the same way, and their frusta are sheared so that they share one window: what lies in its plane
// is at the same place in both pictures, and so at the screen. Eyes that are turned towards each other
// instead would see verticals at different heights at the picture's corners: A. Woods, T. Docherty and
// R. Koch, "Image distortions in stereoscopic video systems" (Proc. SPIE 1915, 1993). A screen that is a
// window into the scene, before a head: C. Ware, K. Arthur and K. Booth, "Fish tank virtual reality" (CHI
// '93).

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "engine/render/visual_desc.h"

namespace fulcrum::render {

enum class StereoMode {
  side_by_side,  // either eye in one half, squeezed to half its width: the left one's is at the left
  top_bottom,    // squeezed to half its height: the left one's is above
  interlaced,    // the left eye has the even rows, counted from 0 at the top
  anaglyph       // for glasses that are red before the left eye and cyan before the right
};

// In the order of the modes, as a person writes them.
inline constexpr std::array<std::string_view, 4> kStereoModeNames{"side-by-side", "top-bottom", "interlaced",
                                                                  "anaglyph"};

// A screen of known size, and who looks at it: the picture is then a window, through which the scene is seen
// as it would be from there. Lengths are those before the screen.
struct Screen {
  float height = 0.0F;          // m, of the picture on it
  glm::vec3 head{0, 0, 0.6F};   // (3) m, the middle between the eyes: right and up of the picture's middle,
                                // and before it
  float eye_distance = 0.063F;  // m, between the pupils
};

struct Stereo {
  StereoMode mode = StereoMode::side_by_side;
  std::optional<Screen> screen{};  // none: the camera stays where it is, and its eyes are as Camera has them
};

enum class Eye { left, middle, right };

// What an eye sees of what `camera` shows. The window is the camera's, at its convergence. Without a screen
// the middle one sees exactly that; with one the window is as large in the scene as before, the screen's
// height is scaled to it, and the head with it.
Camera seen_by(Eye eye, const Stereo& stereo, const Camera& camera);

// m, from the eye to the plane that is seen at the screen.
float convergence_of(const Camera& camera);
// m, between the eyes, where there is no screen.
float eye_distance_of(const Camera& camera);

}  // namespace fulcrum::render
