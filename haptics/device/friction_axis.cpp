#include "haptics/device/friction_axis.h"

#include <algorithm>
#include <cmath>

#include "haptics/math/functions.h"

namespace fulcrum {
namespace {

struct State {
  double x, v;
};

// m x'' = F - c x' - k (x - h t): the state after t. With y = x - h t this is a damped oscillator about
// y* = (F - c h) / k, or without a spring a mass that nears its terminal speed.
State oscillate(State s, double m, double c, double k, double F, double h, double t) {
  if (k <= 0) {
    if (c <= 0) return {s.x + s.v * t + 0.5 * F / m * t * t, s.v + F / m * t};
    const double terminal = F / c, gone = -math::expm1(-c / m * t);
    return {s.x + terminal * t + (s.v - terminal) * m / c * gone, s.v + (terminal - s.v) * gone};
  }
  const double rest = (F - c * h) / k;
  const double y = s.x - rest, u = s.v - h;
  const double a = 0.5 * c / m, disc = a * a - k / m;
  double C, S;  // e^(-at) cosh(wt) and e^(-at) sinh(wt)/w, or with cos and sin
  if (std::abs(disc) * t * t < 1e-8) {
    const double e = math::exp(-a * t), z = disc * t * t;
    C = e * (1 + z / 2);
    S = e * t * (1 + z / 6);
  } else if (disc > 0) {
    const double w = std::sqrt(disc), up = math::exp((w - a) * t), down = math::exp(-(w + a) * t);
    C = 0.5 * (up + down);
    S = 0.5 * (up - down) / w;
  } else {
    const double w = std::sqrt(-disc), e = math::exp(-a * t);
    C = e * math::cos(w * t);
    S = e * math::sin(w * t) / w;
  }
  return {rest + h * t + y * C + (u + a * y) * S, h + u * C - (a * u + k / m * y) * S};
}

}  // namespace

// Slides with friction against `sign` until t or until the speed is zero; answers how long it slid.
double FrictionAxis::slide(const Load& load, double sign, double t) noexcept {
  const double c = damping + load.hand_damping;
  const double F =
      load.force - friction * sign + load.stiffness * load.hand_x + load.hand_damping * load.hand_v;
  const auto at = [&](double time) {
    return oscillate({x, v}, mass, c, load.stiffness, F, load.hand_v, time);
  };
  const State end = at(t);
  double slid = t;
  State s = end;
  if (end.v * sign < 0) {
    double before = 0, after = t;
    for (int i = 0; i < 60 && before < after; ++i) {
      const double middle = 0.5 * (before + after);
      (at(middle).v * sign >= 0 ? before : after) = middle;
    }
    slid = after;
    s = at(slid);
    s.v = 0;
  }
  x = s.x;
  v = s.v;
  return slid;
}

void FrictionAxis::advance(const Load& given, double tick_s) noexcept {
  Load load = given;
  double left = tick_s;
  for (int events = 0; left > 0 && events < 32; ++events) {
    double sign = v > 0 ? 1.0 : -1.0;
    if (v == 0) {
      // Stuck while the other forces stay within friction; they change at the rate k_h v_h.
      const double push = load.force - load.stiffness * (x - load.hand_x) + load.hand_damping * load.hand_v;
      const double rate = load.stiffness * load.hand_v;
      if (std::abs(push) <= friction) {
        const double room = rate > 0 ? friction - push : friction + push;
        const double loose = rate != 0 ? room / std::abs(rate) : left;
        if (loose >= left) return;
        load.hand_x += load.hand_v * loose;
        left -= loose;
        sign = rate > 0 ? 1.0 : -1.0;
      } else {
        sign = push > 0 ? 1.0 : -1.0;
      }
    }
    const double slid = std::max(slide(load, sign, left), 1e-12);
    load.hand_x += load.hand_v * slid;
    left -= slid;
  }
}

}  // namespace fulcrum
