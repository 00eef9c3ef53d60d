#pragma once
// What a person in a terminal sees: colour where it helps, progress where it takes long.

#include <chrono>
#include <string>
#include <string_view>

namespace fulcrum::app {

// Text for stdout in bold, grey or a colour; plain when stdout is no terminal or NO_COLOR is set.
std::string bold(std::string_view text);
std::string dim(std::string_view text);
std::string green(std::string_view text);
std::string yellow(std::string_view text);
std::string red(std::string_view text);

// The text in lines of at most `width` letters, each `indent` spaces in. A longer word has a line of its own.
std::string in_lines(std::string_view text, std::size_t indent, std::size_t width = 100);

// "fulcrum: sentence" on stderr.
void complain(std::string_view sentence);

// While one is there, complaints are kept as well, for a window to show. From any thread; one at a time.
class KeptComplaints {
public:
  KeptComplaints();
  ~KeptComplaints();
  KeptComplaints(const KeptComplaints&) = delete;
  KeptComplaints& operator=(const KeptComplaints&) = delete;

  std::string take();  // the sentences since the last call, a space between them
};

// A bar on stderr, drawn at most ten times a second; without a terminal a line for each tenth of a stage that
// takes over a second.
class ProgressBar {
public:
  ProgressBar() = default;
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(std::string_view what, double fraction);
  void clear();  // before other lines are written

private:
  using Clock = std::chrono::steady_clock;
  std::string what_;
  Clock::time_point stage_began_, drawn_;
  bool visible_ = false;
  int told_tenths_ = 0;
};

}  // namespace fulcrum::app
