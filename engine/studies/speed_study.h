#pragma once
// `fulcrum workprecision speed`: how long a picture takes at each quality level and size.

#include "engine/studies/picture_study.h"

namespace fulcrum::app {

// The program's exit code. options: those that are not of references.
int speed_study(const PictureStudyOptions& options);

}  // namespace fulcrum::app
