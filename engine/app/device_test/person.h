#pragma once
// Who is at the device while it is tested: is told what comes next, and asked whether it may come and whether
// it was felt.

#include <optional>
#include <string>
#include <string_view>

namespace fulcrum::app::device_test {

enum class Answer { yes, no, left, right };
// What a question can be answered with. no leaves it as it is.
enum class Choice { yes_no, hand };

class Person {
public:
  virtual ~Person() = default;
  // False: nobody moves the handle, presses a button or feels what it does.
  virtual bool there() const = 0;
  virtual void tell(std::string_view sentence) = 0;
  virtual void ask(std::string_view question, Choice choice) = 0;
  // To the newest question; none yet. Does not wait, since the device has to be looked after meanwhile.
  virtual std::optional<Answer> answer() = 0;
};

// Agrees to all that comes, and feels nothing: --yes, and a simulated device.
class NobodyThere final : public Person {
public:
  bool there() const override { return false; }
  void tell(std::string_view) override {}
  void ask(std::string_view, Choice) override {}
  std::optional<Answer> answer() override { return Answer::yes; }
};

// At the terminal: reads stdin and writes on stderr. Enter and y agree, n does not; where a hand is asked
// for, l and r say which, and Enter leaves it.
class PersonAtTerminal final : public Person {
public:
  bool there() const override { return true; }
  void tell(std::string_view sentence) override;
  // What was typed before the question is no answer to it.
  void ask(std::string_view question, Choice choice) override;
  std::optional<Answer> answer() override;

private:
  std::string typed_;
  Choice choice_ = Choice::yes_no;
};

}  // namespace fulcrum::app::device_test
