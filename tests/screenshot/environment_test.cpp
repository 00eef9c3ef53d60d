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
glm::dvec3 weighed(const Surroundings& radiance, const Weight& weight) {
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
  const Environment made = make_environment([&](const glm::vec3&) { return grey; });
  ASSERT_EQ(made.levels.size(), kEnvironmentLevels);
  for (const glm::dvec3& d : directions_all_round()) {
    EXPECT_LT(glm::distance(irradiance(made.irradiance, d), glm::dvec3(grey)), 1e-3);
    for (std::uint32_t level = 0; level < kEnvironmentLevels; ++level)
      EXPECT_LT(glm::distance(mirrored(made, level, d), glm::dvec3(grey)), 2e-3) << level;
  }
}

// Nine harmonics hold a cosine's blur to a few per cent of what is brightest.
TEST(Environment, AMattSurfaceReceivesWhatTheStudioSends) {
  const Environment made = make_environment(in_the_studio);
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
  const Environment made = make_environment(in_the_studio);
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
  const Environment made = make_environment(in_the_studio);
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
      make_environment([](const glm::vec3& from) { return glm::vec3(from.y > 0.999F ? 1e6F : 0.1F); });
  EXPECT_GT(mirrored(made, 0, {0, 1, 0}).g, 5e4);
  for (const glm::dvec3& d : directions_all_round())
    for (std::uint32_t level = 0; level < kEnvironmentLevels; ++level)
      EXPECT_TRUE(std::isfinite(mirrored(made, level, d).g));
}

}  // namespace
}  // namespace fulcrum::render
