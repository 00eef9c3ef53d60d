#include "haptics/safety/energy_ledger.h"

#include "haptics/math/rotation.h"

namespace fulcrum {

void EnergyLedger::book(const Pose& X_DH, const Wrench& F_H_D, double stored) noexcept {
  if (started_) {
    const Vec3 turn = rotation_vector(X_DH.q * last_X_DH_.q.conjugate());
    port_ -= F_H_D.force.dot(X_DH.p - last_X_DH_.p) + F_H_D.torque.dot(turn);
    port_ -= stored - last_stored_;
  }
  started_ = true;
  last_X_DH_ = X_DH;
  last_stored_ = stored;
}

}  // namespace fulcrum
