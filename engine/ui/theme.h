#pragma once
// Colours and sizes of the overlay. Lengths are in units of 1/720 of a 720-pixel picture, scaled by Canvas.

#include <imgui.h>

namespace fulcrum::ui::theme {

constexpr ImU32 kCard = IM_COL32(15, 18, 23, 205);
constexpr ImU32 kCardEdge = IM_COL32(255, 255, 255, 22);
constexpr ImU32 kText = IM_COL32(236, 240, 245, 255);
constexpr ImU32 kSecondary = IM_COL32(158, 169, 182, 255);
constexpr ImU32 kFaint = IM_COL32(108, 118, 130, 255);
constexpr ImU32 kTrack = IM_COL32(255, 255, 255, 26);
constexpr ImU32 kAccent = IM_COL32(84, 164, 255, 255);
constexpr ImU32 kGood = IM_COL32(66, 206, 138, 255);
constexpr ImU32 kWarn = IM_COL32(255, 178, 54, 255);
constexpr ImU32 kBad = IM_COL32(255, 92, 88, 255);
constexpr ImU32 kStop = IM_COL32(196, 30, 36, 240);
constexpr ImU32 kStopEdge = IM_COL32(255, 190, 186, 255);

constexpr float kMargin = 18.0F;
constexpr float kPadding = 14.0F;
constexpr float kRounding = 8.0F;

}  // namespace fulcrum::ui::theme
