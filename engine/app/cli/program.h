#pragma once
// The command line: subcommands, each of which says what options it has. Only program.cpp knows the parser.

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/cli/run_options.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace fulcrum::app {

struct Argument {
  const char* name;  // "scenario", or "--hand" for an option
  const char* type;  // what stands for its value in the help: "NAME|FILE"
  const char* help;  // one line
};

// The arguments of one subcommand. Each keeps a reference to where its value goes.
class Arguments {
public:
  explicit Arguments(CLI::App& command) : command_(command) {}

  void required(const Argument& argument, std::string& value);
  void required(const Argument& argument, std::vector<std::string>& values);  // one or more
  void choice(const char* name, const char* help, std::string& value, std::vector<std::string> choices);
  void flag(const char* name, const char* help, bool& value);
  CLI::Option* text(const Argument& argument, std::string& value);
  CLI::Option* count(const Argument& argument, std::uint64_t& value, std::uint64_t least, std::uint64_t most);
  void number(const Argument& argument, double& value, double least, double most);
  void number(const Argument& argument, std::optional<double>& value, double least, double most);
  void positive(const Argument& argument, std::optional<double>& value);
  void count(const Argument& argument, const std::function<void(std::int64_t)>& take);
  // read: what is wrong with the text, as a sentence; empty: nothing.
  void text(const Argument& argument, const std::function<std::string(const std::string&)>& read);
  // The same for an option that may be given again.
  void texts(const Argument& argument, const std::function<std::string(const std::string&)>& read);
  // Only one of the two may be given.
  static void exclude(CLI::Option* one, CLI::Option* other);

  // What several commands have.
  void out(RunOptions& options);                        // --out, --force
  void overrides(std::vector<std::string>& overrides);  // --set
  void json(const char* help, bool& json);              // --json
  void size(render::Extent& size);                      // --size

private:
  CLI::App& command_;
};

class Program {
public:
  explicit Program(const char* about);
  ~Program();

  // arguments: asked at once; run: called if this subcommand is chosen, for the program's exit code.
  void add(const char* name, const char* about, const std::function<void(Arguments&)>& arguments,
           std::function<int()> run);
  // A subcommand that another program carries out, with all arguments as they are.
  void add_elsewhere(const char* name, const char* about, std::function<int(char** argv)> start);
  // What is done where there are no arguments at all; without it, the help is printed.
  void without_arguments(std::function<int()> run) { without_arguments_ = std::move(run); }
  std::string help() const;
  // Of the run that is going on: the arguments as they came.
  char** arguments() const { return argv_; }
  // The exit code: of the subcommand, or kUsage after a sentence that says what is wrong.
  int run(int argc, char** argv);

private:
  struct Subcommand {
    CLI::App* app;
    std::function<int()> run;
  };
  struct Elsewhere {
    std::string name;
    std::function<int(char** argv)> start;
  };
  std::unique_ptr<CLI::App> app_;
  std::vector<Subcommand> subcommands_;
  std::vector<Elsewhere> elsewhere_;
  std::function<int()> without_arguments_;
  char** argv_ = nullptr;
};

// What main() does: asks each for its subcommand, runs the one that is chosen, says what went wrong; the exit
// code.
int run_program(int argc, char** argv, const char* about,
                std::initializer_list<void (*)(Program&)> subcommands);

}  // namespace fulcrum::app
