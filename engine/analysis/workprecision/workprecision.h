#pragma once
// What each choice of an author costs and how far from a known truth it leaves the answer.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "haptics/geometry/triangle_mesh.h"
#include "haptics/math/pose.h"

namespace fulcrum::analysis::workprecision {

// One setting of one method.
struct WorkPoint {
  std::string method;
  double value = 0;   // of the study's parameter
  double error = 0;   // in the study's unit
  double cpu_us = 0;  // of this processor, for what the study calls its work
  double order = 0;   // measured, from the setting before: error ~ value^order; 0: none
};

struct WorkStudy {
  std::string truth;      // its name, one word or two
  std::string text;       // what it is, where its truth comes from, what the work is
  std::string parameter;  // with its unit
  std::string error_unit;
  std::vector<std::pair<std::string, double>> expected_order;  // by method
  std::vector<WorkPoint> points;                               // method by method, coarse to fine
  std::string baseline = {};  // the method that the others are measured against; empty: none
};

// From 0 to 1, with what is being done.
using StudyProgress = std::function<void(std::string_view what, double fraction)>;

// The shipped scene, where there is one: what is touched, what touches it, and about where they meet.
struct PipingParts {
  TriangleMesh scene_W, tool_T;
  Pose X_WT;
  Vec3 p_TC = Vec3::Zero();  // (3) m, the part of the tool that touches
};

std::vector<WorkStudy> study_work_precision(const std::optional<PipingParts>& piping,
                                            const StudyProgress& progress);

// Each on its own; `quick`: coarser settings and fewer repeats, for tests.
WorkStudy study_field(bool quick);
WorkStudy study_tube(bool quick);
WorkStudy study_sampling(bool quick);
WorkStudy study_rest(bool quick);
WorkStudy study_press_tube(bool quick);
WorkStudy study_press_groove(bool quick);
WorkStudy study_press_table(bool quick);
std::vector<WorkStudy> study_pegs(bool quick);                               // a study for each clearance
std::vector<WorkStudy> study_piping(const PipingParts& piping, bool quick);  // none: they do not meet
WorkStudy study_tick(bool quick);
WorkStudy study_oscillator(bool quick);
WorkStudy study_tumbling(bool quick);
WorkStudy study_tone(bool quick);
WorkStudy study_port(bool quick);

// Fills in the orders from neighbouring settings of each method.
void measure_orders(WorkStudy& study);

}  // namespace fulcrum::analysis::workprecision
