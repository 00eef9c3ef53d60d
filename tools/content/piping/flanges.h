#pragma once

#include "tools/content/mesh/solid.h"
#include "tools/content/mesh/fasteners.h"

namespace fulcrum::content {

// A weld-neck flange for one pipe diameter.
struct FlangeSize {
  double pipe_radius;  // m
  double radius;       // m
  double bolt_radius;  // m, of the circle the bolts stand on
  double thickness;    // m, of the disc
  double neck_radius;  // m, where the neck leaves the disc
  double neck_length;  // m
  double face_radius;  // m, of the raised face
  Thread thread;
  int columns;
};

inline constexpr double raised_face = 1.0 * mm;
inline constexpr double gasket_thickness = 3.0 * mm;
inline constexpr int bolts_per_flange = 4;

// Compact plant flanges.
inline constexpr FlangeSize flange_16{8.0 * mm, 26 * mm,   18.5 * mm, 8 * mm, 11.5 * mm,
                                      10 * mm,  12.5 * mm, m6,        22};
inline constexpr FlangeSize flange_21{10.65 * mm, 29 * mm,   21.5 * mm, 9 * mm, 14.5 * mm,
                                      11 * mm,    15.5 * mm, m6,        24};
inline constexpr FlangeSize flange_27{13.45 * mm, 34 * mm,   25.5 * mm, 10 * mm, 17.0 * mm,
                                      13 * mm,    18.5 * mm, m8,        26};
inline constexpr FlangeSize flange_34{16.85 * mm, 38 * mm,   29.5 * mm, 10 * mm, 21.0 * mm,
                                      14 * mm,    22.0 * mm, m8,        28};
inline constexpr FlangeSize flange_42{21.2 * mm, 45 * mm,   35.0 * mm, 11 * mm, 24.8 * mm,
                                      16 * mm,   26.0 * mm, m10,       32};
// DN 15, as EN 1092-1 has it for PN 16: its M12 nuts are what the 19 mm ring is for.
inline constexpr FlangeSize flange_dn15{10.65 * mm, 47.5 * mm, 32.5 * mm, 14 * mm, 16.0 * mm,
                                        20 * mm,    22.5 * mm, m12,       40};

// Gasket face at z = 0, neck towards -z. No bore and no bolt holes: pipe and bolts run through.
Solid weld_neck_flange(const FlangeSize& size);

// Gasket face at z = 0, back towards -z.
Solid blind_flange(const FlangeSize& size);

// From z = 0 to the gasket's thickness.
Solid gasket(const FlangeSize& size);

// Angle of bolt k about the flange's axis. Bolts straddle the centre lines, as fitters set them.
double bolt_angle(int k);

}  // namespace fulcrum::content
