#include "engine/app/prepare/chosen_view.h"

#include <algorithm>

#include "engine/app/cli/terminal.h"
#include "engine/scenario/kept_levels.h"
#include "engine/scenario/words.h"

namespace fulcrum::app {

std::optional<Error> refuse_view(const scenario::Scenario& scenario, const std::string& scenario_name,
                                 const std::string& view) {
  std::vector<std::string_view> known;
  for (const scenario::View& one : scenario.views) known.push_back(one.name);
  if (view.empty() || std::ranges::find(known, view) != known.end()) return std::nullopt;
  const std::string otherwise = known.empty() ? "leave out --view" : "there is: " + scenario::joined(known);
  return Error{"the scenario '" + scenario_name + "' has no view '" + view + "'" +
               scenario::did_you_mean(view, known, otherwise)};
}

Result<scenario::VisualAssembly> assemble_view(const Prepared& prepared, const SceneDesc& scene,
                                               const std::string& name) {
  scenario::Checked<scenario::VisualAssembly> visual =
      scenario::assemble_visual(prepared.scenario, prepared.models, scene);
  if (!visual) return Error{scenario::to_text(visual.faults())};
  const std::vector<std::string>& told =
      prepared.haptic.warnings;  // a folder that keeps nothing, by the bakes
  for (const std::string& note : scenario::add_levels_of_detail(visual->desc, BakeCache()))
    if (std::ranges::find(told, note) == told.end()) complain(note);
  const auto named = std::ranges::find(visual->views, name, &scenario::View::name);
  if (named != visual->views.end()) visual->desc.camera = named->camera;
  return std::move(*visual);
}

}  // namespace fulcrum::app
