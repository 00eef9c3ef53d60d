#pragma once
// What a place in the scene is called.

#include <string>

#include "engine/scenario/assemble.h"

namespace fulcrum::app {

// The part of the touched models whose triangles are nearest to p_W: the model's file, and the part's name in
// it where it has one.
std::string nearest_part(const scenario::Scenario& scenario, const scenario::LoadedModels& models,
                         const Vec3& p_W);

}  // namespace fulcrum::app
