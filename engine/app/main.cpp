#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/cli/version.h"
#include "engine/app/commands/commands.h"
#include "engine/scenario/words.h"

namespace fulcrum::app {
namespace {

// "WxH", each 16 to 16384 pixels.
std::string read_size(const std::string& text, render::Extent& size) {
  unsigned width = 0, height = 0;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%ux%u%c", &width, &height, &rest) != 2 || width < 16 || height < 16 ||
      width > 16384 || height > 16384)
    return "'" + text + "' is no size: give WIDTHxHEIGHT in pixels, such as 1280x720, each from 16 to 16384";
  size = {width, height};
  return {};
}

void add_out(CLI::App* command, RunOptions& options) {
  command
      ->add_option("--out", options.out,
                   "Folder for the results (default: a new one under the data directory)")
      ->type_name("DIR");
  command->add_flag("--force", options.force, "Replace the results that lie in that folder");
}

void add_set(CLI::App* command, std::vector<std::string>& overrides) {
  command->add_option("--set", overrides, "Replace a value of the scenario, such as contact.stiffness=10000")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

CLI::App* add_run(CLI::App& program, RunOptions& options, std::string& size) {
  CLI::App* run = program.add_subcommand("run", "Run a scenario, in a window or headless");
  run->add_option("scenario", options.scenario, "Its name (fulcrum list) or file")
      ->required()
      ->type_name("NAME|FILE");
  run->add_flag("--headless", options.headless, "No window: as fast as it goes, one picture at the end");
  run->add_option("--hand", options.hand,
                  "The simulated hand: expert, clumsy, still, or another of the scenario's")
      ->type_name("HAND");
  run->add_option("--device", options.device,
                  "simulated, simulated:MODEL, mouse or replay:FILE (fulcrum devices)")
      ->type_name("DEVICE");
  run->add_flag("--realtime", options.realtime, "Headless, but by the clock, in the haptic thread");
  run->add_option("--seconds", options.seconds, "End after this much simulated time")
      ->type_name("S")
      ->check(CLI::PositiveNumber);
  run->add_option_function<std::int64_t>(
         "--seed",
         [&options](std::int64_t seed) { options.overrides.push_back("seed=" + std::to_string(seed)); },
         "Seed of what is random, such as the hand's tremor")
      ->type_name("N");
  add_set(run, options.overrides);
  run->add_option("--size", size, "Of the picture or the window, in pixels (default 1280x720)")
      ->type_name("WxH")
      ->check([&options](const std::string& text) { return read_size(text, options.size); });
  run->add_option("--view", options.view,
                  "The view of the picture, and where the window starts (default: the scenario's first)")
      ->type_name("NAME");
  run->add_flag(
      "--circle", options.circle,
      "After an impact, show where else on a tool it would have turned the hand about the same axis");
  run->add_option("--gpu", options.gpu, "Which GPU draws: its number, a part of its name, or 'list'")
      ->type_name("GPU");
  run->add_flag("--validate", options.validate,
                "Draw under Vulkan's validation layers: slow; what they say is an error");
  add_out(run, options);
  run->add_flag("--json", options.json, "Print the summary as JSON");
  return run;
}

CLI::App* add_compare(CLI::App& program, CompareOptions& options, std::string& variants) {
  CLI::App* compare = program.add_subcommand(
      "compare", "Variants of torque substitution over the same trials: torque, force and time");
  compare->add_option("scenario", options.run.scenario, "Its name (fulcrum list) or file")
      ->required()
      ->type_name("NAME|FILE");
  compare
      ->add_option("--variants", variants,
                   "Of A (no cue), B (vibration), C (vibration and ghost); default A,B,C")
      ->type_name("A,B,C")
      ->check([&options](const std::string& text) { return read_variants(text, options.variants); });
  CLI::Option* hand = compare
                          ->add_option("--hand", options.hand,
                                       "The simulated hand (default: yielding, where the scenario has it)")
                          ->type_name("HAND");
  CLI::Option* trials = compare->add_option("--trials", options.trials, "Of each variant (default 20)")
                            ->type_name("N")
                            ->check(CLI::Range(1, 10000));
  compare
      ->add_option("--tape", options.tape,
                   "A recorded motion, tape or trace.csv, instead of the hand: one trial")
      ->type_name("FILE")
      ->excludes(hand)
      ->excludes(trials);
  add_set(compare, options.run.overrides);
  add_out(compare, options.run);
  compare->add_flag("--json", options.run.json, "Print compare.json");
  return compare;
}

CLI::App* add_hardness(CLI::App& program, HardnessOptions& options) {
  CLI::App* hardness = program.add_subcommand(
      "hardness", "Where on a device a moment makes a surface feel harder, and where it cannot");
  hardness->add_option("--device", options.device, "A file of content/devices, by name (default: w6d)")
      ->type_name("NAME");
  hardness->add_option("--speed", options.speed, "Of the hand towards the surface, in m/s (default 0.15)")
      ->type_name("V")
      ->check(CLI::Range(1e-3, 10.0));
  hardness
      ->add_option("--motor-limit", options.motor_limit,
                   "Of every motor of the device's arms, in N m (default: as its file says)")
      ->type_name("LIMIT")
      ->check(CLI::Range(1e-3, 1e3));
  add_out(hardness, options.run);
  hardness->add_flag("--json", options.run.json, "Print hardness.json");
  return hardness;
}

// What is wrong with the word that should be a subcommand; nothing, where it is one or an option.
std::optional<std::string> refuse_subcommand(const CLI::App& program, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return std::nullopt;
  const std::string word = argv[1];
  std::vector<std::string> names;
  for (const CLI::App* subcommand : program.get_subcommands({})) names.push_back(subcommand->get_name());
  if (std::ranges::find(names, word) != names.end()) return std::nullopt;
  const std::vector<std::string_view> known(names.begin(), names.end());
  return "there is no subcommand " + scenario::in_quotes(word) +
         scenario::did_you_mean(word, known, "`fulcrum --help` lists them");
}

// What is wrong with the first option that the parser has left over; nothing, where it was no option.
std::optional<std::string> refuse_option(const CLI::App& program) {
  const std::vector<CLI::App*> chosen = program.get_subcommands();
  const CLI::App& command = chosen.empty() ? program : *chosen.front();
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  const std::vector<std::string_view> known(names.begin(), names.end());
  const std::string called = chosen.empty() ? "fulcrum" : "fulcrum " + command.get_name();
  for (const std::string& left : program.remaining(true)) {
    if (!left.starts_with("-")) continue;
    const std::string name = left.substr(0, left.find('='));
    return "`" + called + "` has no option " + scenario::in_quotes(name) +
           scenario::did_you_mean(name, known, "`" + called + " --help` lists them");
  }
  return std::nullopt;
}

int dispatch(int argc, char** argv) {
  CLI::App program("Fulcrum, a haptic training simulator.", "fulcrum");
  program.set_version_flag("--version", std::string("fulcrum ") + kVersion);
  program.require_subcommand(1);
  bool json = false;
  RunOptions options;
  CompareOptions compare_options;
  HardnessOptions hardness_options;
  std::string size, variants, tape, scenario, schema_of = "scenario", presses, strip_device = "freedom6s";
  std::vector<std::string> files;

  CLI::App* list = program.add_subcommand("list", "The scenarios, a line each");
  list->add_flag("--json", json, "As JSON");
  CLI::App* run = add_run(program, options, size);
  CLI::App* replay = program.add_subcommand("replay", "Repeat a run from its tape and compare every tick");
  replay->add_option("tape", tape, "The tape of a run")->required()->type_name("TAPE");
  add_out(replay, options);
  CLI::App* check = program.add_subcommand("check", "Say what is wrong with scenarios");
  check->add_option("files", files, "Scenario files or names")->required()->type_name("FILE");
  check->add_flag("--json", json, "As JSON");
  CLI::App* explain =
      program.add_subcommand("explain", "What a scenario builds, what that costs, what it leaves out");
  explain->add_option("scenario", scenario, "Its name or file")->required()->type_name("NAME|FILE");
  add_set(explain, options.overrides);
  explain->add_flag("--json", json, "As JSON");
  CLI::App* devices = program.add_subcommand("devices", "Which devices are there, and why others are not");
  devices->add_flag("--json", json, "As JSON");
  CLI::App* compare = add_compare(program, compare_options, variants);
  CLI::App* ambiguity = program.add_subcommand(
      "ambiguity", "Which impacts on the tool feel alike, and where to hold it instead");
  ambiguity->add_option("scenario", options.scenario, "Its name or file")->required()->type_name("NAME|FILE");
  add_set(ambiguity, options.overrides);
  add_out(ambiguity, options);
  CLI::App* hardness = add_hardness(program, hardness_options);
  CLI::App* stability =
      program.add_subcommand("stability", "How stiff a wall each device can hold: simulated, and by theory");
  add_out(stability, options);
  stability->add_flag("--json", options.json, "Print the figures as JSON");
  CLI::App* workprecision = program.add_subcommand(
      "workprecision", "What each choice costs, and how far from a known truth it leaves the answer");
  add_out(workprecision, options);
  workprecision->add_flag("--json", options.json, "Print the figures as JSON");
  CLI::App* strip = program.add_subcommand(
      "strip", "Calibrate a device's strip: the ends of it from presses at known places");
  strip->add_option("presses", presses, "A line for each: its place in m along the stick, and ohm")
      ->required()
      ->type_name("FILE");
  strip->add_option("--device", strip_device, "A file of content/devices, by name (default: freedom6s)")
      ->type_name("NAME");
  CLI::App* uniformity = program.add_subcommand(
      "uniformity",
      "Whether a ball feels alike along a whole stick, though the device has a mass at one end");
  add_out(uniformity, options);
  CLI::App* schema = program.add_subcommand("schema", "The JSON Schema of a file, for an editor");
  schema->add_option("of", schema_of, "scenario (default), hand, device or material")
      ->check(CLI::IsMember({"scenario", "hand", "device", "material"}));

  if (argc < 2) {
    std::fputs(program.help().c_str(), stdout);
    return kUsage;
  }
  if (const auto refused = refuse_subcommand(program, argc, argv)) {
    complain(*refused);
    return kUsage;
  }
  try {
    program.parse(argc, argv);
  } catch (const CLI::ExtrasError& error) {
    const auto refused = refuse_option(program);
    complain(refused ? *refused : error.what());
    return kUsage;
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? kCompleted : kUsage;
  }
  if (*list) return list_command(json);
  if (*run) return run_command(options);
  if (*replay) return replay_command(tape, options);
  if (*check) return check_command(files, json);
  if (*explain) return explain_command(scenario, options.overrides, json);
  if (*devices) return devices_command(json);
  if (*compare) return compare_command(compare_options);
  if (*ambiguity) return ambiguity_command(options);
  if (*hardness) return hardness_command(hardness_options);
  if (*stability) return stability_command(options);
  if (*strip) return strip_command(strip_device, presses);
  if (*uniformity) return uniformity_command(options);
  if (*workprecision) return workprecision_command(options);
  return schema_command(schema_of);
}

}  // namespace
}  // namespace fulcrum::app

int main(int argc, char** argv) {
  // A file that may not grow becomes an error that is said, not the end of the program.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return fulcrum::app::dispatch(argc, argv);
  } catch (const std::exception& error) {
    fulcrum::app::complain(std::string("this should not have happened: ") + error.what());
    return fulcrum::app::kError;
  }
}
