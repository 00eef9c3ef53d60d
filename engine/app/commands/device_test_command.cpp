#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/interrupt.h"
#include "engine/app/cli/report_output.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/commands/commands.h"
#include "engine/app/device_test/opened.h"
#include "engine/app/device_test/parts.h"
#include "engine/app/device_test/print.h"
#include "engine/app/device_test/report.h"
#include "engine/app/prepare/capabilities.h"
#include "haptics/math/number_text.h"

namespace fulcrum::app {
namespace {

namespace dt = device_test;

struct DeviceTestOptions {
  std::string device;
  bool yes = false;
  RunOptions output;
};

// What nobody asked for is nowhere on the page: no date, so that the same test gives the same page.
report::Facts about(const DeviceTestOptions& options, const dt::TestBench& bench) {
  const dt::PushBudget& budget = bench.budget();
  return {{"device", bench.desc().name + ", by its table: " + capabilities_in_words(bench.desc())},
          {"command", "fulcrum device-test " + options.device + (options.yes ? " --yes" : "")},
          {"largest push", number_text(budget.force) + " N, " + number_text(budget.torque) + " N m"},
          {"drop-outs",
           std::to_string(bench.dropouts()) + " of more than " + number_text(1e3 * bench.patience()) +
               " ms in the whole test; the oldest sample " + number_text(1e3 * bench.largest_age()) + " ms"}};
}

dt::Part dropouts_part(const dt::TestBench& bench) {
  const int times = bench.dropouts();
  const std::string patience = number_text(1e3 * bench.patience()) + " ms";
  return {"drop-outs",
          times == 0 ? dt::Outcome::good : dt::Outcome::odd,
          times == 0 ? "No sample was late by more than " + patience + " in the whole test."
                     : std::to_string(times) + " times no sample came for more than " + patience +
                           ": use another cable or port, and see `fulcrum doctor`.",
          {{"times", static_cast<double>(times), ""}, {"oldest sample", 1e3 * bench.largest_age(), "ms"}}};
}

int device_test_command(const DeviceTestOptions& options) {
  if (!options.yes && isatty(STDIN_FILENO) == 0) {
    complain(
        "This test asks before it pushes, and there is no terminal to answer at: start it in one, or "
        "add --yes where nobody can be hurt.");
    return kError;
  }
  constexpr std::string_view files[] = {dt::kPageName, dt::kCsvName};
  Result<dt::Opened> opened = dt::open_for_test(options.device);
  if (!opened) {
    complain(opened.error().sentence);
    return kError;
  }
  const auto place = report_place("device-test", options.output, files);
  if (!place) return kError;
  catch_interrupts();
  dt::TestBench bench(*opened->open.device, dt::kTick,
                      opened->simulated ? dt::without_clock(dt::kTick) : dt::by_clock(dt::kTick),
                      &interrupted);
  const bool alone = options.yes || opened->simulated;
  const std::unique_ptr<dt::Person> person =
      alone ? std::unique_ptr<dt::Person>(std::make_unique<dt::NobodyThere>())
            : std::make_unique<dt::PersonAtTerminal>();
  dt::Findings findings = dt::walk(bench, *person);
  findings.parts.push_back(dropouts_part(bench));
  const auto folder = write_report(
      *place, {{dt::kPageName, dt::page(findings, bench.desc().name, about(options, bench)).html()},
               {dt::kCsvName, dt::csv(findings).text()}});
  if (!folder) return kError;
  if (options.output.json) {
    nlohmann::ordered_json json = dt::as_json(findings);
    json["device"] = options.device;
    json["report"] = (*folder / dt::kPageName).string();
    std::printf("%s\n", json.dump(2).c_str());
  } else {
    dt::print(findings);
    std::printf("Figures and plots lie in %s\n", bold(folder->string()).c_str());
  }
  if (bench.stopped()) return kEndedByFault;
  return interrupted() || dt::outcome_of(findings) == dt::Outcome::bad ? kNotCompleted : kCompleted;
}

}  // namespace

void add_device_test(Program& program) {
  const auto options = std::make_shared<DeviceTestOptions>();
  program.add(
      "device-test", "Try a device, axis by axis: what it senses, how it pushes, how steadily it speaks",
      [options](Arguments& arguments) {
        arguments.required({"device", "DEVICE", "Its name (fulcrum devices), or simulated:MODEL"},
                           options->device);
        arguments.flag("--yes", "Ask nobody: push without being told to, and leave out what takes a person",
                       options->yes);
        arguments.out(options->output);
        arguments.json("Print what was found as JSON", options->output.json);
      },
      [options] { return device_test_command(*options); });
}

}  // namespace fulcrum::app
