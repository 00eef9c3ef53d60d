#include "haptics/actuation/actuators.h"

namespace fulcrum {

int Actuators::count(const DeviceDesc& desc) {
  if (!desc.renders_force) return 0;
  switch (desc.kinematics) {
    case Kinematics::none:
      return 0;
    case Kinematics::cartesian:
      return desc.renders_torque ? 6 : 3;
    case Kinematics::arms:
      return Mechanism::motors(desc.mechanism);
  }
  return 0;
}

std::string Actuators::name(const DeviceDesc& desc, int motor) {
  static constexpr const char* axes[] = {"x", "y", "z", "roll_x", "roll_y", "roll_z"};
  return desc.kinematics == Kinematics::arms ? Mechanism::motor_name(desc.mechanism, motor) : axes[motor];
}

Actuators::Actuators(const DeviceDesc& desc) : count_(count(desc)), rows_(desc.renders_torque ? 6 : 3) {
  const int motors = count_;
  if (motors == 0) return;
  if (desc.kinematics == Kinematics::arms) {
    mechanism_.emplace(desc.mechanism);
    for (int motor = 0; motor < motors; ++motor)
      limits_[motor] = Mechanism::motor_limit(desc.mechanism, motor);
    return;
  }
  for (int motor = 0; motor < motors; ++motor) {
    limits_[motor] = motor < 3 ? desc.max_force : desc.max_torque;
    axes_(motor, motor) = 1;
  }
}

}  // namespace fulcrum
