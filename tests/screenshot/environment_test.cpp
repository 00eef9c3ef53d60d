// What shaders read of light from all around, against sums over a fine grid of directions.

#include "engine/render/environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <numbers>

#include "engine/render/studio.h"

namespace fulcrum::render {
namespace {

constexpr double kPi = std::numbers::pi;

// The mean of the radiance with these weights of the direction, over a grid of 1 degree.
template <typename Weight>
glm::dvec3 weighed(const std::function<glm::vec3(const glm::vec3&)>& radiance, const Weight& weight) {
  glm::dvec3 sum(0.0);
  double weights = 0.0;
  for (int row = 0; row < 180; ++row) {
    const double polar = kPi * (row + 0.5) / 180.0;
    for (int column = 0; column < 360; ++column) {
      const double azimuth = kPi * column / 180.0;
      const glm::dvec3 d(std::sin(polar) * std::cos(azimuth), std::cos(polar),
                         std::sin(polar) * std::sin(azimuth));
      const double w = std::sin(polar) * weight(d);
      sum += w * glm::dvec3(radiance(glm::vec3(d)));
      weights += w;
    }
  }
  return sum / weights;
}

glm::dvec3 irradiance(const Irradiance& made, const glm::dvec3& n) {
  glm::dvec3 sum = glm::dvec3(made.rest) * (n.x * n.x - n.y * n.y);
  for (int i = 0; i < 3; ++i) {
    const auto c = static_cast<std::size_t>(i);
    sum[i] += glm::dot(glm::dvec4(made.linear[c]), glm::dvec4(n, 1.0));
    sum[i] += glm::dot(glm::dvec4(made.quadratic[c]), glm::dvec4(n.x * n.y, n.y * n.z, n.z * n.z, n.z * n.x));
  }
  return sum;
}

// As a sampler would read it, with the octahedron written out anew.
glm::dvec3 mirrored(const Environment& made, std::uint32_t level, const glm::dvec3& d) {
  const glm::dvec3 on = d / (std::abs(d.x) + std::abs(d.y) + std::abs(d.z));
  glm::dvec2 p(on.x, on.z);
  if (on.y < 0.0)
    p = {on.x < 0 ? std::abs(on.z) - 1 : 1 - std::abs(on.z),
         on.z < 0 ? std::abs(on.x) - 1 : 1 - std::abs(on.x)};
  const std::uint32_t side = kEnvironmentSize >> level;
  const glm::dvec2 at = (p * 0.375 + 0.5) * static_cast<double>(side) - 0.5;
  const auto pixel = [&](double x, double y) {
    std::uint64_t packed = 0;
    std::memcpy(
        &packed,
        made.levels[level].data() + 8 * (static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x)),
        8);
    return glm::dvec3(glm::unpackHalf4x16(packed));
  };
  const glm::dvec2 low = glm::floor(at), part = at - low;
  return glm::mix(glm::mix(pixel(low.x, low.y), pixel(low.x + 1, low.y), part.x),
                  glm::mix(pixel(low.x, low.y + 1), pixel(low.x + 1, low.y + 1), part.x), part.y);
}

std::vector<glm::dvec3> directions_all_round() {
  std::vector<glm::dvec3> made;
  for (int i = 0; i < 60; ++i) {
    const double y = 1.0 - (i + 0.5) / 30.0, turn = 2.399963 * i, across = std::sqrt(1.0 - y * y);
    made.emplace_back(across * std::cos(turn), y, across * std::sin(turn));
  }
  return made;
}

glm::vec3 in_the_studio(const glm::vec3& from) {
  return studio_radiance(Ambient{}, from);
}

TEST(Environment, EvenLightIsEvenEverywhere) {
  const glm::vec3 grey(0.25F, 0.5F, 2.0F);
  const Environment made = make_environment({[&](const glm::vec3&) { return grey; }});
  ASSERT_EQ(made.levels.size(), kEnvironmentLevels);
  for (const glm::dvec3& d : directions_all_round()) {
    EXPECT_LT(glm::distance(irradiance(made.irradiance, d), glm::dvec3(grey)), 1e-3);
    for (std::uint32_t level = 0; level < kEnvironmentLevels; ++level)
      EXPECT_LT(glm::distance(mirrored(made, level, d), glm::dvec3(grey)), 2e-3) << level;
  }
}

// Nine harmonics hold a cosine's blur to a few per cent of what is brightest.
TEST(Environment, AMattSurfaceReceivesWhatTheStudioSends) {
  const Environment made = make_environment({in_the_studio});
  double brightest = 0.0, worst = 0.0;
  for (const glm::dvec3& n : directions_all_round()) {
    const glm::dvec3 wanted =
        weighed(in_the_studio, [&](const glm::dvec3& d) { return std::max(0.0, glm::dot(n, d)); });
    brightest = std::max(brightest, wanted.g);
    worst = std::max(worst, std::abs(irradiance(made.irradiance, n).g - wanted.g));
  }
  EXPECT_LT(worst, 0.04 * brightest);
}

// A mirror seen from straight above; its lobe is the GGX distribution of half vectors, weighed by the cosine.
// The last level has 6 pixels for half a turn, and what lies between them is 4 % off.
TEST(Environment, ARoughMirrorShowsTheStudioBlurred) {
  const Environment made = make_environment({in_the_studio});
  for (std::uint32_t level = 1; level < kEnvironmentLevels; ++level) {
    const double alpha2 = std::pow(environment_roughness(level), 4.0);
    double brightest = 0.0, squares = 0.0;
    for (const glm::dvec3& n : directions_all_round()) {
      const glm::dvec3 wanted = weighed(in_the_studio, [&](const glm::dvec3& d) {
        const double cosine = glm::dot(n, d);
        if (cosine <= 0.0) return 0.0;
        const double half = glm::dot(n, glm::normalize(n + d));
        const double bottom = half * half * (alpha2 - 1.0) + 1.0;
        return cosine * alpha2 / (bottom * bottom);
      });
      brightest = std::max(brightest, wanted.g);
      squares += std::pow(mirrored(made, level, n).g - wanted.g, 2.0);
    }
    const double allowed = level + 1 < kEnvironmentLevels ? 0.03 : 0.045;
    EXPECT_LT(std::sqrt(squares / 60.0), allowed * brightest) << level;
  }
}

// Where the map is folded, what lies on both sides is next to each other.
TEST(Environment, NoEdgeIsSeenWhereTheMapIsFolded) {
  const Environment made = make_environment({in_the_studio});
  for (std::uint32_t level = 0; level < kEnvironmentLevels; ++level)
    for (int i = 1; i < 40; ++i) {
      const double x = i / 40.0, down = x - 1.0;
      for (const double sign : {-1.0, 1.0}) {
        const glm::dvec3 here = mirrored(made, level, {sign * x, down, 1e-6}),
                         there = mirrored(made, level, {sign * x, down, -1e-6});
        EXPECT_LT(glm::distance(here, there), 0.01) << level << " " << x;
      }
    }
}

TEST(Environment, ASunTooBrightForHalfFloatsIsStillFinite) {
  const Environment made =
      make_environment({[](const glm::vec3& from) { return glm::vec3(from.y > 0.999F ? 1e6F : 0.1F); }});
  EXPECT_GT(mirrored(made, 0, {0, 1, 0}).g, 5e4);
  for (const glm::dvec3& d : directions_all_round())
    for (std::uint32_t level = 0; level < kEnvironmentLevels; ++level)
      EXPECT_TRUE(std::isfinite(mirrored(made, level, d).g));
}

// A picture of all around, a value for each direction of its pixels' middles.
template <typename Value>
Ambient picture_of(std::uint32_t width, const Value& value) {
  Panorama picture{width, width / 2, {}};
  for (std::uint32_t row = 0; row < picture.height; ++row)
    for (std::uint32_t column = 0; column < picture.width; ++column) {
      const double polar = kPi * (row + 0.5) / picture.height, azimuth = 2 * kPi * (column + 0.5) / width;
      picture.pixels.emplace_back(value(glm::dvec3(std::sin(polar) * std::sin(azimuth), std::cos(polar),
                                                   -std::sin(polar) * std::cos(azimuth))));
    }
  Ambient ambient;
  ambient.picture = std::move(picture);
  return ambient;
}

// One pixel of a picture, which is black elsewhere: its direction, and its radiance times its solid angle.
struct Sun {
  Ambient ambient;
  glm::dvec3 from;
  double power;
};

Sun sun_at(std::uint32_t column, std::uint32_t row) {
  constexpr std::uint32_t kWidth = 1024, kHeight = 512;
  constexpr double kRadiance = 2e5;
  Sun sun;
  sun.ambient.picture = Panorama{kWidth, kHeight, std::vector<glm::vec3>(kWidth * kHeight, glm::vec3(0.0F))};
  sun.ambient.picture->pixels[std::size_t{row} * kWidth + column] = glm::vec3(kRadiance);
  const double polar = kPi * (row + 0.5) / kHeight, azimuth = 2 * kPi * (column + 0.5) / kWidth;
  sun.from = {std::sin(polar) * std::sin(azimuth), std::cos(polar), -std::sin(polar) * std::cos(azimuth)};
  sun.power =
      kRadiance * 2 * kPi / kWidth * (std::cos(kPi * row / kHeight) - std::cos(kPi * (row + 1) / kHeight));
  return sun;
}

std::vector<Sun> some_suns() {
  return {sun_at(256, 256), sun_at(100, 40), sun_at(700, 130), sun_at(900, 400), sun_at(511, 500)};
}

// The mean of what a rough mirror shows of it, in closed form: the GGX distribution of half vectors weighed
// by the cosine, over its integral.
double shown_of(const Sun& sun, double roughness, const glm::dvec3& n) {
  const double alpha2 = std::pow(roughness, 4.0);
  const auto weight = [&](double cosine) {
    const double half2 = 0.5 + 0.5 * cosine, bottom = half2 * (alpha2 - 1.0) + 1.0;
    return cosine <= 0.0 ? 0.0 : cosine * alpha2 / (bottom * bottom);
  };
  double whole = 0.0;
  constexpr int kSteps = 20000;
  for (int i = 0; i < kSteps; ++i) whole += 2.0 * kPi / kSteps * weight((i + 0.5) / kSteps);
  return sun.power * weight(glm::dot(n, sun.from)) / whole;
}

// How far a level is from that, root mean square over the mirrors that show half as much as the brightest or
// more, as a part of the brightest; and the worst.
std::pair<double, double> error_of(const std::vector<Sun>& suns, const std::vector<Environment>& made,
                                   std::uint32_t level) {
  double squares = 0.0, worst = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < suns.size(); ++i) {
    const double roughness = environment_roughness(level);
    const double brightest = shown_of(suns[i], roughness, suns[i].from);
    const glm::dvec3 aside = glm::normalize(glm::cross(suns[i].from, glm::dvec3(0.3, 0.5, 0.8)));
    for (int step = 0; step < 200; ++step) {
      const double angle = 0.5 * kPi * (step + 0.5) / 200;
      const double turn = 2.399963 * step;
      const glm::dvec3 across = std::cos(turn) * aside + std::sin(turn) * glm::cross(suns[i].from, aside);
      const glm::dvec3 n = std::cos(angle) * suns[i].from + std::sin(angle) * across;
      const double wanted = shown_of(suns[i], roughness, n), found = mirrored(made[i], level, n).g;
      worst = std::max(worst, (found - wanted) / brightest);
      if (wanted < 0.5 * brightest) continue;
      squares += std::pow((found - wanted) / brightest, 2.0);
      ++count;
    }
  }
  return {std::sqrt(squares / count), worst};
}

TEST(Environment, AnEvenPictureIsEvenEverywhere) {
  const Ambient grey = picture_of(64, [](const glm::dvec3&) { return glm::vec3(0.25F, 0.5F, 2.0F); });
  const Surroundings around = surroundings_of(grey);
  double all = 0.0;
  for (const Beam& beam : around.beams) all += beam.share;
  EXPECT_NEAR(all, 1.0, 1e-5);
  const Environment made = make_environment(around);
  for (const glm::dvec3& d : directions_all_round()) {
    EXPECT_LT(glm::distance(irradiance(made.irradiance, d), glm::dvec3(0.25, 0.5, 2.0)), 1e-3);
    for (std::uint32_t level = 0; level < kEnvironmentLevels; ++level)
      EXPECT_LT(glm::distance(mirrored(made, level, d), glm::dvec3(0.25, 0.5, 2.0)), 2e-3) << level;
  }
}

// Of a harmonic of the first order the cosine leaves two thirds.
TEST(Environment, APictureThatIsAHarmonicGivesItsShareOfLight) {
  for (const glm::dvec3& axis : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0.6, 0, -0.8)}) {
    const Ambient ambient = picture_of(
        256, [&](const glm::dvec3& d) { return glm::vec3(static_cast<float>(1.0 + glm::dot(axis, d))); });
    const Environment made = make_environment(surroundings_of(ambient));
    for (const glm::dvec3& n : directions_all_round()) {
      EXPECT_NEAR(irradiance(made.irradiance, n).g, 1.0 + 2.0 / 3.0 * glm::dot(axis, n), 2e-3);
      EXPECT_NEAR(mirrored(made, 0, n).g, 1.0 + glm::dot(axis, n), 6e-3);
    }
  }
}

// A pixel that lights as the sun does: nothing of it is lost between the directions that sums are taken over,
// and nine harmonics of a cosine's half are a tenth of it off.
TEST(Environment, ASunOfOnePixelGivesItsWholeLight) {
  for (const Sun& sun : some_suns()) {
    const Surroundings around = surroundings_of(sun.ambient);
    double power = 0.0;
    for (const Beam& beam : around.beams)
      power += 4.0 * kPi * beam.share * static_cast<double>(beam.radiance.g);
    EXPECT_NEAR(power, sun.power, 1e-3 * sun.power);
    const Irradiance made = make_environment(around).irradiance;
    for (const glm::dvec3& n : directions_all_round())
      EXPECT_NEAR(std::max(irradiance(made, n).g, 0.0),
                  sun.power / kPi * std::max(0.0, glm::dot(n, sun.from)), 0.1 * sun.power / kPi);
  }
}

// The hardest there is: one pixel of light in the dark. More samples, less error, and no bright dots beside
// it.
TEST(Environment, ASunsMirrorImageGetsBetterWithMoreSamples) {
  const std::vector<Sun> suns = some_suns();
  std::array<double, kEnvironmentLevels> before{};
  before.fill(1.0);
  for (const std::uint32_t samples : {8U, kLobeSamples, kLobeSamplesOfPicture}) {
    std::vector<Environment> made;
    for (const Sun& sun : suns) made.push_back(make_environment(surroundings_of(sun.ambient), samples));
    for (std::uint32_t level = 1; level < kEnvironmentLevels; ++level) {
      const auto [error, worst] = error_of(suns, made, level);
      EXPECT_LT(error, before[level]) << samples << " samples, level " << level;
      before[level] = error;
      RecordProperty("samples_" + std::to_string(samples) + "_level_" + std::to_string(level),
                     std::to_string(error));
      if (samples == kLobeSamplesOfPicture) {
        EXPECT_LT(error, level == 1 ? 0.13 : 0.08) << level;
        EXPECT_LT(worst, 0.3) << level;
      }
    }
  }
}

}  // namespace
}  // namespace fulcrum::render
