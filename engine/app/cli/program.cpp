#include "engine/app/cli/program.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string_view>
#include <utility>

#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/cli/version.h"
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
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
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

// CLI11's own ranges let through what is no number: that is neither below nor above them.
std::string refuse_no_number(const std::string& given) {
  return std::isfinite(std::strtod(given.c_str(), nullptr)) ? "" : "'" + given + "' is no finite number";
}

// CLI11's own names the largest number there is. What is no number it refuses itself.
std::string refuse_no_positive(const std::string& given) {
  char* end = nullptr;
  const double number = std::strtod(given.c_str(), &end);
  const bool is_number = end != given.c_str() && *end == '\0';
  return number > 0 || !is_number ? "" : "'" + given + "' has to be above 0";
}

std::string refuse_no_count(const std::string& given) {
  return given.starts_with('-') ? "'" + given + "' has to be a whole number, 0 or above" : "";
}

}  // namespace

void Arguments::required(const Argument& argument, std::string& value) {
  command_.add_option(argument.name, value, argument.help)->required()->type_name(argument.type);
}

void Arguments::required(const Argument& argument, std::vector<std::string>& values) {
  command_.add_option(argument.name, values, argument.help)->required()->type_name(argument.type);
}

void Arguments::choice(const char* name, const char* help, std::string& value,
                       std::vector<std::string> choices) {
  command_.add_option(name, value, help)->check(CLI::IsMember(std::move(choices)));
}

void Arguments::flag(const char* name, const char* help, bool& value) {
  command_.add_flag(name, value, help);
}

CLI::Option* Arguments::text(const Argument& argument, std::string& value) {
  return command_.add_option(argument.name, value, argument.help)
      ->type_name(argument.type)
      ->check([](const std::string& given) {
        return given.empty() ? "it is empty: give it, or leave the option out" : "";
      });
}

CLI::Option* Arguments::count(const Argument& argument, std::uint64_t& value, std::uint64_t least,
                              std::uint64_t most) {
  return command_.add_option(argument.name, value, argument.help)
      ->type_name(argument.type)
      ->check(CLI::Range(least, most));
}

void Arguments::number(const Argument& argument, double& value, double least, double most) {
  command_.add_option(argument.name, value, argument.help)
      ->type_name(argument.type)
      ->check(refuse_no_number)
      ->check(CLI::Range(least, most));
}

void Arguments::number(const Argument& argument, std::optional<double>& value, double least, double most) {
  command_.add_option(argument.name, value, argument.help)
      ->type_name(argument.type)
      ->check(refuse_no_number)
      ->check(CLI::Range(least, most));
}

void Arguments::positive(const Argument& argument, std::optional<double>& value) {
  command_.add_option(argument.name, value, argument.help)
      ->type_name(argument.type)
      ->check(refuse_no_number)
      ->check(CLI::Validator(refuse_no_positive, "ABOVE 0"));
}

void Arguments::count(const Argument& argument, const std::function<void(std::int64_t)>& take) {
  command_.add_option_function<std::int64_t>(argument.name, take, argument.help)
      ->type_name(argument.type)
      ->check(refuse_no_count);
}

void Arguments::text(const Argument& argument, const std::function<std::string(const std::string&)>& read) {
  command_
      .add_option_function<std::string>(
          argument.name, [](const std::string&) {}, argument.help)
      ->type_name(argument.type)
      ->check(read);
}

void Arguments::texts(const Argument& argument, const std::function<std::string(const std::string&)>& read) {
  command_
      .add_option_function<std::vector<std::string>>(
          argument.name, [](const std::vector<std::string>&) {}, argument.help)
      ->type_name(argument.type)
      ->allow_extra_args(false)
      ->check(read);
}

void Arguments::exclude(CLI::Option* one, CLI::Option* other) {
  one->excludes(other);
}

void Arguments::out(RunOptions& options) {
  command_
      .add_option("--out", options.out,
                  "Folder for the results (default: a new one under the data directory)")
      ->type_name("DIR");
  flag("--force", "Replace the results that lie in that folder", options.force);
}

void Arguments::overrides(std::vector<std::string>& overrides) {
  command_.add_option("--set", overrides, "Replace a value of the scenario, such as contact.stiffness=10000")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void Arguments::size(render::Extent& size) {
  text(
      {"--size", "WxH", "Of the picture or the window, in pixels (default 1280x720)"},
      [&size](const std::string& text) { return read_size(text, size); });
}

void Arguments::json(const char* help, bool& json) {
  flag("--json", help, json);
}

Program::Program(const char* about) : app_(std::make_unique<CLI::App>(about, "fulcrum")) {
  app_->set_version_flag("--version", std::string("fulcrum ") + kVersion);
  app_->require_subcommand(1);
}

Program::~Program() = default;

void Program::add(const char* name, const char* about, const std::function<void(Arguments&)>& arguments,
                  std::function<int()> run) {
  CLI::App* command = app_->add_subcommand(name, about);
  Arguments of_command(*command);
  arguments(of_command);
  subcommands_.push_back({command, std::move(run)});
}

void Program::add_elsewhere(const char* name, const char* about, std::function<int(char** argv)> start) {
  app_->add_subcommand(name, about);
  elsewhere_.push_back({name, std::move(start)});
}

std::string Program::help() const {
  return app_->help();
}

int Program::run(int argc, char** argv) {
  argv_ = argv;
  if (argc < 2) {
    if (without_arguments_) return without_arguments_();
    std::fputs(help().c_str(), stdout);
    return kUsage;
  }
  for (const Elsewhere& elsewhere : elsewhere_)
    if (argv[1] == elsewhere.name) return elsewhere.start(argv);
  if (const auto refused = refuse_subcommand(*app_, argc, argv)) {
    complain(*refused);
    return kUsage;
  }
  try {
    app_->parse(argc, argv);
  } catch (const CLI::ExtrasError& error) {
    const auto refused = refuse_option(*app_);
    complain(refused ? *refused : error.what());
    return kUsage;
  } catch (const CLI::ParseError& error) {
    return app_->exit(error) == 0 ? kCompleted : kUsage;
  }
  const auto chosen = std::ranges::find_if(subcommands_, [](const Subcommand& s) { return s.app->parsed(); });
  return chosen->run();
}

int run_program(int argc, char** argv, const char* about,
                std::initializer_list<void (*)(Program&)> subcommands) {
  // A file that may not grow becomes an error that is said, not the end of the program.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    Program program(about);
    for (const auto add : subcommands) add(program);
    const int code = program.run(argc, argv);
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
    complain(
        "what this prints could not be written to its end: make room where it goes, and give the command "
        "again.");
    return kError;
  } catch (const std::exception& error) {
    complain(std::string("this should not have happened: ") + error.what());
    return kError;
  }
}

}  // namespace fulcrum::app
