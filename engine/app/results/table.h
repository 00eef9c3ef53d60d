#pragma once
// Results as a terminal, a spreadsheet and a program take them.

#include <string>
#include <vector>

#include "engine/report/page.h"
#include "engine/session/store.h"

namespace fulcrum::app {

report::Table results_table(const std::vector<session::StoredTrial>& trials);
// A line for each trial, a column for each figure; what is not known is left empty.
std::string results_csv(const std::vector<session::StoredTrial>& trials);
std::string results_json(const std::vector<session::StoredTrial>& trials);

}  // namespace fulcrum::app
