#include "tools/content/teeth/tooth_designs.h"

namespace fulcrum::content {

// Chisels: narrow at the neck, widest at the contact near the edge; seen from the side a wedge whose edge
// lies lingual of the middle, worn to a facet that looks labially. The lateral one is wider to distal, its
// edge rounder there. Both smooth on the lingual side, with a low cingulum.

ToothDesign central_incisor() {
  return {
      .kind = "central incisor",
      .body =
          {.mesial = {{{-3, 1.6},
                       {0, 1.75},
                       {1.2, 2.07},
                       {3, 2.33},
                       {5.5, 2.46},
                       {7.9, 2.5},
                       {9, 2.42},
                       {9.6, 2.3}}},
           .distal = {{{-3, 1.6},
                       {0, 1.75},
                       {1.2, 2.07},
                       {3, 2.33},
                       {5.5, 2.46},
                       {7.7, 2.5},
                       {9, 2.36},
                       {9.6, 2.2}}},
           .buccal = {{{-3, 2.5}, {0, 2.65}, {1.3, 2.9}, {3, 2.6}, {6, 1.55}, {9, 0.45}, {9.6, 0.3}}},
           .lingual = {{{-3, 2.5}, {0, 2.65}, {1.6, 3.08}, {2.8, 2.75}, {4.5, 1.75}, {6.5, 1.25}, {9, 1.0}}},
           .roundness = {{{-1, 2.0}, {1.5, 2.1}, {5, 2.7}, {8, 3.6}}},
           .taper = 0.05,
           .buccal_grooves = {{.x = 0.75, .width = 0.38, .depth = 0.09, .from = 4.0, .to = 8.5},
                              {.x = -0.75, .width = 0.38, .depth = 0.09, .from = 4.0, .to = 8.5}},
           .lingual_grooves = {{.x = 0.0, .width = 1.1, .depth = 0.22, .from = 2.6, .to = 5.0}}},
      .relief = {.ridges = {{.from = {2.3, -0.35, 9.0},
                             .to = {-2.3, -0.35, 8.95},
                             .sag = 0.02,
                             .slope_left = 0.05,
                             .slope_right = 0.5,
                             .blunt = 0.2}}},
      .edge = 0.55,
      .cell = 0.19,
      .contact = 0.86,
      .cervical_bow = 3.0,
  };
}

ToothDesign lateral_incisor() {
  return {
      .kind = "lateral incisor",
      .body =
          {.mesial = {{{-3, 1.8},
                       {0, 2.0},
                       {1.2, 2.32},
                       {3, 2.57},
                       {5.5, 2.7},
                       {8.2, 2.75},
                       {9.5, 2.65},
                       {10, 2.5}}},
           .distal =
               {{{-3, 1.8}, {0, 2.0}, {1.2, 2.32}, {3, 2.57}, {5.5, 2.7}, {7.6, 2.75}, {9, 2.5}, {10, 2.1}}},
           .buccal = {{{-3, 2.7}, {0, 2.9}, {1.4, 3.15}, {3, 2.85}, {6.4, 1.65}, {9.5, 0.5}, {10, 0.35}}},
           .lingual = {{{-3, 2.7}, {0, 2.9}, {1.7, 3.33}, {3, 2.95}, {4.8, 1.9}, {6.8, 1.3}, {9.5, 1.0}}},
           .roundness = {{{-1, 2.0}, {1.5, 2.1}, {5, 2.6}, {8.5, 3.4}}},
           .taper = 0.05,
           .buccal_grooves = {{.x = 0.8, .width = 0.42, .depth = 0.09, .from = 4.2, .to = 9.0},
                              {.x = -0.8, .width = 0.42, .depth = 0.09, .from = 4.2, .to = 9.0}},
           .lingual_grooves = {{.x = 0.0, .width = 1.2, .depth = 0.25, .from = 2.8, .to = 5.4}}},
      .relief = {.ridges = {{.from = {2.5, -0.3, 9.55},
                             .to = {-2.5, -0.45, 9.25},
                             .sag = 0.0,
                             .slope_left = 0.05,
                             .slope_right = 0.5,
                             .blunt = 0.2}}},
      .edge = 0.6,
      .cell = 0.19,
      .contact = 0.84,
      .cervical_bow = 3.0,
  };
}

// One cusp: the mesial crest short and nearly level, the distal one longer and steeper. A labial ridge, a
// flat mesial side, a strong cingulum.
ToothDesign canine() {
  return {
      .kind = "canine",
      .body = {.mesial = {{{-3, 2.5}, {0, 2.75}, {3, 3.05}, {5.5, 3.28}, {7.7, 3.4}, {9.2, 3.2}, {11, 2.7}}},
               .distal = {{{-3, 2.5}, {0, 2.75}, {3, 3.15}, {5, 3.45}, {6.8, 3.6}, {8.4, 3.25}, {11, 2.4}}},
               .buccal = {{{-3, 3.2}, {0, 3.5}, {1.6, 3.72}, {3.5, 3.5}, {7, 2.35}, {10, 0.95}, {11.3, 0.4}}},
               .lingual = {{{-3, 3.2}, {0, 3.5}, {1.9, 3.8}, {3.4, 3.35}, {5.5, 2.3}, {8, 1.65}, {11, 1.1}}},
               .roundness = {{{-1, 2.0}, {2, 2.05}, {6, 2.2}, {9, 2.6}}},
               .taper = 0.06,
               .buccal_grooves = {{.x = 0.1, .width = 0.8, .depth = -0.22, .from = 2.0, .to = 8.0},
                                  {.x = 1.75, .width = 0.5, .depth = 0.12, .from = 4.0, .to = 9.0},
                                  {.x = -1.75, .width = 0.5, .depth = 0.12, .from = 4.0, .to = 9.0}},
               .lingual_grooves = {{.x = 1.2, .width = 0.8, .depth = 0.14, .from = 2.8, .to = 5.5},
                                   {.x = -1.2, .width = 0.8, .depth = 0.14, .from = 2.8, .to = 5.5}}},
      .relief = {.ridges = {{.from = {3.1, -0.5, 8.95},
                             .to = {0.35, -0.2, 10.93},
                             .sag = -0.15,
                             .slope_left = 0.75,
                             .slope_right = 0.5,
                             .blunt = 0.4},
                            {.from = {0.35, -0.2, 10.93},
                             .to = {-3.4, -0.6, 7.9},
                             .sag = -0.2,
                             .slope_left = 0.75,
                             .slope_right = 0.5,
                             .blunt = 0.4}},
                 .join = 0.6},
      .edge = 0.7,
      .cell = 0.2,
      .contact = 0.69,
      .cervical_bow = 2.5,
  };
}

}  // namespace fulcrum::content
