#include "haptics/effects/texture/texture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/math/functions.h"

namespace fulcrum {

Texture::Texture(const TextureDesc& desc, double tick_s)
    : desc_(desc),
      dhat_W_(desc.direction_W.normalized()),
      wave_number_(2 * std::numbers::pi / desc.wavelength),
      tick_s_(tick_s) {
  record_.gain = desc.gain;
}

void Texture::apply(const Command& command) noexcept {
  if (command.kind == Command::Kind::texture_gain) record_.gain = command.gain();
}

Wrench Texture::process(const Tick& tick) noexcept {
  const double ridges = std::abs(tick.v_WH.dot(dhat_W_)) * tick_s_ / desc_.wavelength;
  record_.fade = std::clamp((kFastestRidges - ridges) / (kFastestRidges - kWholeRidges), 0.0, 1.0);
  Wrench F_H_W;
  const double gain = tick.engaged ? record_.gain * record_.fade : 0.0;
  for (const ContactRegion& region : tick.regions) {
    if (gain == 0) break;
    const Vec3& nhat_W = region.nhat_W;
    const double pressing = std::max(0.0, region.force_W.dot(nhat_W));
    const double slope = steepest() * math::cos(wave_number_ * region.p_W.dot(dhat_W_));
    const Vec3 along_W = dhat_W_ - dhat_W_.dot(nhat_W) * nhat_W;
    const Vec3 force_W = -gain * pressing * slope * along_W;
    F_H_W.force += force_W;
    F_H_W.torque += (region.p_W - tick.p_WH).cross(force_W);
  }
  record_.force_W = F_H_W.force;
  return F_H_W;
}

}  // namespace fulcrum
