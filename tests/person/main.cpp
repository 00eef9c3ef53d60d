// fulcrum_person SCENE WINDOW [PAD]: carries the task out that `fulcrum run SCENE` shows in that window, by
// mouse and keys alone, or by the gamepad that the stand-in plays from the FIFO PAD. It sees the window's
// pixels and nothing else. Exit codes: 0 it did what the picture asked for, 1 it gave up, 2 wrong command
// line. Its last words are how many pictures a second it was shown.

#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/person/plans.h"
#include "tests/person/practise.h"
#include "tests/person/practise_by_pad.h"

int main(int argc, char** argv) {
  using namespace fulcrum::person;
  const Plan* plan = argc == 3 || argc == 4 ? find_plan(argv[1]) : nullptr;
  if (plan == nullptr) {
    std::fprintf(stderr,
                 "usage: fulcrum_person SCENE WINDOW [PAD], with a scene that it knows how to go about\n");
    return 2;
  }
  try {
    WindowLink window(std::strtoul(argv[2], nullptr, 0));
    Trainee trainee(window);
    std::string gave_up;
    try {
      if (argc == 4) {
        Pad pad(argv[3]);
        practise_by_pad(trainee, pad, plan->legs.size());
      } else {
        practise(trainee, *plan);
      }
    } catch (const GaveUp& why) {
      gave_up = why.what();
    }
    std::printf("%.1f pictures a second\n", trainee.frames_per_second());
    if (!gave_up.empty()) std::printf("gave up: %s\n", gave_up.c_str());
    return gave_up.empty() ? 0 : 1;
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
    return 1;
  }
}
