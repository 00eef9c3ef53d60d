#pragma once
// From hand to pixel, for a trial's page.

#include "engine/record/hand_to_pixel.h"
#include "engine/session/trial_page.h"

namespace fulcrum::app {

session::PictureAge picture_age(const record::HandToPixel& figures);

}  // namespace fulcrum::app
