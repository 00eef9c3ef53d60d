#include "engine/render/tone.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::render {
namespace {

// As tone.frag has them, and from where it has them.
const glm::mat3 kInset(0.842479062253094F, 0.0423282422610123F, 0.0423756549057051F,  //
                       0.0784335999999992F, 0.878468636469772F, 0.0784336F,           //
                       0.0792237451477643F, 0.0791661274605434F, 0.879142973793104F);
const glm::mat3 kOutset(1.19687900512017F, -0.0528968517574562F, -0.0529716355144438F,  //
                        -0.0980208811401368F, 1.15190312990417F, -0.0980434501171241F,  //
                        -0.0990297440797205F, -0.0989611768448433F, 1.15107367264116F);
constexpr float kMinEv = -12.47393F, kMaxEv = 4.026069F;

float contrast(float x) {
  const float x2 = x * x, x4 = x2 * x2;
  return 15.5F * x4 * x2 - 40.14F * x4 * x + 31.96F * x4 - 6.868F * x2 * x + 0.4298F * x2 + 0.1191F * x -
         0.00232F;
}

float curve(float radiance) {
  const float ev = std::clamp(std::log2(std::max(radiance, 1e-10F)), kMinEv, kMaxEv);
  return std::pow(std::max(contrast((ev - kMinEv) / (kMaxEv - kMinEv)), 0.0F), 1.35F);
}

}  // namespace

glm::vec3 tone_mapped(const glm::vec3& radiance) {
  const glm::vec3 inset = kInset * radiance;
  const glm::vec3 c(curve(inset.r), curve(inset.g), curve(inset.b));
  const float luma = glm::dot(c, glm::vec3(0.2126F, 0.7152F, 0.0722F));
  return glm::clamp(kOutset * (luma + 1.2F * (c - luma)), 0.0F, 1.0F);
}

glm::vec3 background_radiance(const Background& background, float v) {
  return glm::mix(background.top, background.bottom, v * v * (3.0F - 2.0F * v));
}

}  // namespace fulcrum::render
