#pragma once
// The mirror image of a scene, for a trainee who holds the tool in the left hand (haptics/math/mirror.h): in
// W, in the frame of each model, in H and in D. A hand that moves as the mirror image of another moves the
// tool as the mirror image of the other's tool, and is pushed so. The device is the one that it was: only
// where it stands is mirrored. Nothing that ticks or draws knows of it.
//
// What has no mirror image stays: a simulated hand's tremor, and the axes along which friction is found.
// Lettering is not drawn (assemble_visual.cpp).

#include <string>

#include "engine/assets/model.h"
#include "engine/scenario/scenario.h"

namespace fulcrum::scenario {

// Why a scenario has no mirror image, as a sentence without its stop; empty: it has one.
std::string why_not_mirrored(const Scenario& scenario);

// A checkpoint with a mirrored_name takes it, and keeps the other as its mirrored one: mirrored twice, a
// scenario is what it was. Its models are files, and are mirrored where they are loaded.
void mirror(Scenario& scenario);

void mirror(Model& model);

}  // namespace fulcrum::scenario
