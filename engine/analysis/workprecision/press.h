#pragma once
// A hand that presses a tool against something and holds it there: what is felt, under each contact response,
// beside what statics says.

#include <memory>
#include <vector>

#include "engine/analysis/workprecision/workprecision.h"
#include "haptics/world/scene_desc.h"

namespace fulcrum::analysis::workprecision {

struct PressPlace {
  Pose X_WT_start;  // free, or just touching
  Pose X_WG;        // where the hand holds in the end
  Wrench felt;      // the truth: of the coupling on the tool, about T
};

// The same bodies as triangles.
struct FacetedBodies {
  double facet = 0;  // m, what their curves are cut into
  std::shared_ptr<const FeatureMesh> tool, scene;
};

struct PressTask {
  std::shared_ptr<const Pointshell> shell;
  std::vector<std::shared_ptr<const DistanceField>> fields;  // of what is pressed, coarse to fine
  double stiffness = 2000;                                   // N/m, of a contact region
  double region_radius = 2e-3;                               // m
  CouplingDesc coupling;
  double arm = 1;                        // m: a torque counts by the force that it takes at this arm
  std::vector<PressPlace> springs;       // under penalty, voxel, static
  std::vector<PressPlace> rigid;         // under constraint, and on triangles
  std::vector<FacetedBodies> faceted{};  // coarse to fine
};

// A coupling whose springs yield as good as never, since the truths know straight ones.
CouplingDesc straight_springs();

// Adds a point for each response and field, one for each pair of faceted bodies, and the orders.
void measure_presses(WorkStudy& study, const PressTask& task);

}  // namespace fulcrum::analysis::workprecision
