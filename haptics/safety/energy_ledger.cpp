#include "haptics/safety/energy_ledger.h"

namespace fulcrum {

void EnergyLedger::book(const Vec6& d, const Vec6& within_tick, const Port& port) noexcept {
  Vec6 F;
  F << port.F_H_W.force, port.F_H_W.torque;
  if (port.open && !open_) {
    port_ += port.springs;
  } else if (port.open) {
    Vec6 held = within_tick;
    if (!renders_force_) held.head<3>().setZero();
    if (!renders_torque_) held.tail<3>().setZero();
    const Vec6 mean_F = 0.5 * (last_F_ + F);
    // Row by row: what the hand put in. F d + (F' - F)(d - s) / 2 = F s + (F + F')(d - s) / 2.
    const Vec6 work = -(last_F_.cwiseProduct(held) + mean_F.cwiseProduct(d - held));
    port_ += work.sum() - (port.weight - last_weight_);
    if (!renders_force_) unrendered_ += work.head<3>().sum();
    if (!renders_torque_) unrendered_ += work.tail<3>().sum();
  }
  open_ = port.open;
  last_F_ = F;
  last_weight_ = port.weight;
  springs_ = port.springs;
}

}  // namespace fulcrum
