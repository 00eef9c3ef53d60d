#pragma once
// What a device test has found, for people and for programs.

#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "engine/app/device_test/findings.h"
#include "engine/report/csv.h"
#include "engine/report/page.h"

namespace fulcrum::app::device_test {

inline constexpr std::string_view kPageName = "device-test.html", kCsvName = "device-test.csv";

// The worst of its parts; what is unknown counts for nothing.
Outcome outcome_of(const Findings& findings);

// about: of the device and of the test.
report::Page page(const Findings& findings, std::string_view device, const report::Facts& about);
// part, outcome, measure, value, unit; a part without a measure has a row, too.
report::Csv csv(const Findings& findings);
nlohmann::ordered_json as_json(const Findings& findings);

}  // namespace fulcrum::app::device_test
