#include "engine/app/cli/terminal.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <utility>

#include "engine/files/plain_text.h"

namespace fulcrum::app {
namespace {

bool colour_wanted() {
  const char* no_color = std::getenv("NO_COLOR");
  return (no_color == nullptr || *no_color == '\0') && isatty(STDOUT_FILENO) != 0;
}

std::string styled(std::string_view code, std::string_view text) {
  static const bool wanted = colour_wanted();
  if (!wanted) return std::string(text);
  return "\033[" + std::string(code) + "m" + std::string(text) + "\033[0m";
}

std::mutex complaints_mutex;
std::optional<std::string> kept_complaints;  // none: nobody keeps them

// Line by line, without what a terminal would obey.
std::string shown_lines(std::string_view text) {
  std::string shown;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    shown += plain_text(text.substr(at, end - at));
    if (end < text.size()) shown += '\n';
    at = end + 1;
  }
  return shown;
}

}  // namespace

std::string bold(std::string_view text) {
  return styled("1", text);
}
std::string dim(std::string_view text) {
  return styled("2", text);
}
std::string green(std::string_view text) {
  return styled("32", text);
}
std::string yellow(std::string_view text) {
  return styled("33", text);
}
std::string red(std::string_view text) {
  return styled("31", text);
}

std::string in_lines(std::string_view text, std::size_t indent, std::size_t width) {
  std::string lines(indent, ' ');
  std::size_t column = indent;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(text.size(), word.size() + 1));
    const bool first = column == indent;
    if (!first && column + 1 + word.size() > width) {
      lines.append(1, '\n').append(indent, ' ').append(word);
      column = indent + word.size();
      continue;
    }
    lines.append(first ? "" : " ").append(word);
    column += word.size() + (first ? 0 : 1);
  }
  return lines;
}

void complain(std::string_view said) {
  const std::string sentence = shown_lines(said);
  std::fprintf(stderr, "fulcrum: %.*s\n", static_cast<int>(sentence.size()), sentence.data());
  const std::lock_guard lock(complaints_mutex);
  if (!kept_complaints) return;
  if (!kept_complaints->empty()) *kept_complaints += ' ';
  *kept_complaints += sentence;
}

KeptComplaints::KeptComplaints() {
  const std::lock_guard lock(complaints_mutex);
  kept_complaints.emplace();
}

KeptComplaints::~KeptComplaints() {
  const std::lock_guard lock(complaints_mutex);
  kept_complaints.reset();
}

std::string KeptComplaints::take() {
  const std::lock_guard lock(complaints_mutex);
  return std::exchange(*kept_complaints, {});
}

void ProgressBar::show(std::string_view what, double fraction) {
  const Clock::time_point now = Clock::now();
  if (what != what_) {
    clear();
    what_ = what;
    stage_began_ = now;
    told_tenths_ = 0;
  }
  if (isatty(STDERR_FILENO) == 0) {
    const int tenths = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * 10);
    if (tenths > told_tenths_ && tenths < 10 && now - stage_began_ > std::chrono::seconds(1)) {
      std::fprintf(stderr, "%s: %d %%\n", what_.c_str(), 10 * tenths);
      told_tenths_ = tenths;
    }
    return;
  }
  if (visible_ && now - drawn_ < std::chrono::milliseconds(100) && fraction < 1) return;
  constexpr int width = 30;
  const double part = std::clamp(fraction, 0.0, 1.0);
  const int full = static_cast<int>(part * width);
  std::fprintf(stderr, "\r\033[K%-28.28s [%.*s%*s] %3d %%", what_.c_str(), full,
               "##############################", width - full, "", static_cast<int>(part * 100));
  std::fflush(stderr);
  drawn_ = now;
  visible_ = true;
}

void ProgressBar::clear() {
  if (visible_) std::fputs("\r\033[K", stderr);
  visible_ = false;
}

}  // namespace fulcrum::app
