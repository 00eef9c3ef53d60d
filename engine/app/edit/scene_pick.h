#pragma once
// What of a scene a pixel shows: where it is, and of which part.

#include <optional>
#include <string>

#include "engine/app/prepare/prepare.h"
#include "engine/render/plan.h"
#include "engine/render/visual_desc.h"

namespace fulcrum::app {

struct Picked {
  bool on_tool = false;         // the places are then those of the tool's model, in M, and not in W
  Vec3 p = Vec3::Zero();        // (3) m
  Vec3 nhat = Vec3::UnitY();    // (3) unit, out of the surface, towards the eye
  std::string part;             // "board/step": the model's name and the part's
  std::optional<double> depth;  // m, of the part behind there, along the line of sight; none: it is open
};

// x, y: px of the picture, from its top left. X_WT: where the tool is. Every triangle of the models is looked
// at. None: there is nothing. Models that show others cut open are not looked at.
std::optional<Picked> pick(const Prepared& prepared, const Pose& X_WT, const render::Camera& camera,
                           const render::Extent& picture, double x, double y);

// As an author writes it: "[0.01, 0.02, 0.03]  # board/step, normal [0, 1, 0], 15 mm deep".
std::string picked_text(const Picked& picked);

}  // namespace fulcrum::app
