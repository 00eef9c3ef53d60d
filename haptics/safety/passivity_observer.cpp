#include "haptics/safety/passivity_observer.h"

namespace fulcrum {

PassivityObserver::PassivityObserver(const Vec6& step, bool renders_force, bool renders_torque)
    : work_(step) {
  rendered_.head<3>().setConstant(renders_force ? 1 : 0);
  rendered_.tail<3>().setConstant(renders_torque ? 1 : 0);
}

void PassivityObserver::update(const Vec6& d_D, const Port& port) noexcept {
  Vec6 F;
  F << port.F_H_D.force, port.F_H_D.torque;
  const Vec6 held = F.cwiseProduct(rendered_);
  if (port.open && !open_) {
    before_ = least_ + port.springs;
    stores_ = 0;
    work_.open(held);
  } else if (port.open) {
    work_.book(d_D, held);
    const Vec6 wound = d_D.cwiseProduct(Vec6::Ones() - rendered_);
    const double by_winding = -0.5 * (last_F_ + F).dot(wound);
    unrendered_ += by_winding;
    stores_ += by_winding - (port.weight - last_weight_);
  }
  if (port.open) least_ = before_ + stores_ + work_.least();
  open_ = port.open;
  last_F_ = F;
  last_weight_ = port.weight;
  springs_ = port.springs;
}

}  // namespace fulcrum
