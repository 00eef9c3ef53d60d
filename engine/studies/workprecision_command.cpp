#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "engine/analysis/workprecision/report.h"
#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/report_output.h"
#include "engine/app/cli/studies.h"
#include "engine/app/cli/terminal.h"
#include "engine/scenario/assemble.h"
#include "engine/scenario/content.h"
#include "engine/scenario/load.h"
#include "engine/studies/commands.h"
#include "engine/studies/picture_study.h"
#include "engine/studies/speed_study.h"

namespace fulcrum::app {
namespace {

nlohmann::ordered_json to_json(const std::vector<analysis::workprecision::WorkStudy>& studies) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const analysis::workprecision::WorkStudy& study : studies) {
    for (const analysis::workprecision::WorkPoint& point : study.points)
      all.push_back({{"truth", study.truth},
                     {"method", point.method},
                     {"parameter", study.parameter},
                     {"value", point.value},
                     {"error", point.error},
                     {"error_unit", study.error_unit},
                     {"cpu_us", point.cpu_us},
                     {"order", point.order}});
  }
  return all;
}

// Where the expert's way ends in the shipped scene. Without its models, which a build may leave out, that
// study is left out, too.
std::optional<analysis::workprecision::PipingParts> piping_parts() {
  const Result<std::filesystem::path> file = scenario::find_scenario("piping");
  if (!file) return std::nullopt;
  const scenario::Checked<scenario::Scenario> piping = scenario::load_scenario(*file);
  if (!piping) return std::nullopt;
  const scenario::Checked<scenario::LoadedModels> models = scenario::load_models(*piping);
  if (!models) return std::nullopt;
  analysis::workprecision::PipingParts parts;
  for (std::size_t i = 0; i < piping->models.size(); ++i)
    if (piping->models[i].role == scenario::ModelRole::scene)
      parts.scene_W = to_triangle_mesh(models->models[i]);
  parts.tool_T = models->tool_T.mesh;
  for (const scenario::HandEntry& hand : piping->hands)
    if (hand.name == "expert" && !hand.waypoints.empty())
      parts.X_WT = hand.waypoints.back().X_WT * Pose{Quat::Identity(), models->p_MT};
  parts.p_TC = piping->tool.touch_point - models->p_MT;
  return parts;
}

int workprecision_command(const RunOptions& options) {
  constexpr std::string_view files[] = {analysis::workprecision::kWorkCsvName,
                                        analysis::workprecision::kWorkPageName};
  const auto place = report_place("workprecision", options, files);
  if (!place) return kError;
  const std::optional<analysis::workprecision::PipingParts> piping = piping_parts();
  if (!piping) complain("the scenario 'piping' cannot be read, so its studies are left out.");
  ProgressBar bar;
  const std::vector<analysis::workprecision::WorkStudy> studies =
      analysis::workprecision::study_work_precision(
          piping, [&bar](std::string_view what, double fraction) { bar.show(what, fraction); });
  bar.clear();
  const auto folder = write_report(
      *place, {{analysis::workprecision::kWorkCsvName, analysis::workprecision::work_csv(studies).text()},
               {analysis::workprecision::kWorkPageName, analysis::workprecision::work_page(studies).html()}});
  if (!folder) return kError;
  if (options.json) {
    std::printf(
        "%s\n",
        nlohmann::ordered_json{{"folder", folder->string()}, {"points", to_json(studies)}}.dump(2).c_str());
    return kCompleted;
  }
  print_table(analysis::workprecision::work_table(studies));
  std::printf("\n");
  print_table(analysis::workprecision::advantage_table(studies));
  std::printf("%s\n", analysis::workprecision::goal_sentence(studies).c_str());
  std::printf("Plots and every setting lie in %s\n", bold(folder->string()).c_str());
  return kCompleted;
}

// What is asked of another study than this one; absent: nothing.
std::optional<std::string> refuse_for_others(const std::string& what, const PictureStudyOptions& asked) {
  if (what != "picture" && !asked.describe.empty())
    return "--describe is of `workprecision picture`: leave it out, or ask for that.";
  const char* const measuring = !asked.run.out.empty()   ? "--out"
                                : asked.run.json         ? "--json"
                                : !asked.run.gpu.empty() ? "--gpu"
                                                         : nullptr;
  if (!asked.describe.empty() && measuring != nullptr)
    return std::string(measuring) +
           " is of what is drawn and measured, and --describe draws nothing: leave one of them out.";
  if (what != "contact") return std::nullopt;
  const char* const option = !asked.scene.empty() ? "--scene" : !asked.run.gpu.empty() ? "--gpu" : nullptr;
  if (option == nullptr) return std::nullopt;
  return std::string(option) +
         " is of `workprecision picture` and `workprecision speed`: leave it out, or ask for one of them.";
}

// As a shell takes it for one word.
std::string shell_word(const std::string& text) {
  constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-./:,+";
  if (text.find_first_not_of(kPlain) == text.npos) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

// Of a study of pictures: without where its report goes.
std::string command_line(const std::string& what, const PictureStudyOptions& asked) {
  std::string command = "fulcrum workprecision " + what;
  if (!asked.scene.empty()) command += " --scene " + shell_word(asked.scene);
  if (!asked.run.gpu.empty()) command += " --gpu " + shell_word(asked.run.gpu);
  return command;
}

}  // namespace

void add_workprecision(Program& program) {
  struct Options {
    std::string what = "contact";
    PictureStudyOptions picture;
  };
  const auto options = std::make_shared<Options>();
  program.add(
      kWorkPrecisionStudy.name, kWorkPrecisionStudy.about,
      [options](Arguments& arguments) {
        arguments.choice("what",
                         "Contact, ticks and integrators, the picture's quality levels, or their speed",
                         options->what, {"contact", "picture", "speed"});
        arguments.text({"--scene", "NAME", "With picture or speed: of this scene alone"},
                       options->picture.scene);
        arguments.text(
            {"--gpu", "GPU", "With picture or speed: which GPU draws, its number or a part of its name"},
            options->picture.run.gpu);
        arguments.text({"--describe", "FOLDER",
                        "With picture: describe the scenes there for a path tracer, and draw nothing "
                        "(tools/references)"},
                       options->picture.describe);
        arguments.out(options->picture.run);
        arguments.json("Print the figures as JSON", options->picture.run.json);
      },
      [options] {
        if (const auto refused = refuse_for_others(options->what, options->picture)) {
          complain(*refused);
          return static_cast<int>(kUsage);
        }
        options->picture.command = command_line(options->what, options->picture);
        if (options->what == "picture") return picture_study(options->picture);
        if (options->what == "speed") return speed_study(options->picture);
        return workprecision_command(options->picture.run);
      });
}

}  // namespace fulcrum::app
