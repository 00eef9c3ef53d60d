#pragma once
// The lights that models bring, as shaders read them.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/render/visual_desc.h"
#include "shaders/shared/light.h"

namespace fulcrum::render {

class PunctualLights {
public:
  PunctualLights() = default;
  // Of a valid description.
  explicit PunctualLights(const VisualDesc& desc);

  // As a camera of these layers sees them, to which the others are black, while the movable instances are
  // there. X_WM: as in FrameState.
  gpu::LightsData data(std::span<const glm::mat4> X_WM, std::uint32_t layers) const;

private:
  struct Light {
    PunctualLight desc;
    std::optional<std::size_t> carried_by;  // of the movable instances alone
  };

  std::vector<Light> lights_;
};

}  // namespace fulcrum::render
