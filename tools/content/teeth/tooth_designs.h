#pragma once

#include "tools/content/teeth/tooth.h"

namespace fulcrum::content {

ToothDesign central_incisor();
ToothDesign lateral_incisor();
ToothDesign canine();
ToothDesign first_premolar();
ToothDesign second_premolar();
ToothDesign first_molar();
ToothDesign second_molar();

// By place from the middle of the jaw, 1 to 7, as the second digit of a tooth's number.
ToothDesign tooth_design(int place);

}  // namespace fulcrum::content
