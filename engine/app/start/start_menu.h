#pragma once
// What a person chooses on the start page, as plain state: keys, letters, presses and a gamepad's buttons go
// in, the page and a wish come out.

#include <optional>
#include <string>
#include <vector>

#include "engine/ui/start_page.h"

namespace fulcrum::app {

struct StartScenario {
  std::string name;   // as `fulcrum run` takes it
  std::string title;  // as it is shown
  std::string about, facts;
  std::string fault{};           // why it cannot be used; empty: it can
  std::optional<double> best{};  // 0 to 100, of the participant
};

// In place of a device: the simulated one, in the expert's hand.
inline constexpr const char* kShown = "shown";

struct StartDevice {
  std::string name;   // as --device takes it, or kShown
  std::string label;  // as it is shown
};

// What is remembered from one start to the next.
struct StartChoice {
  std::string participant;  // empty: nobody, and nothing is kept
  std::string device;       // of StartDevice
  bool left_handed = false;
  std::string scenario;
};

class StartMenu {
public:
  // devices: not empty, the best one first. A choice that is not there any more becomes the first that is.
  StartMenu(std::vector<StartScenario> scenarios, std::vector<StartDevice> devices,
            std::vector<std::string> participants, const StartChoice& choice);

  enum class Key { up, down, left, right, accept, back, erase };
  enum class Wish { none, start, settings, end, test };  // test: the device that is chosen

  Wish press(Key key);
  void type(char32_t letter);  // of a name that is being written
  Wish click(const ui::StartHit& hit);

  // Of the participant who is chosen now, in the order of the scenarios.
  void set_bests(const std::vector<std::optional<double>>& bests);
  // A sentence that stands there until something is chosen.
  void set_note(std::string note) { note_ = std::move(note); }

  StartChoice choice() const;
  ui::StartPage page() const;

private:
  enum Setting : std::size_t { who, device, hand, settings };  // settings: how many there are

  void move(int by);
  void change(std::size_t setting, int by);
  Wish accept();
  Wish accept_device();
  bool finish_name();  // false: it is refused, and still being written

  std::vector<StartScenario> scenarios_;
  std::vector<StartDevice> devices_;
  std::vector<std::string> participants_;  // the first is nobody, the last a name that is new
  std::size_t scenario_ = 0, participant_ = 0, device_ = 0;
  bool left_handed_ = false;
  ui::StartPage::Part focus_ = ui::StartPage::Part::scenario;
  std::size_t setting_ = 0;
  std::optional<std::string> written_;  // the name so far, while one is written
  std::string note_;
};

}  // namespace fulcrum::app
