#pragma once

#include "engine/session/statement.h"

namespace fulcrum::test {

inline session::Statement example_statement() {
  return {.uuid = "6f1c2a34-9d5e-4b0a-8c11-0123456789ab",
          .participant = "heron",
          .session_uuid = "00112233-4455-4677-8899-aabbccddeeff",
          .scenario = "piping",
          .scenario_title = "A nut behind a pipe",
          .ended_utc = "2026-03-04T05:06:07.089Z",
          .duration_s = 83.456,
          .completed = true,
          .score = 87.5,
          .metrics = {{"peak_force_N", 4.5}},
          .program_version = "0.1.0",
          .device = "omega",
          .left_handed = true};
}

}  // namespace fulcrum::test
