#pragma once
// Ridges that are felt while the tool slides, on a surface that is smooth: a force against the slope of a
// height that the surface does not have, as M. Minsky, M. Ouh-young, O. Steele, F. P. Brooks Jr. and
// M. Behensky rendered sandpaper ("Feeling and Seeing: Issues in Force Display", I3D 1990):
//     h(s) = A sin(2 pi s / L)        s = p . d: where a region is pressed, along the direction d across
//     ridges f    = -|f_n| h'(s) d_t         f_n: what presses there; d_t = d - (d . n) n: d in the surface
// A tool without friction that is pushed up a real slope h' feels the same to first order of h'.
//
// At a constant f_n the force has the potential |f_n| h: sliding over a ridge gives back what it took. In
// ticks of T it does so to second order of v T / L; and near a trough it is a spring of stiffness
//     K = |f_n| A (2 pi / L)^2,
// held between ticks, which a device and hand of damping b hold still while K < 2 b / T (tested in
// tests/haptics/effects/texture_test.cpp). Beyond, passivity control acts as for any spring.
//
// Ridges that pass in fewer than 2.5 ticks would be felt as other ridges: the force fades out from a fifth of
// a ridge per tick to two fifths.

#include <span>

#include "haptics/contact/contact_set.h"
#include "haptics/effects/texture/texture_record.h"
#include "haptics/math/mirror.h"
#include "haptics/math/pose.h"
#include "haptics/math/wrench.h"
#include "haptics/tick/command.h"

namespace fulcrum {

struct TextureDesc {
  double wavelength = 2e-3;          // m, L: from ridge to ridge
  double height = 20e-6;             // m, A: of a ridge over the surface
  Vec3 direction_W = Vec3(1, 0, 0);  // across the ridges; of any length
  double gain = 1;                   // of the force; 0: named but off
};

inline void mirror(TextureDesc& desc) {
  mirror(desc.direction_W);
}

class Texture {
public:
  static constexpr double kWholeRidges = 0.2;    // per tick, up to which they are felt whole
  static constexpr double kFastestRidges = 0.4;  // per tick, from which on nothing is felt

  Texture(const TextureDesc& desc, double tick_s);

  struct Tick {
    std::span<const ContactRegion> regions;  // that touch
    Vec3 p_WH = Vec3::Zero();                // (3) m, the handle's place on the tool
    Vec3 v_WH = Vec3::Zero();                // (3) m/s, of the hand
    bool engaged = true;                     // false while clutched: the hand feels nothing
  };
  // On the handle, about H.
  Wrench process(const Tick& tick) noexcept;

  void apply(const Command& command) noexcept;

  // The largest slope h', which is also the largest force over the one that presses.
  double steepest() const { return desc_.height * wave_number_; }
  // m/s, of the hand across the ridges, up to which they are felt whole.
  double fastest() const { return kWholeRidges * desc_.wavelength / tick_s_; }

  const TextureRecord& record() const { return record_; }
  const TextureDesc& desc() const { return desc_; }

private:
  TextureDesc desc_;
  Vec3 dhat_W_;         // (3) unit
  double wave_number_;  // rad/m
  double tick_s_;
  TextureRecord record_;
};

}  // namespace fulcrum
