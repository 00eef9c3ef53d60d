#include <cstdio>
#include <memory>

#include "engine/analysis/uniformity/report.h"
#include "engine/analysis/uniformity/tables.h"
#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/named_device.h"
#include "engine/app/cli/report_output.h"
#include "engine/app/cli/studies.h"
#include "engine/app/cli/terminal.h"
#include "engine/studies/commands.h"

namespace fulcrum::app {
namespace {

constexpr const char* kDevice = "freedom6s";  // that the study is about
constexpr int kStrikes = 20;

int uniformity_command(const RunOptions& options) {
  constexpr std::string_view files[] = {analysis::uniformity::kUniformityCsvName,
                                        analysis::uniformity::kFilterCsvName,
                                        analysis::uniformity::kUniformityPageName};
  const std::optional<DeviceDesc> device = pushing_device_named(kDevice);
  if (!device) return kError;
  const auto place = report_place("uniformity", options, files);
  if (!place) return kError;
  ProgressBar bar;
  analysis::uniformity::UniformityStudy study = analysis::uniformity::study_uniformity(
      *device, {}, kStrikes, [&bar](std::string_view what, double fraction) { bar.show(what, fraction); });
  bar.clear();
  study.command = "fulcrum uniformity";
  const auto folder = write_report(
      *place,
      {{analysis::uniformity::kUniformityCsvName, analysis::uniformity::uniformity_csv(study).text()},
       {analysis::uniformity::kFilterCsvName, analysis::uniformity::filter_csv(study).text()},
       {analysis::uniformity::kUniformityPageName, analysis::uniformity::uniformity_page(study).html()}});
  if (!folder) return kError;
  for (const std::string& sentence : analysis::uniformity::uniformity_answer(study))
    std::printf("%s\n", sentence.c_str());
  print_table(analysis::uniformity::summary_table(study));
  std::printf("Tables and plots lie in %s\n", bold(folder->string()).c_str());
  return kCompleted;
}

}  // namespace

void add_uniformity(Program& program) {
  const auto options = std::make_shared<RunOptions>();
  program.add(
      kUniformityStudy.name, kUniformityStudy.about,
      [options](Arguments& arguments) { arguments.out(*options); },
      [options] { return uniformity_command(*options); });
}

}  // namespace fulcrum::app
