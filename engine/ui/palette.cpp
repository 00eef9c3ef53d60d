#include "engine/ui/palette.h"

namespace fulcrum::ui {
namespace {

const Palette kStandard{
    .accent = IM_COL32(84, 164, 255, 255),
    .good = IM_COL32(66, 206, 138, 255),
    .warn = IM_COL32(255, 178, 54, 255),
    .bad = IM_COL32(255, 92, 88, 255),
    .stop = IM_COL32(196, 30, 36, 240),
    .stop_edge = IM_COL32(255, 190, 186, 255),
    .lead = IM_COL32(38, 104, 190, 255),
    .markers = {},
};

// Blue against yellow and orange, and light against dark among those: the axes that all three see.
const Palette kColourBlind{
    .accent = IM_COL32(64, 150, 255, 255),
    .good = IM_COL32(206, 226, 255, 255),
    .warn = IM_COL32(255, 221, 84, 255),
    .bad = IM_COL32(222, 84, 6, 255),
    .stop = IM_COL32(170, 66, 0, 240),
    .stop_edge = IM_COL32(255, 221, 84, 255),
    .lead = IM_COL32(20, 92, 200, 255),
    .markers = {.next = {0.02F, 0.22F, 0.85F},
                .dwelling = {0.72F, 0.36F, 0.01F},
                .done = {0.52F, 0.60F, 0.72F},
                .avoid = {0.50F, 0.14F, 0.0F}},
};

}  // namespace

const Palette& palette(PaletteName name) {
  return name == PaletteName::colour_blind ? kColourBlind : kStandard;
}

const render::MarkerColours& marker_colours(const Look& look) {
  return palette(look.palette).markers;
}

}  // namespace fulcrum::ui
