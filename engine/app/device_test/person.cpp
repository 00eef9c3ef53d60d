#include "engine/app/device_test/person.h"

#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <cstdio>

namespace fulcrum::app::device_test {

void PersonAtTerminal::tell(std::string_view sentence) {
  std::fprintf(stderr, "%.*s\n", static_cast<int>(sentence.size()), sentence.data());
}

void PersonAtTerminal::ask(std::string_view question) {
  tcflush(STDIN_FILENO, TCIFLUSH);
  typed_.clear();
  std::fprintf(stderr, "%.*s [Enter: yes, n: no] ", static_cast<int>(question.size()), question.data());
}

// A terminal that is gone agrees to nothing.
std::optional<Answer> PersonAtTerminal::answer() {
  pollfd in{STDIN_FILENO, POLLIN, 0};
  if (poll(&in, 1, 0) <= 0) return std::nullopt;
  char letter = 0;
  if (read(STDIN_FILENO, &letter, 1) != 1) return Answer::no;
  if (letter != '\n') {
    typed_ += letter;
    return std::nullopt;
  }
  const char first = typed_.empty() ? 'y' : typed_.front();
  typed_.clear();
  if (first == 'y' || first == 'Y') return Answer::yes;
  if (first == 'n' || first == 'N') return Answer::no;
  std::fprintf(stderr, "Enter or y is yes, n is no: ");
  return std::nullopt;
}

}  // namespace fulcrum::app::device_test
