#include "haptics/safety/energy_ledger.h"

#include "haptics/math/rotation.h"

namespace fulcrum {

void EnergyLedger::book(const Pose& X_WH, const Port& port) noexcept {
  if (port.open && !open_) {
    port_ += port.springs;
  } else if (port.open) {
    const double by_turning = -port.F_H_W.torque.dot(rotation_vector(X_WH.q * last_X_WH_.q.conjugate()));
    port_ += by_turning - port.F_H_W.force.dot(X_WH.p - last_X_WH_.p);
    port_ -= port.weight - last_weight_;
    if (!port.renders_torque) unrendered_ += by_turning;
  }
  open_ = port.open;
  last_X_WH_ = X_WH;
  last_weight_ = port.weight;
}

}  // namespace fulcrum
