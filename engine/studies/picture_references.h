#pragma once
// The references that come with the scenes: ROOT/references/SCENE_VIEW.png with what it is of,
// SCENE_VIEW.json.

#include <filesystem>
#include <string>
#include <vector>

#include "engine/analysis/picture/flip.h"
#include "engine/render/picture.h"
#include "engine/render/radiance_png.h"
#include "engine/studies/picture_shot.h"

namespace fulcrum::app {

struct Reference {
  Shot shot;
  std::string digest;  // of what was drawn, see describe()
  std::filesystem::path picture;
};

// By scene and time; scene: of that alone, empty: of all. Fails where there is none, and where one of those
// that were asked for is damaged; one of another scene is told of on stderr.
Result<std::vector<Reference>> find_references(const std::string& scene);

Result<render::Radiance> radiance_of(const Reference& reference);

// As our renderer would show it: the background laid under it, then tone mapped.
analysis::picture::Image shown_on(const render::Background& background, const render::Radiance& radiance);

analysis::picture::Image image_of(const render::Picture& picture);
render::Picture picture_of(const analysis::picture::Image& image);

}  // namespace fulcrum::app
