#pragma once
// A scenario that is made ready anew, beside the one that runs, whenever one of its files is saved.

#include <atomic>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/edit/file_watch.h"
#include "engine/app/prepare/prepare.h"

namespace fulcrum::app {

class Reloader {
public:
  // file: the scenario's. shown: what was read of it for the scene that runs; a save since then is noticed,
  // as all that follow are.
  Reloader(std::filesystem::path file, const scenario::Scenario& shown,
           std::filesystem::path calibration = {});
  ~Reloader();  // a bake that is under way ends at its next report
  Reloader(const Reloader&) = delete;
  Reloader& operator=(const Reloader&) = delete;

  // What the models' files name themselves is watched as well: buffers, and the pictures that are laid onto
  // them.
  void watch_beside(const Prepared& shown);

  // To be called a few times a second, by one thread.
  void look();

  // The newest save is good, and waits to be taken.
  bool is_ready() const { return ready_ != nullptr; }
  std::unique_ptr<Prepared> take() { return std::move(ready_); }

  // What is wrong with the newest save that has been read, a sentence a line; empty: nothing.
  const std::string& wrong() const { return wrong_; }
  // What the newest save is: being made ready, or what is wrong with it, a sentence a line with file, line
  // and column. Empty: nothing of the two.
  std::string message() const;

private:
  struct Made {
    std::unique_ptr<Prepared> prepared;  // null: `said` has why
    std::string said;
    std::vector<std::filesystem::path> files;  // that the scenario names
  };
  Made make() const;

  std::filesystem::path file_;
  std::vector<std::string> overrides_;
  std::filesystem::path calibration_;
  FileWatch watch_;
  std::atomic<bool> ends_ = false;
  std::future<Made> making_;  // waited for before what it reads is gone
  bool saved_again_ = false;  // since `making_` began
  std::unique_ptr<Prepared> ready_;
  std::string wrong_;
};

// The tool goes on where it is, as far as that is free in the new scene: true. Otherwise it begins where that
// says.
bool begin_at(Prepared& prepared, const Pose& X_WM);

}  // namespace fulcrum::app
