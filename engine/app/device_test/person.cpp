#include "engine/app/device_test/person.h"

#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <cstdio>

namespace fulcrum::app::device_test {

void PersonAtTerminal::tell(std::string_view sentence) {
  std::fprintf(stderr, "%.*s\n", static_cast<int>(sentence.size()), sentence.data());
}

void PersonAtTerminal::ask(std::string_view question, Choice choice) {
  tcflush(STDIN_FILENO, TCIFLUSH);
  typed_.clear();
  choice_ = choice;
  const char* const keys =
      choice == Choice::hand ? "l: left, r: right, Enter: as it is" : "Enter: yes, n: no";
  std::fprintf(stderr, "%.*s [%s] ", static_cast<int>(question.size()), question.data(), keys);
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
  const bool hand = choice_ == Choice::hand;
  const char first = !typed_.empty() ? typed_.front() : hand ? 'n' : 'y';
  typed_.clear();
  if (first == 'n' || first == 'N') return Answer::no;
  if (!hand && (first == 'y' || first == 'Y')) return Answer::yes;
  if (hand && (first == 'l' || first == 'L')) return Answer::left;
  if (hand && (first == 'r' || first == 'R')) return Answer::right;
  std::fputs(hand ? "l is left, r is right, Enter leaves it as it is: " : "Enter or y is yes, n is no: ",
             stderr);
  return std::nullopt;
}

}  // namespace fulcrum::app::device_test
