#pragma once
// What a run that goes on shows of itself: the newest whole line of its trace.csv, as it is written.

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "haptics/math/pose.h"

namespace fulcrum::test {

struct TraceRow {
  double time = 0;  // s, of the run
  Pose X_WH;
  int task_step = 0;
};

class TraceTail {
public:
  explicit TraceTail(std::filesystem::path file) : path_(std::move(file)) {}

  // None: nothing has come since it was asked last.
  std::optional<TraceRow> newest();

private:
  std::filesystem::path path_;
  std::ifstream file_;
  std::string rest_;  // of a line that is not whole
  std::vector<std::size_t> columns_;
};

}  // namespace fulcrum::test
