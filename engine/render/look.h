#pragma once
// Which of the things that a detailed surface may have a material has: what a pipeline is built for, as the
// bits FULCRUM_LOOK_ of shaders/shared/material.h.

#include <cstdint>
#include <optional>
#include <string>

#include "engine/render/visual_desc.h"

namespace fulcrum::render {

// None: it is a plain one.
std::optional<std::uint32_t> look_of(const Material& material);

bool is_blended(std::uint32_t look);
bool throws_shadow(const Instance& instance,
                   const Material& material);  // not what is blended or cut out whole
bool lets_light_through(std::uint32_t look);
bool is_all_cut_out(std::uint32_t look);  // nothing of it is there
bool is_masked(std::uint32_t look);       // and not blended: it is there, or it is not
bool is_scattering(std::uint32_t look);   // light spreads below it: neither metal nor what is seen through
std::uint32_t without_scattering(std::uint32_t look);
bool is_two_sided(std::uint32_t look);
bool reads_places(std::uint32_t look);  // in textures: it has one, or is cut out

// "base colour and normal textures, clear coat".
std::string describe_look(std::uint32_t look);

}  // namespace fulcrum::render
