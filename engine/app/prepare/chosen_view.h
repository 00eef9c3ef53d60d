#pragma once
// The view that --view names: where a window starts, and where the picture is drawn from.

#include <optional>
#include <string>

#include "engine/app/prepare/prepare.h"

namespace fulcrum::app {

// Why there is no such view; absent: there is, or none was named.
std::optional<Error> refuse_view(const scenario::Scenario& scenario, const std::string& scenario_name,
                                 const std::string& view);

// What is drawn, its camera in the view of that name; empty: in the scenario's first.
Result<scenario::VisualAssembly> assemble_view(const Prepared& prepared, const SceneDesc& scene,
                                               const std::string& name);

}  // namespace fulcrum::app
