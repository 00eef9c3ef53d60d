#include "drivers/mouse/mouse_device.h"

#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

// Twice a first-order lag of 15 ms: no step in speed, and less delay than is seen (45 ms between picture and
// force).
constexpr double kLag = 15e-3;  // s

Pose toward(const Pose& from, const Pose& to, double part) {
  const Vec3 turn = rotation_vector(to.q * from.q.conjugate());
  return {(quaternion_exp(part * turn) * from.q).normalized(), from.p + part * (to.p - from.p)};
}

}  // namespace

DeviceDesc MouseDevice::mouse_desc() {
  DeviceDesc desc;
  desc.name = "mouse";
  desc.kinematics = Kinematics::none;
  desc.renders_force = false;
  desc.max_force = 0;
  return desc;
}

MouseDevice::MouseDevice(const DeviceDesc& desc, const Pose& X_DH, double tick_s)
    : desc_(desc), follow_(-math::expm1(-tick_s / kLag)), halfway_(X_DH), X_DH_(X_DH) {
  aim(X_DH);
}

void MouseDevice::aim(const Pose& X_DH) noexcept {
  aim_.draft() = X_DH;
  aim_.publish();
}

DeviceSample MouseDevice::read() noexcept {
  halfway_ = toward(halfway_, aim_.newest(), follow_);
  X_DH_ = toward(X_DH_, halfway_, follow_);
  DeviceSample sample;
  sample.X_DH = X_DH_;
  return sample;
}

}  // namespace fulcrum
