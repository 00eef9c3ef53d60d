#include "tools/content/mesh/solid.h"
#include "tools/content/teeth/tooth_designs.h"

namespace fulcrum::content {

// Five cusps: mesiobuccal, distobuccal and a small distal one, mesiolingual and distolingual. The grooves
// between them make a Y: two open to buccal, one to lingual.
ToothDesign first_molar() {
  return {
      .kind = "first molar",
      .body = {.mesial = {{{-3, 4.3}, {0, 4.5}, {2, 4.95}, {4.9, 5.5}, {6.2, 5.3}, {7.5, 4.8}}},
               .distal = {{{-3, 4.3}, {0, 4.5}, {2, 5.0}, {4.5, 5.5}, {5.8, 5.2}, {7.5, 4.5}}},
               .buccal = {{{-3, 4.3}, {0, 4.5}, {1.4, 5.1}, {2.4, 5.2}, {4.5, 4.7}, {7.5, 3.3}}},
               .lingual = {{{-3, 4.3}, {0, 4.5}, {2, 5.05}, {3.8, 5.3}, {5.5, 5.1}, {7.5, 4.3}}},
               .roundness = {{{-1, 2.5}, {2, 2.8}, {5, 3.0}, {7, 2.8}}},
               .taper = 0.03,
               .buccal_grooves = {{.x = 0.85, .width = 0.42, .depth = 0.5, .from = 2.2, .to = 5.0},
                                  {.x = -2.95, .width = 0.38, .depth = 0.4, .from = 2.4, .to = 5.0},
                                  {.x = -5.0, .width = 1.3, .depth = 1.3, .from = -1.0, .to = 4.0}},
               .lingual_grooves = {{.x = 0.1, .width = 0.42, .depth = 0.45, .from = 2.5, .to = 5.3}}},
      .relief = {.cusps = {{.tip = {2.75, 2.75, 7.2},
                            .inward = -102 * degree,
                            .ridge = 0.5,
                            .flank = 0.92,
                            .crest = 0.42,
                            .outer = 1.05,
                            .blunt = 0.5,
                            .wrinkles = 0.17},
                           {.tip = {-1.15, 2.85, 6.95},
                            .inward = -86 * degree,
                            .ridge = 0.5,
                            .flank = 0.92,
                            .crest = 0.45,
                            .outer = 1.05,
                            .blunt = 0.5,
                            .wrinkles = 0.17},
                           {.tip = {-4.05, 1.35, 6.3},
                            .inward = -22 * degree,
                            .ridge = 0.42,
                            .flank = 0.75,
                            .crest = 0.5,
                            .outer = 0.9,
                            .blunt = 0.6},
                           {.tip = {2.55, -2.95, 7.5},
                            .inward = 102 * degree,
                            .ridge = 0.55,
                            .flank = 0.97,
                            .crest = 0.45,
                            .outer = 1.3,
                            .blunt = 0.4,
                            .wrinkles = 0.17},
                           {.tip = {-2.3, -3.0, 7.25},
                            .inward = 80 * degree,
                            .ridge = 0.55,
                            .flank = 0.97,
                            .crest = 0.45,
                            .outer = 1.3,
                            .blunt = 0.4,
                            .wrinkles = 0.17}},
                 .ridges = {{.from = {4.35, 1.9, 6.4},
                             .to = {4.3, -2.1, 6.5},
                             .sag = 0.35,
                             .slope_left = 0.7,
                             .slope_right = 0.9},
                            {.from = {-4.75, 0.5, 6.0},
                             .to = {-4.2, -2.1, 6.2},
                             .sag = 0.2,
                             .slope_left = 0.9,
                             .slope_right = 0.7}},
                 .fissure_depth = 0.5,
                 .fissure_width = 0.3,
                 .fissure_reach = {3.9, 3.3},
                 .waviness = 0.16},
      .edge = 1.1,
      .cell = 0.19,
      .contact = 0.65,
      .cervical_bow = 1.0,
  };
}

// Four cusps and a cross between them.
ToothDesign second_molar() {
  return {
      .kind = "second molar",
      .body = {.mesial = {{{-3, 3.8}, {0, 4.0}, {2, 4.7}, {4.5, 5.25}, {5.8, 5.1}, {7, 4.6}}},
               .distal = {{{-3, 3.8}, {0, 4.0}, {2, 4.7}, {4.2, 5.25}, {5.5, 5.0}, {7, 4.3}}},
               .buccal = {{{-3, 4.3}, {0, 4.5}, {1.4, 4.95}, {2.3, 5.0}, {4.2, 4.5}, {7, 3.2}}},
               .lingual = {{{-3, 4.3}, {0, 4.45}, {2, 4.85}, {3.6, 5.0}, {5.2, 4.8}, {7, 4.1}}},
               .roundness = {{{-1, 2.5}, {2, 2.8}, {5, 3.0}, {7, 2.8}}},
               .taper = 0.03,
               .buccal_grooves = {{.x = 0.1, .width = 0.45, .depth = 0.5, .from = 2.0, .to = 4.7}},
               .lingual_grooves = {{.x = -0.1, .width = 0.42, .depth = 0.42, .from = 2.3, .to = 5.0}}},
      .relief = {.cusps = {{.tip = {2.45, 2.6, 6.8},
                            .inward = -104 * degree,
                            .ridge = 0.48,
                            .flank = 0.92,
                            .crest = 0.42,
                            .outer = 1.05,
                            .blunt = 0.5,
                            .wrinkles = 0.17},
                           {.tip = {-2.3, 2.6, 6.6},
                            .inward = -76 * degree,
                            .ridge = 0.48,
                            .flank = 0.92,
                            .crest = 0.45,
                            .outer = 1.05,
                            .blunt = 0.5,
                            .wrinkles = 0.17},
                           {.tip = {2.35, -2.8, 7.0},
                            .inward = 104 * degree,
                            .ridge = 0.52,
                            .flank = 0.97,
                            .crest = 0.45,
                            .outer = 1.3,
                            .blunt = 0.4,
                            .wrinkles = 0.17},
                           {.tip = {-2.3, -2.75, 6.75},
                            .inward = 76 * degree,
                            .ridge = 0.52,
                            .flank = 0.97,
                            .crest = 0.45,
                            .outer = 1.3,
                            .blunt = 0.4,
                            .wrinkles = 0.17}},
                 .ridges = {{.from = {4.15, 1.9, 6.0},
                             .to = {4.1, -2.0, 6.1},
                             .sag = 0.35,
                             .slope_left = 0.7,
                             .slope_right = 0.9},
                            {.from = {-4.15, 1.7, 5.75},
                             .to = {-4.0, -2.0, 5.8},
                             .sag = 0.3,
                             .slope_left = 0.9,
                             .slope_right = 0.7}},
                 .fissure_depth = 0.52,
                 .fissure_width = 0.24,
                 .fissure_reach = {3.5, 3.1},
                 .waviness = 0.16},
      .edge = 1.1,
      .cell = 0.19,
      .contact = 0.65,
      .cervical_bow = 1.0,
  };
}

ToothDesign tooth_design(int place) {
  switch (place) {
    case 1:
      return central_incisor();
    case 2:
      return lateral_incisor();
    case 3:
      return canine();
    case 4:
      return first_premolar();
    case 5:
      return second_premolar();
    case 6:
      return first_molar();
    default:
      return second_molar();
  }
}

}  // namespace fulcrum::content
