#pragma once
// A device's arms as the handle moves them, and the wrench on the handle that each motor makes.
//
// With tau the motors' efforts and G the matrix below, F_H_D = G tau. An arm of three joints pushes its end
// with f = J^-T tau, J the Jacobian of its joints: that is J_ik^T of "Hybrid Force-Moment Braking Pulse"
// (Appendix I), B diag(wRs, wRs, 1) A diag(sRw, sRw) transposed, arm by arm and with B = J^-1 (Eq. 24 there
// prints the forward Jacobian). A parallelogram's motor sets an angle against an earlier body; its column
// follows from the change of coordinates.
//
// At a stretch or a fold J is singular: the links themselves take the force there, and a motor's lever on it
// grows without end. It is held at what kMinLever allows, so that efforts stay finite and go on smoothly.

#include <optional>
#include <string>
#include <vector>

#include "haptics/actuation/joint_chain.h"
#include "haptics/device/device.h"
#include "haptics/math/result.h"

namespace fulcrum {

// Wrenches on the handle about H, in D, one column for a unit effort of each motor: force above torque. The
// columns of motors that the device has not are zero.
using WrenchMatrix = Eigen::Matrix<double, 6, kMaxMotors>;

class Mechanism {
public:
  // A table that refuse() has passed.
  explicit Mechanism(const MechanismDesc& desc);
  // What is wrong with a table, as a sentence.
  static std::optional<Error> refuse(const MechanismDesc& desc);

  static int motors(const MechanismDesc& desc);
  // Motors in the order of the table: arm by arm, base to end, then the spin.
  static std::string motor_name(const MechanismDesc& desc, int motor);
  static double motor_limit(const MechanismDesc& desc, int motor);  // N m

  // The arms to where the handle is: from where they were, so that it counts how it came there.
  void follow(const Pose& X_DH) noexcept;

  const WrenchMatrix& wrenches() const { return wrenches_; }
  // The body Jacobian at a control point G, p_HG (3) m in H, of an arm of six: how G moves and turns, in H,
  // for a unit rate of each motor. Efforts for a wrench about G in H: tau = J^T F ("Compensating device
  // inertia for 6-DOF haptic rendering", Eq. 1); with the wrong G the hand feels J_true^-T J_used^T F. Zero
  // for other arms: their gimbal turns without motors.
  WrenchMatrix jacobian(const Vec3& p_HG) const noexcept;
  int arms() const { return static_cast<int>(arms_.size()); }
  // Where the joints of an arm are, and its end.
  const JointChain::Placed& placed(int arm) const noexcept;
  const JointAngles& angles(int arm) const { return arms_[static_cast<std::size_t>(arm)].posture.angles; }
  // m, how far an arm's end stays from where the handle holds it; above 0 out of reach.
  double out_of_reach() const { return out_of_reach_; }

  static constexpr double kMinLever = 2e-3;  // m

private:
  struct Arm {
    JointChain chain;
    Pose X_HE;  // the handle's hold on the end
    JointChain::Posture posture;
  };
  void write_columns(const Arm& arm, const Pose& X_DH, int first) noexcept;

  std::vector<Arm> arms_;
  std::optional<Vec3> spin_H_;  // (3) the axis over the ratio
  WrenchMatrix wrenches_ = WrenchMatrix::Zero();
  Quat q_DH_ = Quat::Identity();
  WrenchMatrix twists_ = WrenchMatrix::Zero();  // of the handle about H, in D, for a unit rate of each motor
  double out_of_reach_ = 0;
};

}  // namespace fulcrum
