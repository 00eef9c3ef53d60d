#include "haptics/bake/mass_properties.h"

namespace fulcrum {

MassProperties mass_properties(const Solid& solid) {
  const Vec3 reference = solid.bounds().center();  // integrals about a near point lose fewer digits
  double volume = 0.0;
  Vec3 first = Vec3::Zero();   // integral of x
  Mat3 second = Mat3::Zero();  // integral of x x^T
  for (const Triangle& corner : solid.mesh.triangles) {
    const Vec3 a = solid.mesh.vertices[corner[0]] - reference, b = solid.mesh.vertices[corner[1]] - reference,
               c = solid.mesh.vertices[corner[2]] - reference;
    const double six_volumes = a.dot(b.cross(c));  // of the tetrahedron from the reference point
    const Vec3 sum = a + b + c;
    volume += six_volumes / 6.0;
    first += six_volumes / 24.0 * sum;
    second += six_volumes / 120.0 *
              (sum * sum.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
  }
  MassProperties result;
  result.volume_m3 = volume;
  const Vec3 centre = first / volume;
  result.centre = reference + centre;
  const Mat3 about_centre = second - volume * centre * centre.transpose();
  result.inertia = about_centre.trace() * Mat3::Identity() - about_centre;
  return result;
}

}  // namespace fulcrum
