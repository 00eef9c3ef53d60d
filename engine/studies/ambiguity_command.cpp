#include <algorithm>
#include <cstdio>
#include <memory>

#include "engine/analysis/ambiguity/report.h"
#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/report_output.h"
#include "engine/app/cli/studies.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/prepare/prepare.h"
#include "engine/studies/commands.h"

namespace fulcrum::app {
namespace {

constexpr std::size_t kSites = 600;       // about, of the tool's surface
constexpr std::size_t kCandidates = 150;  // about, of the tool's surface

// Every so many points of a shell, which lie evenly and neighbours together.
std::vector<std::size_t> some_of(const Pointshell& shell, std::size_t count) {
  std::vector<std::size_t> some;
  const std::size_t step = std::max<std::size_t>(1, shell.size() / count);
  for (std::size_t i = 0; i < shell.size(); i += step) some.push_back(i);
  return some;
}

analysis::ambiguity::AmbiguityStudy study_of(const Prepared& prepared) {
  const SceneDesc& scene = prepared.haptic.scene;
  const Pointshell& shell = *scene.tool_shell;
  std::vector<analysis::ambiguity::ImpactSite> sites;
  for (const std::size_t i : some_of(shell, kSites)) sites.push_back({shell.positions[i], -shell.normals[i]});
  std::vector<Vec3> candidates;
  for (const std::size_t i : some_of(shell, kCandidates)) candidates.push_back(shell.positions[i]);

  analysis::ambiguity::AmbiguityStudy study;
  study.scenario = prepared.scenario.title;
  study.desc.frequency_Hz = scene.impact_vibration ? scene.impact_vibration->materials.front().frequency_Hz
                                                   : ImpactMaterial().frequency_Hz;
  study.sites = sites.size();
  study.p_MT = prepared.models.p_MT;
  study.handle = score_point(sites, scene.tool.X_HT.inverse().p, study.desc);
  study.others = rank_points(sites, candidates, study.desc);
  return study;
}

int ambiguity_command(const RunOptions& options) {
  constexpr std::string_view files[] = {analysis::ambiguity::kAmbiguityCsvName,
                                        analysis::ambiguity::kAmbiguityPageName};
  std::vector<std::string> overrides = options.overrides;
  overrides.emplace_back("contact.surface=points");  // the tool's points are the places where it is struck
  const std::optional<Prepared> prepared = prepare(options.scenario, overrides);
  if (!prepared) return kError;
  const auto place = report_place("ambiguity", options, files);
  if (!place) return kError;
  analysis::ambiguity::AmbiguityStudy study = study_of(*prepared);
  study.command = "fulcrum ambiguity " + options.scenario;
  for (const std::string& change : options.overrides) study.command += " --set " + change;
  const auto folder = write_report(
      *place, {{analysis::ambiguity::kAmbiguityCsvName, analysis::ambiguity::ambiguity_csv(study).text()},
               {analysis::ambiguity::kAmbiguityPageName, analysis::ambiguity::ambiguity_page(study).html()}});
  if (!folder) return kError;
  print_table(analysis::ambiguity::ambiguity_table(study));
  std::printf("Every place lies in %s\n", bold(folder->string()).c_str());
  return kCompleted;
}

}  // namespace

void add_ambiguity(Program& program) {
  const auto options = std::make_shared<RunOptions>();
  program.add(
      kAmbiguityStudy.name, kAmbiguityStudy.about,
      [options](Arguments& arguments) {
        arguments.required({"scenario", "NAME|FILE", "Its name or file"}, options->scenario);
        arguments.overrides(options->overrides);
        arguments.out(*options);
      },
      [options] { return ambiguity_command(*options); });
}

}  // namespace fulcrum::app
