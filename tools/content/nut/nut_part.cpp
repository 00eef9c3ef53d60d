#include "tools/content/nut/nut_part.h"

#include <cmath>

#include "tools/content/mesh/steel.h"
#include "tools/content/nut/place.h"

namespace fulcrum::content {

using Eigen::Isometry3d;
using Eigen::Translation3d;

Model make_nut() {
  Model model{.name = "nut", .materials = {brushed("zinc", {0.50, 0.51, 0.52}, 0.32)}, .parts = {}};
  const Solid nut =
      threaded_nut(m12_thread, m12_iso.nut_height, m12_iso.across_flats, LeadIn::chamfered, thread_sectors);
  model.parts.push_back(
      {.name = "nut",
       .material = 0,
       .solid = transformed(nut, Isometry3d(Translation3d(0.0, 0.0, -0.5 * m12_iso.nut_height))),
       .uv = unwrapped_round(nut, {2, 34.0 * mm})});
  return model;
}

Solid bare_bolt() {
  return transformed(threaded_rod(m12_thread, bolt_end - bolt_foot, LeadIn::chamfered, thread_sectors),
                     Isometry3d(Translation3d(0.0, 0.0, bolt_foot)));
}

double out_of_step(double z, double angle) {
  const double pitch = m12_thread.pitch;
  const double above = z - 0.5 * m12_iso.nut_height - bolt_foot - pitch * angle / (2.0 * pi);
  return above - pitch * std::round(above / pitch);
}

}  // namespace fulcrum::content
