#include "engine/analysis/picture/colour.h"

#include "haptics/math/functions.h"

namespace fulcrum::analysis::picture {
namespace {

// ITU-R BT.709-6, table 1: chromaticities of red, green and blue, and of white (D65).
struct Rec709 {
  Mat3 from_linear, to_linear;  // of XYZ in relation to that of white
  Vec3 luminance;

  Rec709() {
    Mat3 primaries;
    primaries << 0.640, 0.300, 0.150,  //
        0.330, 0.600, 0.060,           //
        0.030, 0.100, 0.790;
    const Vec3 white = Vec3(0.3127, 0.3290, 0.3583) / 0.3290;
    const Vec3 amounts = primaries.inverse() * white;
    const Mat3 xyz = primaries * amounts.asDiagonal();
    from_linear = white.cwiseInverse().asDiagonal() * xyz;
    to_linear = from_linear.inverse();
    luminance = xyz.row(1);
  }
};

const Rec709& rec709() {
  static const Rec709 it;
  return it;
}

// Of CIE L*a*b*: a cube root that is a line near black.
double lightened(double t) {
  constexpr double delta = 6.0 / 29.0;
  return t > delta * delta * delta ? math::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29.0;
}

Vec3 opposed(const Vec3& xyz) {
  return {116 * xyz.y() - 16, 500 * (xyz.x() - xyz.y()), 200 * (xyz.y() - xyz.z())};
}

}  // namespace

double decoded(double encoded) {
  return encoded > 0.04045 ? math::pow((encoded + 0.055) / 1.055, 2.4) : encoded / 12.92;
}

double luminance(const Vec3& linear) {
  return rec709().luminance.dot(linear);
}

Vec3 opponent_of(const Vec3& linear) {
  return opposed(rec709().from_linear * linear);
}

Vec3 linear_of(const Vec3& opponent) {
  const double y = (opponent.x() + 16) / 116;
  return rec709().to_linear * Vec3(y + opponent.y() / 500, y, y - opponent.z() / 200);
}

Vec3 lab_of(const Vec3& linear) {
  return opposed((rec709().from_linear * linear).unaryExpr(&lightened));
}

}  // namespace fulcrum::analysis::picture
