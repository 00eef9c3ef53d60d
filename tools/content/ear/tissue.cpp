#include "tools/content/ear/tissue.h"

#include <algorithm>

#include "haptics/math/functions.h"
#include "tools/content/mesh/paint.h"
#include "tools/content/mesh/smooth.h"

namespace fulcrum::content::tissue {
namespace {

using Eigen::Vector3d;

// Linear colours, chosen by eye after photographs and anatomical plates.
const Vector3d pale_skin(0.71, 0.42, 0.31);
const Vector3d red_skin(0.66, 0.30, 0.22);
const Vector3d outer_lining(0.66, 0.38, 0.29);
const Vector3d inner_lining(0.72, 0.44, 0.37);
const Vector3d pearl(0.74, 0.75, 0.74);
const Vector3d hammer(0.95, 0.86, 0.68);
const Vector3d annulus(0.84, 0.80, 0.72);
const Vector3d flaccid(0.66, 0.36, 0.30);
const Vector3d dermis(0.70, 0.36, 0.30);
const Vector3d fat(0.80, 0.60, 0.26);
const Vector3d muscle(0.42, 0.10, 0.08);
const Vector3d cartilage(0.56, 0.66, 0.70);
const Vector3d bone(0.80, 0.72, 0.55);
const Vector3d marrow(0.50, 0.34, 0.24);

constexpr double bony = -8.5;  // mm, z: further in the canal runs through bone

// Air cells and marrow spaces: 1 in one, 0 in the bone between.
double cells(const Vector3d& p) {
  const double noise = mottle(1.15 * p) + 0.6 * mottle(2.3 * p + Vector3d(3.1, 1.7, 4.2));
  return smooth_step(0.12, 0.34, noise);
}

}  // namespace

Vector3d skin(const Flesh& flesh, const Vector3d& p) {
  // Blood shows at the rim, the lobule and in the concha.
  const double off_head = smooth_step(9.0, 17.0, p.z());
  const double lobule = smooth_step(-12.0, -20.0, p.y()) * smooth_step(3.0, 6.0, p.z());
  const double concha = 0.5 * flesh.pinna().concha(p.x(), p.y()) * smooth_step(9.0, 3.0, p.z());
  const double red = std::clamp(0.55 * off_head + 0.5 * lobule + concha + 0.16 * mottle(0.35 * p), 0.0, 1.0);
  return mixed(pale_skin, red_skin, red) * (1.0 + 0.05 * mottle(1.1 * p));
}

Vector3d lining(const Vector3d& p) {
  return mixed(outer_lining, inner_lining, smooth_step(-4.0, -12.0, p.z())) * (1.0 + 0.06 * mottle(0.9 * p));
}

Vector3d mucosa(const Vector3d& p) {
  return Vector3d(0.70, 0.42, 0.36) * (1.0 + 0.06 * mottle(0.9 * p));
}

Vector3d drum(const Canal& canal, const Vector3d& p_W) {
  const Vector3d p = canal.X_WD().inverse() * p_W;
  const double part = canal.drum_part(p.x(), p.y());
  Vector3d colour = pearl * (1.0 + 0.05 * mottle(0.8 * p));
  // Light comes back from the lower front quarter: the cone of light.
  const double angle = math::atan2(p.y(), p.x());
  const double cone = bump(angle + 0.95, 0.24) * smooth_step(0.08, 0.2, part) * smooth_step(0.92, 0.6, part);
  colour = mixed(colour, Vector3d(0.95, 0.95, 0.92), 0.7 * cone);
  // The part above the lateral process is slack and red; vessels run down along the handle.
  const double above = smooth_step(0.62, 0.8, part) * smooth_step(2.6, 3.4, p.y());
  colour = mixed(colour, flaccid, 0.8 * above);
  colour = mixed(colour, hammer, 0.9 * canal.malleus(p.x(), p.y()));
  const double rim = bump(part - 1.0, 0.09);
  colour = mixed(colour, annulus, rim * smooth_step(3.8, 3.0, p.y()));
  return mixed(colour, inner_lining, smooth_step(1.08, 1.16, part));
}

Vector3d cut(const Flesh& flesh, const Vector3d& p) {
  const double under_skin = -flesh.distance(p);
  const double to_canal = -flesh.canal().to_wall(p);
  const double along_canal = smooth_step(5.0, 3.0, to_canal);
  const double depth = -flesh.above_head(p);
  const double edge = 1.3 * mottle(0.45 * p);
  const Vector3d spongy = mixed(bone, marrow, 0.8 * cells(p) * smooth_step(1.4, 2.2, to_canal));
  const Vector3d soft =
      mixed(fat * (1.0 + 0.08 * mottle(1.9 * p)), muscle, smooth_step(6.5, 7.5, depth + edge));
  Vector3d colour = mixed(soft, spongy, smooth_step(10.4, 11.0, depth + 0.8 * edge));
  // Along the canal the bone comes out to its last two thirds, and cartilage holds the first.
  colour = mixed(colour, spongy, along_canal * smooth_step(bony + 0.3, bony - 0.3, p.z()));
  const double gristle = smooth_step(0.9, 1.2, to_canal) * smooth_step(3.2, 2.9, to_canal);
  colour = mixed(colour, cartilage, gristle * smooth_step(bony - 0.3, bony + 0.3, p.z()));
  // The pinna's own cartilage lies in the middle of its sheet.
  const double pinna = smooth_step(1.0, 2.0, p.z());
  colour = mixed(colour, cartilage, pinna * smooth_step(0.7, 0.9, under_skin));
  const double skin_thickness = p.z() < bony ? 0.35 : 0.9;
  return mixed(dermis, colour, smooth_step(skin_thickness - 0.15, skin_thickness + 0.15, under_skin));
}

}  // namespace fulcrum::content::tissue
