#pragma once
// The parts of a hardness study, each of one device under one strike: what hardness.h says of them.

#include <span>

#include "engine/analysis/hardness/hardness.h"

namespace fulcrum::analysis::hardness {

class HardnessSurvey {
public:
  // The device has to outlive it.
  HardnessSurvey(const DeviceDesc& device, const StrikeSetting& setting)
      : device_(device), setting_(setting), striker_(device, setting) {}

  HardnessRow row(PulseMethod method, const Pose& X_DH, const std::string& pose, const Vec3& nhat_D,
                  double phi_deg);
  std::vector<HardnessRow> rows_at_home(std::span<const PulseMethod> methods, std::span<const double> phis);
  DirectionMap map(PulseMethod method, double phi_deg, bool all_tilts);
  AngleCurve over_angles(PulseMethod method);
  TiltSample lean(double lean_deg);
  PoseAt pose(const Vec3& p_DH);
  Front front(const std::string& name, const Vec3& nhat_D);
  TickMethod in_the_tick(PulseMethod method);
  DirectionMeans over_directions(PulseMethod method);
  // The grasp along stylus_D at every surface.
  DirectionMeans along_stylus(PulseMethod method, const Vec3& stylus_D);
  ShownMethod shown(PulseMethod method);
  // The grasp along stylus_D, whatever that makes phi and lean.
  PaperAxis axis(const std::string& name, const Vec3& nhat_D, const Vec3& stylus_D);

private:
  DirectionMeans means(PulseMethod method, std::span<const Strike> strikes);
  Gain gain(PulseMethod method, const Pose& X_DH, const Strike& strike, const PulseOutcome& force_only);

  const DeviceDesc& device_;
  StrikeSetting setting_;
  Striker striker_;
};

}  // namespace fulcrum::analysis::hardness
