#include "engine/render/surroundings.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "engine/render/environment.h"
#include "engine/render/octahedral_map.h"
#include "engine/render/studio.h"

namespace fulcrum::render {
namespace {

constexpr float kFullTurn = 2.0F * std::numbers::pi_v<float>;

// Of a picture along the horizon, at least: then a pixel of the map, which is a degree, has a dozen of them.
constexpr std::uint32_t kSamplesAround = 2048;

// Between the four nearest pixels; at the sides of the picture it goes on at the other one.
glm::vec3 between_pixels(const Panorama& picture, float column, float row) {
  const float left = std::floor(column), top = std::floor(row);
  const auto wrapped = [&](float x) {
    const auto width = static_cast<int>(picture.width);
    return static_cast<std::size_t>((static_cast<int>(x) + width) % width);
  };
  const auto line = [&](float y) {
    const float last = static_cast<float>(picture.height) - 1.0F;
    return picture.pixels.data() +
           static_cast<std::size_t>(std::clamp(y, 0.0F, last)) * std::size_t{picture.width};
  };
  const std::size_t first = wrapped(left), second = wrapped(left + 1.0F);
  const glm::vec3 *upper = line(top), *lower = line(top + 1.0F);
  return glm::mix(glm::mix(upper[first], upper[second], column - left),
                  glm::mix(lower[first], lower[second], column - left), row - top);
}

// A map, each pixel of it the mean of the picture over its part of the directions, and those parts.
struct Gathered {
  OctahedralMap map{kEnvironmentSize, {}};
  std::vector<float> shares;  // of the whole sphere; 0 on the border
};

Gathered gathered(const Panorama& picture, float intensity) {
  Gathered made;
  made.map.pixels.assign(std::size_t{kEnvironmentSize} * kEnvironmentSize, glm::vec3(0.0F));
  made.shares.assign(made.map.pixels.size(), 0.0F);
  const std::uint32_t finer = (kSamplesAround + picture.width - 1) / picture.width;
  const std::uint32_t columns = picture.width * finer, rows = picture.height * finer;
  std::vector<glm::vec2> azimuths;  // sine and cosine
  for (std::uint32_t i = 0; i < columns; ++i) {
    const float azimuth = kFullTurn * (static_cast<float>(i) + 0.5F) / static_cast<float>(columns);
    azimuths.emplace_back(std::sin(azimuth), std::cos(azimuth));
  }
  const auto step = 1.0F / static_cast<float>(finer);
  for (std::uint32_t row = 0; row < rows; ++row) {
    const float half_turn = 0.5F * kFullTurn / static_cast<float>(rows);
    const float above = half_turn * static_cast<float>(row), polar = above + 0.5F * half_turn;
    // cos(above) - cos(below), without the difference of two that are nearly alike.
    const float height = 2.0F * std::sin(polar) * std::sin(0.5F * half_turn);
    const float share = 0.5F * height / static_cast<float>(columns);
    const float across = std::sin(polar), up = std::cos(polar);
    for (std::uint32_t column = 0; column < columns; ++column) {
      const glm::vec3 d(across * azimuths[column].x, up, -across * azimuths[column].y);
      const std::size_t pixel = made.map.index(d);
      made.map.pixels[pixel] +=
          share * between_pixels(picture, (static_cast<float>(column) + 0.5F) * step - 0.5F,
                                 (static_cast<float>(row) + 0.5F) * step - 0.5F);
      made.shares[pixel] += share;
    }
  }
  for (std::size_t i = 0; i < made.shares.size(); ++i)
    if (made.shares[i] > 0.0F) made.map.pixels[i] *= intensity / made.shares[i];
  return made;
}

Surroundings surroundings_of_picture(const Panorama& picture, float intensity) {
  Gathered from = gathered(picture, intensity);
  OctahedralMap& map = from.map;
  Surroundings made;
  for (std::uint32_t row = 0; row < map.side; ++row)
    for (std::uint32_t column = 0; column < map.side; ++column) {
      const std::size_t pixel = std::size_t{row} * map.side + column;
      const glm::vec3 d = map.direction(column, row);
      if (from.shares[pixel] > 0.0F)
        made.beams.push_back({d, map.pixels[pixel], from.shares[pixel]});
      else
        map.pixels[pixel] = map.pixels[map.index(d)];  // the border's are read inside it
    }
  made.radiance = [kept = std::make_shared<OctahedralMap>(std::move(map))](const glm::vec3& d) {
    return kept->at(d);
  };
  return made;
}

}  // namespace

Surroundings surroundings_of(const Ambient& ambient) {
  if (ambient.picture) return surroundings_of_picture(*ambient.picture, ambient.intensity);
  return {[ambient](const glm::vec3& from) { return studio_radiance(ambient, from); }};
}

}  // namespace fulcrum::render
