#pragma once
// Colours of the overlay that tell nothing apart (palette.h has those that do), and sizes. Lengths are in
// units of 1/720 of a 720-pixel picture, scaled by Canvas.

#include <imgui.h>

namespace fulcrum::ui::theme {

constexpr ImU32 kCard = IM_COL32(15, 18, 23, 205);
constexpr ImU32 kModal = IM_COL32(12, 15, 19, 236);  // of a card in the middle, over what moves
constexpr ImU32 kCardEdge = IM_COL32(255, 255, 255, 22);
constexpr ImU32 kText = IM_COL32(236, 240, 245, 255);
constexpr ImU32 kSecondary = IM_COL32(158, 169, 182, 255);
constexpr ImU32 kFaint = IM_COL32(126, 136, 148, 255);
constexpr ImU32 kTrack = IM_COL32(255, 255, 255, 26);
constexpr ImU32 kButton = IM_COL32(60, 68, 78, 255);
constexpr ImU32 kDepth = IM_COL32(226, 130, 255, 255);  // along the line of sight

constexpr float kMargin = 18.0F;
constexpr float kPadding = 14.0F;
constexpr float kRounding = 8.0F;

}  // namespace fulcrum::ui::theme
