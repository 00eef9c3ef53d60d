#pragma once
// How colours look to eyes that lack a kind of cone, and how far apart two of them are.
// Matrices on linear RGB for a whole deficiency: G. M. Machado, M. M. Oliveira, L. A. F. Fernandes, "A
// Physiologically-based Model for Simulation of Color Vision Deficiency", IEEE TVCG 15(6), 2009,
// severity 1.0. CIELAB: CIE 15:2004, white D65; sRGB: IEC 61966-2-1. Contrast: WCAG 2.1, 1.4.3.

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

namespace fulcrum::test {

enum class Vision { normal, protanope, deuteranope, tritanope };
inline constexpr std::array kVisions = {Vision::normal, Vision::protanope, Vision::deuteranope,
                                        Vision::tritanope};

inline glm::vec3 linear_of(const glm::vec3& srgb) {
  const auto decoded = [](float value) {
    return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
  };
  return {decoded(srgb.r), decoded(srgb.g), decoded(srgb.b)};
}

inline glm::vec3 as_seen(const glm::vec3& linear, Vision vision) {
  // Rows, as printed; GLM takes columns.
  static const std::array<glm::mat3, 4> matrices = {
      glm::mat3(1.0F),
      glm::transpose(glm::mat3(0.152286F, 1.052583F, -0.204868F, 0.114503F, 0.786281F, 0.099216F, -0.003882F,
                               -0.048116F, 1.051998F)),
      glm::transpose(glm::mat3(0.367322F, 0.860646F, -0.227968F, 0.280085F, 0.672501F, 0.047413F, -0.011820F,
                               0.042940F, 0.968881F)),
      glm::transpose(glm::mat3(1.255528F, -0.076749F, -0.178779F, -0.078411F, 0.930809F, 0.147602F, 0.004733F,
                               0.691367F, 0.303900F)),
  };
  return glm::clamp(matrices[static_cast<std::size_t>(vision)] * linear, 0.0F, 1.0F);
}

// L*, a*, b*.
inline glm::vec3 lab_of(const glm::vec3& linear) {
  const glm::mat3 xyz_of_rgb =
      glm::transpose(glm::mat3(0.4124564F, 0.3575761F, 0.1804375F, 0.2126729F, 0.7151522F, 0.0721750F,
                               0.0193339F, 0.1191920F, 0.9503041F));
  const glm::vec3 xyz = xyz_of_rgb * linear / glm::vec3(0.95047F, 1.0F, 1.08883F);
  const auto f = [](float t) {
    return t > 216.0F / 24389.0F ? std::cbrt(t) : (24389.0F / 27.0F * t + 16.0F) / 116.0F;
  };
  const float x = f(xyz.x), y = f(xyz.y), z = f(xyz.z);
  return {116.0F * y - 16.0F, 500.0F * (x - y), 200.0F * (y - z)};
}

// CIE 1976: about 2.3 is a difference that is just noticed.
inline float distance_seen(const glm::vec3& a_linear, const glm::vec3& b_linear, Vision vision) {
  return glm::distance(lab_of(as_seen(a_linear, vision)), lab_of(as_seen(b_linear, vision)));
}

inline float luminance(const glm::vec3& linear) {
  return glm::dot(linear, glm::vec3(0.2126F, 0.7152F, 0.0722F));
}

// 1 to 21.
inline float contrast(const glm::vec3& a_linear, const glm::vec3& b_linear) {
  const float a = luminance(a_linear) + 0.05F, b = luminance(b_linear) + 0.05F;
  return std::max(a, b) / std::min(a, b);
}

}  // namespace fulcrum::test
