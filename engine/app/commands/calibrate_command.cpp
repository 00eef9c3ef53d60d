#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>

#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/interrupt.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/commands/commands.h"
#include "engine/app/device_test/calibrate.h"
#include "engine/app/device_test/opened.h"
#include "engine/app/device_test/print.h"
#include "engine/app/device_test/report.h"
#include "engine/files/put_file.h"
#include "engine/scenario/load.h"

namespace fulcrum::app {
namespace {

namespace dt = device_test;
namespace fs = std::filesystem;

struct CalibrateOptions {
  std::string device;
  bool yes = false;
  bool forget = false;
  bool json = false;
};

int forget(const std::string& device, const fs::path& file) {
  std::error_code fault;
  if (fs::is_directory(fs::symlink_status(file, fault))) {
    complain(file.string() + " is a folder, which no calibration is: move it away yourself.");
    return kError;
  }
  if (fs::remove(file, fault)) {
    std::printf("%s is removed: the device is as its table has it.\n", file.c_str());
    return kCompleted;
  }
  if (fault) {
    complain(file.string() + " cannot be removed: " + fault.message() +
             ". Remove it as the owner of its folder.");
    return kError;
  }
  std::printf("There is no calibration of %s.\n", device.c_str());
  return kCompleted;
}

// What was kept before. One that cannot be read, is another device's or goes beyond the table is said, and
// counts as none.
scenario::Calibration kept(const std::string& device, const DeviceDesc& table) {
  scenario::Calibration none{.device = device};
  const fs::path file = scenario::kept_calibration(device);
  if (file.empty()) return none;
  const scenario::Checked<scenario::Calibration> before = scenario::load_calibration(file);
  std::string why;
  if (!before)
    why = scenario::to_text(before.faults());
  else if (before->device != device)
    why = "it is a calibration of '" + before->device + "'";
  else if (const Result<DeviceDesc> fits = scenario::calibrated(table, *before); !fits)
    why = fits.error().sentence;
  if (why.empty()) return *before;
  complain(
      "the calibration that is there cannot be used, and what is measured now takes its place (`--forget` "
      "removes it): " +
      why);
  return none;
}

// Why nothing could be kept there, before anything is pushed; empty: it can.
std::string why_not_kept(const fs::path& file) {
  std::error_code fault;
  fs::create_directories(file.parent_path(), fault);
  const auto type = fs::symlink_status(file, fault).type();
  if (type == fs::file_type::directory) return file.string() + " is a folder: move it away.";
  if (access(file.parent_path().c_str(), W_OK | X_OK) == 0) return {};
  return file.parent_path().string() + " cannot be written: see that it is a folder, and yours.";
}

// What says nothing is no file. Whole or not at all: whoever is killed meanwhile leaves the one of before.
bool keep(const scenario::Calibration& calibration, const fs::path& file) {
  if (calibration.says_nothing()) {
    std::error_code fault;
    fs::remove(file, fault);
    if (!fault) return true;
  }
  const std::string text = calibration_text(calibration);
  if (put_file_by_part(file, {std::as_bytes(std::span(text))})) return true;
  complain(file.string() +
           " cannot be written: see that it is no folder, and that its own is yours and has room.");
  return false;
}

int calibrate_command(const CalibrateOptions& options) {
  const Result<DeviceName> name = read_device_name(options.device);
  if (!name) {
    complain(name.error().sentence);
    return kError;
  }
  if (is_simulated(options.device)) {
    complain("A simulated device is as its table has it: name one that is held (fulcrum devices).");
    return kError;
  }
  const fs::path file = scenario::calibration_file(name->moves);
  if (file.empty()) {
    complain("Neither XDG_CONFIG_HOME nor HOME names a folder for a calibration: set one of them.");
    return kError;
  }
  if (options.forget) return forget(name->moves, file);
  if (!options.yes && isatty(STDIN_FILENO) == 0) {
    complain(
        "A calibration asks before it pushes, and there is no terminal to answer at: start it in one, or "
        "add --yes where nobody can be hurt.");
    return kError;
  }
  Result<dt::Opened> opened = dt::open_for_test(options.device);
  if (!opened) {
    complain(opened.error().sentence);
    return kError;
  }
  if (const std::string why = why_not_kept(file); !why.empty()) {
    complain(why);
    return kError;
  }
  scenario::Calibration calibration = kept(name->moves, opened->open.device->desc());
  catch_interrupts();
  dt::TestBench bench(*opened->open.device, dt::kTick, dt::by_clock(dt::kTick), &interrupted);
  const std::unique_ptr<dt::Person> person =
      options.yes ? std::unique_ptr<dt::Person>(std::make_unique<dt::NobodyThere>())
                  : std::make_unique<dt::PersonAtTerminal>();
  const dt::Findings findings = dt::calibrate(bench, *person, calibration);
  const bool found = std::ranges::count(findings.parts, dt::Outcome::good, &dt::Part::outcome) > 0;
  const bool says = found && !calibration.says_nothing();
  if (found && !keep(calibration, file)) return kError;
  if (options.json) {
    nlohmann::ordered_json json = dt::as_json(findings);
    json["device"] = options.device;
    json["calibration"] = says ? nlohmann::ordered_json(file.string()) : nullptr;
    std::printf("%s\n", json.dump(2).c_str());
  } else {
    dt::print(findings);
    if (says)
      std::printf("Kept in %s, and taken with --device %s from now on.\n", bold(file.string()).c_str(),
                  name->moves.c_str());
    else
      std::printf(found ? "The device is as its table has it: there is nothing to keep.\n"
                        : "Nothing was kept.\n");
  }
  if (bench.stopped()) return kEndedByFault;
  return interrupted() || dt::outcome_of(findings) == dt::Outcome::bad ? kNotCompleted : kCompleted;
}

}  // namespace

void add_calibrate(Program& program) {
  const auto options = std::make_shared<CalibrateOptions>();
  program.add(
      "calibrate", "Measure where a device reaches, what its handle weighs, and which hand holds it",
      [options](Arguments& arguments) {
        arguments.required({"device", "DEVICE", "Its name (fulcrum devices)"}, options->device);
        arguments.flag("--yes", "Ask nobody: what takes a person stays as it was", options->yes);
        arguments.flag("--forget", "Remove what was measured before", options->forget);
        arguments.json("Print what was found as JSON", options->json);
      },
      [options] { return calibrate_command(*options); });
}

}  // namespace fulcrum::app
