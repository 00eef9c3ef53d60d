#include "engine/app/chosen_view.h"

#include <algorithm>

#include "engine/scenario/words.h"

namespace fulcrum::app {

std::optional<Error> refuse_view(const Prepared& prepared, const std::string& name) {
  std::vector<std::string_view> known;
  for (const scenario::View& view : prepared.scenario.views) known.push_back(view.name);
  if (name.empty() || std::ranges::find(known, name) != known.end()) return std::nullopt;
  const std::string otherwise = known.empty() ? "leave out --view" : "there is: " + scenario::joined(known);
  return Error{"the scenario '" + prepared.name + "' has no view '" + name + "'" +
               scenario::did_you_mean(name, known, otherwise)};
}

Result<scenario::VisualAssembly> assemble_view(const Prepared& prepared, const SceneDesc& scene,
                                               const std::string& name) {
  Result<scenario::VisualAssembly> visual =
      scenario::assemble_visual(prepared.scenario, prepared.models, scene);
  if (!visual) return visual;
  const auto named = std::ranges::find(visual->views, name, &scenario::View::name);
  if (named != visual->views.end()) visual->desc.camera = named->camera;
  return visual;
}

}  // namespace fulcrum::app
