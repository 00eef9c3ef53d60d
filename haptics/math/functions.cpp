#include "haptics/math/functions.h"

#include <sleef.h>

// "cinz": no fused multiply-add, the same result everywhere. "purec": plain C, which never asks what the
// processor has; SLEEF's functions without it do.
namespace fulcrum::math {

double sin(double x) noexcept {
  return Sleef_cinz_sind1_u10purec(x);
}

double cos(double x) noexcept {
  return Sleef_cinz_cosd1_u10purec(x);
}

double tan(double x) noexcept {
  return Sleef_cinz_tand1_u10purec(x);
}

double acos(double x) noexcept {
  return Sleef_cinz_acosd1_u10purec(x);
}

double atan2(double y, double x) noexcept {
  return Sleef_cinz_atan2d1_u10purec(y, x);
}

double exp(double x) noexcept {
  return Sleef_cinz_expd1_u10purec(x);
}

double expm1(double x) noexcept {
  return Sleef_cinz_expm1d1_u10purec(x);
}

double log(double x) noexcept {
  return Sleef_cinz_logd1_u10purec(x);
}

double log1p(double x) noexcept {
  return Sleef_cinz_log1pd1_u10purec(x);
}

double log10(double x) noexcept {
  return Sleef_cinz_log10d1_u10purec(x);
}

double pow(double x, double y) noexcept {
  return Sleef_cinz_powd1_u10purec(x, y);
}

double sinh(double x) noexcept {
  return Sleef_cinz_sinhd1_u10purec(x);
}

double cosh(double x) noexcept {
  return Sleef_cinz_coshd1_u10purec(x);
}

double cbrt(double x) noexcept {
  return Sleef_cinz_cbrtd1_u10purec(x);
}

double hypot(double x, double y) noexcept {
  return Sleef_cinz_hypotd1_u05purec(x, y);
}

}  // namespace fulcrum::math
