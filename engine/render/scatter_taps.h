#pragma once
// How far light spreads below surfaces, and where shaders/scatter.frag looks for what spreads to a place.
//
// B. Burley, "Extending the Disney BRDF to a BSDF with Integrated Subsurface Scattering", SIGGRAPH 2015
// course; P. Christensen and B. Burley, "Approximate Reflectance Profiles for Efficient Subsurface
// Scattering", Pixar Technical Memo 15-04, 2015: of the light that enters a point, R(r) = (e^(-r/d) +
// e^(-r/3d)) / (8 pi d r) comes out again per area at a distance r. d is the scatter distance: half of the
// light comes out within 1.55 d, in the mean 2.5 d away. Sampling on the screen: E. Golubev, "Efficient
// Screen-Space Subsurface Scattering Using Burley's Normalized Diffusion in Real-Time", SIGGRAPH 2018 course.

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "engine/render/visual_desc.h"

namespace fulcrum::render {

constexpr int kMostScatterTaps = 64;           // of one pixel
constexpr std::size_t kScatterPatterns = 16;   // of the pixels of a square of four by four
constexpr std::size_t kMostScattering = 1023;  // instances: their numbers have ten bits of a pixel

// (patterns x per_pixel) for a d of 1: xy where to look, z how far that is, w z / (e^-z + e^(-z/3)): what a
// sample weighs is the profile there times that. All of them lie as evenly in the profile as may be.
std::vector<glm::vec4> scatter_taps(int per_pixel);

// By instance, its number among those that light spreads below, from 1; 0: it does not.
std::vector<std::uint32_t> scatter_numbers(const VisualDesc& desc);

// By that number less 1: xyz the scatter distances of red, green and blue, w the greatest of them (m).
std::vector<glm::vec4> scatter_distances(const VisualDesc& desc);

glm::vec4 with_greatest(const glm::vec3& distance);

}  // namespace fulcrum::render
