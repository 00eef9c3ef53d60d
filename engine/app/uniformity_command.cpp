#include <cstdio>

#include "engine/analysis/uniformity_report.h"
#include "engine/analysis/uniformity_tables.h"
#include "engine/app/commands.h"
#include "engine/app/exit_code.h"
#include "engine/app/named_device.h"
#include "engine/app/report_output.h"
#include "engine/app/terminal.h"

namespace fulcrum::app {
namespace {

constexpr const char* kDevice = "freedom6s";  // that the study is about
constexpr int kStrikes = 20;

}  // namespace

int uniformity_command(const RunOptions& options) {
  constexpr std::string_view files[] = {analysis::kUniformityCsvName, analysis::kFilterCsvName,
                                        analysis::kUniformityPageName};
  const std::optional<DeviceDesc> device = device_named(kDevice);
  if (!device) return kError;
  const std::optional<std::filesystem::path> folder = report_folder("uniformity", options, files);
  if (!folder) return kError;
  ProgressBar bar;
  analysis::UniformityStudy study = analysis::study_uniformity(
      *device, {}, kStrikes, [&bar](std::string_view what, double fraction) { bar.show(what, fraction); });
  bar.clear();
  study.command = "fulcrum uniformity";
  if (!write_report(*folder, {{analysis::kUniformityCsvName, analysis::uniformity_csv(study).text()},
                              {analysis::kFilterCsvName, analysis::filter_csv(study).text()},
                              {analysis::kUniformityPageName, analysis::uniformity_page(study).html()}}))
    return kError;
  for (const std::string& sentence : analysis::uniformity_answer(study))
    std::printf("%s\n", sentence.c_str());
  print_table(analysis::summary_table(study));
  std::printf("Tables and plots lie in %s\n", bold(folder->string()).c_str());
  return kCompleted;
}

}  // namespace fulcrum::app
