#pragma once
// The studies: subcommands that a program of their own carries out, fulcrum-studies, so that who trains need
// not build them. `fulcrum NAME ...` starts it; it lies beside fulcrum.

#include <array>

namespace fulcrum::app {

struct Study {
  const char* name;
  const char* about;  // one line
};

inline constexpr Study kCompareStudy{
    "compare", "Variants of torque substitution over the same trials: torque, force and time"};
inline constexpr Study kAmbiguityStudy{"ambiguity",
                                       "Which impacts on the tool feel alike, and where to hold it instead"};
inline constexpr Study kHardnessStudy{
    "hardness", "Where on a device a moment makes a surface feel harder, and where it cannot"};
inline constexpr Study kStabilityStudy{"stability",
                                       "How stiff a wall each device can hold: simulated, and by theory"};
inline constexpr Study kWorkPrecisionStudy{
    "workprecision", "What each choice costs, and how far from a known truth it leaves the answer"};
inline constexpr Study kUniformityStudy{
    "uniformity", "Whether a ball feels alike along a whole stick, though the device has a mass at one end"};

inline constexpr std::array<Study, 6> kStudies{kCompareStudy,   kAmbiguityStudy,     kHardnessStudy,
                                               kStabilityStudy, kWorkPrecisionStudy, kUniformityStudy};

}  // namespace fulcrum::app
