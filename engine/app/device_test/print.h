#pragma once
// What was found, at the terminal: a line for each part.

#include "engine/app/device_test/findings.h"

namespace fulcrum::app::device_test {

void print(const Findings& findings);

}  // namespace fulcrum::app::device_test
