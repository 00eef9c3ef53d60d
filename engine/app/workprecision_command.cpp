#include <cstdio>
#include <nlohmann/json.hpp>

#include "engine/analysis/workprecision_report.h"
#include "engine/app/commands.h"
#include "engine/app/exit_code.h"
#include "engine/app/report_output.h"
#include "engine/app/terminal.h"

namespace fulcrum::app {
namespace {

nlohmann::ordered_json to_json(const std::vector<analysis::WorkStudy>& studies) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const analysis::WorkStudy& study : studies) {
    for (const analysis::WorkPoint& point : study.points)
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

}  // namespace

int workprecision_command(const RunOptions& options) {
  constexpr std::string_view files[] = {analysis::kWorkCsvName, analysis::kWorkPageName};
  const std::optional<std::filesystem::path> folder = report_folder("workprecision", options, files);
  if (!folder) return kError;
  ProgressBar bar;
  const std::vector<analysis::WorkStudy> studies = analysis::study_work_precision(
      [&bar](std::string_view what, double fraction) { bar.show(what, fraction); });
  bar.clear();
  if (!write_report(*folder, {{analysis::kWorkCsvName, analysis::work_csv(studies).text()},
                              {analysis::kWorkPageName, analysis::work_page(studies).html()}}))
    return kError;
  if (options.json) {
    std::printf(
        "%s\n",
        nlohmann::ordered_json{{"folder", folder->string()}, {"points", to_json(studies)}}.dump(2).c_str());
    return kCompleted;
  }
  print_table(analysis::work_table(studies));
  std::printf("Plots and every setting lie in %s\n", bold(folder->string()).c_str());
  return kCompleted;
}

}  // namespace fulcrum::app
