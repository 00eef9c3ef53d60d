#include "engine/scenario/surroundings_file.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <utility>

#include "engine/assets/hdr.h"
#include "engine/files/regular_file.h"
#include "engine/scenario/nearby.h"
#include "engine/scenario/words.h"

namespace fulcrum::scenario {
namespace {

Result<HdrPicture> picture_in(const Scenario& scenario, const FileRef& named) {
  const Result<RegularFile> file = RegularFile::open_within(scenario.folder, named.path);
  const Result<std::string> text = file ? file->first_bytes(kLargestHdrFile + 1) : file.error();
  if (!text)
    return Error{"cannot read " + in_quotes(named.name) + ": " + text.error().sentence +
                 nearby_files(named.name, scenario.folder)};
  if (text->size() > kLargestHdrFile)
    return Error{in_quotes(named.name) +
                 " is larger than 64 MB: make it smaller, at most 4096 x 2048 pixels"};
  Result<HdrPicture> picture =
      decode_hdr({reinterpret_cast<const std::uint8_t*>(text->data()), text->size()});
  if (!picture) return Error{in_quotes(named.name) + " cannot be used: " + picture.error().sentence};
  return picture;
}

// Columns of the world begin at -z, those of the file a quarter of a turn from there, and `turn` further.
// Between two columns of the file their shares are taken, so that no light is lost.
render::Panorama laid_into_world(const HdrPicture& picture, float turn) {
  const auto width = static_cast<float>(picture.width);
  const float shift = width * (0.25F + turn / (2.0F * std::numbers::pi_v<float>));
  const float whole = std::floor(shift), part = shift - whole;
  // As many turns more as keep it positive: two are the most that a scenario can ask for.
  const auto first = static_cast<std::size_t>(whole + 4.0F * width);
  render::Panorama panorama{picture.width, picture.height, {}};
  panorama.pixels.reserve(picture.pixels.size());
  for (std::size_t row = 0; row < picture.height; ++row)
    for (std::size_t column = 0; column < picture.width; ++column) {
      const auto pixel = [&](std::size_t at) {
        const auto& [red, green, blue] = picture.pixels[row * picture.width + at % picture.width];
        return glm::vec3(red, green, blue);
      };
      const glm::vec3 here = pixel(column + first), next = pixel(column + first + 1);
      panorama.pixels.push_back(here + part * (next - here));
    }
  return panorama;
}

void mirror_columns(render::Panorama& panorama) {
  const auto width = static_cast<std::ptrdiff_t>(panorama.width);
  for (auto row = panorama.pixels.begin(); row != panorama.pixels.end(); row += width)
    std::reverse(row, row + width);
}

}  // namespace

Checked<render::Panorama> read_surroundings(const Scenario& scenario, const SurroundingsEntry& entry) {
  const Result<HdrPicture> picture = picture_in(scenario, entry.file);
  if (!picture) return Faults{entry.file.where.fault(picture.error().sentence)};
  render::Panorama panorama = laid_into_world(*picture, entry.turn);
  if (scenario.left_handed) mirror_columns(panorama);
  panorama.seen = entry.seen;
  return panorama;
}

}  // namespace fulcrum::scenario
