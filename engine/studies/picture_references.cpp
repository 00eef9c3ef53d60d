#include "engine/studies/picture_references.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <system_error>
#include <tuple>

#include "engine/app/cli/terminal.h"
#include "engine/files/regular_file.h"
#include "engine/render/tone.h"
#include "engine/scenario/content.h"

namespace fulcrum::app {
namespace {

constexpr std::size_t kMostSidecarBytes = 1 << 20;
// Of a picture: all that the largest one can be without being compressed.
constexpr std::size_t kMostPictureBytes =
    9 * std::size_t{render::kMostRadiancePixels} * render::kMostRadiancePixels;

Error unread(const std::filesystem::path& file, const Error& why) {
  return {file.string() + " cannot be read: " + why.sentence + "; make it anew with tools/references."};
}

Result<std::string> bytes_of(const std::filesystem::path& file, std::size_t most) {
  const Result<RegularFile> opened = RegularFile::open(file);
  if (!opened) return unread(file, opened.error());
  Result<std::string> bytes = opened->first_bytes(most);
  if (!bytes) return unread(file, bytes.error());
  return bytes;
}

Result<Reference> read_reference(const std::filesystem::path& file) {
  const Result<std::string> text = bytes_of(file, kMostSidecarBytes);
  if (!text) return text.error();
  const auto json = nlohmann::ordered_json::parse(*text, nullptr, false);
  const Result<Shot> shot = read_shot(json, file);
  if (!shot) return shot.error();
  const auto digest = json.find("digest");
  std::filesystem::path picture = file;
  return Reference{*shot, digest != json.end() && digest->is_string() ? digest->get<std::string>() : "",
                   picture.replace_extension(".png")};
}

}  // namespace

Result<std::vector<Reference>> find_references(const std::string& scene) {
  std::vector<Reference> found;
  for (const std::filesystem::path& root : scenario::content_roots()) {
    std::error_code fault;
    std::filesystem::directory_iterator entry(root / "references", fault);
    for (; !fault && entry != std::filesystem::directory_iterator(); entry.increment(fault)) {
      const std::filesystem::path& file = entry->path();
      if (file.extension() != ".json") continue;
      Result<Reference> reference = read_reference(file);
      if (!reference) {
        if (scene.empty() || file.filename().string().starts_with(scene + "_")) return reference.error();
        complain("left out, since it does not seem to be of '" + scene + "': " + reference.error().sentence);
        continue;
      }
      if (scene.empty() || reference->shot.scene == scene) found.push_back(std::move(*reference));
    }
    if (!found.empty()) break;
  }
  if (found.empty())
    return Error{scene.empty() ? "No reference lies in the folder references of the content; make them with "
                                 "tools/references."
                               : "There is no reference of a scene '" + scene +
                                     "'; fulcrum list has the scenes that come with Fulcrum."};
  std::ranges::sort(found, {}, [](const Reference& each) {
    return std::tuple(each.shot.scene, each.shot.time_s, each.shot.view);
  });
  return found;
}

Result<render::Radiance> radiance_of(const Reference& reference) {
  const Result<std::string> png = bytes_of(reference.picture, kMostPictureBytes);
  if (!png) return png.error();
  Result<render::Radiance> radiance = render::read_radiance(*png);
  if (!radiance) return unread(reference.picture, radiance.error());
  return radiance;
}

analysis::picture::Image shown_on(const render::Background& background, const render::Radiance& radiance) {
  analysis::picture::Image image{radiance.width, radiance.height, {}};
  image.pixels.reserve(radiance.pixels.size());
  for (std::size_t i = 0; i < radiance.pixels.size(); ++i) {
    const std::size_t row = i / radiance.width;
    const float v = (static_cast<float>(row) + 0.5F) / static_cast<float>(radiance.height);
    const glm::vec4& pixel = radiance.pixels[i];
    const glm::vec3 shown =
        render::tone_mapped(glm::vec3(pixel) + (1.0F - pixel.a) * render::background_radiance(background, v));
    image.pixels.push_back({shown.r, shown.g, shown.b});
  }
  return image;
}

analysis::picture::Image image_of(const render::Picture& picture) {
  analysis::picture::Image image{picture.width, picture.height, {}};
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
    image.pixels.push_back({static_cast<float>(picture.rgba[i]) / 255.0F,
                            static_cast<float>(picture.rgba[i + 1]) / 255.0F,
                            static_cast<float>(picture.rgba[i + 2]) / 255.0F});
  return image;
}

render::Picture picture_of(const analysis::picture::Image& image) {
  render::Picture picture{
      static_cast<std::uint32_t>(image.width), static_cast<std::uint32_t>(image.height), {}};
  for (const std::array<float, 3>& pixel : image.pixels) {
    for (const float value : pixel)
      picture.rgba.push_back(static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(value, 0.0F, 1.0F))));
    picture.rgba.push_back(255);
  }
  return picture;
}

}  // namespace fulcrum::app
