#include <cstdio>
#include <optional>
#include <string>

#include "engine/assets/gltf.h"
#include "engine/scenario/assemble.h"
#include "engine/scenario/mirror.h"
#include "haptics/bake/mirrored.h"
#include "haptics/math/mirror.h"

namespace fulcrum::scenario {

namespace {

// Above this the author is told that T is not where the model's origin is.
constexpr double kRecentringWorthSaying = 1e-4;  // m

// m across: of what is held or worked on, more or less was hardly meant.
constexpr double kLargestTool = 5, kLargestScene = 50, kSmallest = 1e-3;

std::string millimetres(double metres) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g mm", metres * 1e3);
  return text;
}

Error at(const ModelEntry& entry, const std::string& sentence) {
  return {entry.file.where + ": model '" + entry.name + "': " + sentence};
}

// glTF is in metres, which programs that think in millimetres forget.
std::optional<std::string> question_of_size(const ModelEntry& entry, const TriangleMesh& mesh) {
  Box3 box;
  for (const Vec3& p : mesh.vertices) box.extend(p);
  const double across = mesh.vertices.empty() ? kSmallest : box.diagonal().norm();
  if (across >= kSmallest && across <= (entry.role == ModelRole::tool ? kLargestTool : kLargestScene))
    return std::nullopt;
  char size[32];
  std::snprintf(size, sizeof size, "%.3g %s", across < kSmallest ? across * 1e6 : across,
                across < kSmallest ? "um" : "m");
  return at(entry,
            "it is " + std::string(size) +
                " across; is that meant? A model is in metres: if it was made in millimetres, export it "
                "at a scale of 0.001, and if it was scaled twice, at 1000.")
      .sentence;
}

Result<Solid> solid_of(const ModelEntry& entry, const TriangleMesh& mesh) {
  auto solid = build_solid(mesh);
  if (!solid) return at(entry, solid.error().sentence);
  return solid;
}

}  // namespace

Result<LoadedModels> load_models(const Scenario& scenario) {
  LoadedModels loaded;
  if (scenario.left_handed) loaded.notes.emplace_back("the scene is mirrored, for a tool in the left hand");
  if (!scenario.why_right_handed.empty())
    loaded.notes.push_back("the scene is not mirrored, as the calibration asks: " +
                           scenario.why_right_handed);
  for (const ModelEntry& entry : scenario.models) {
    auto model = load_gltf(scenario.folder, entry.file.path);
    if (!model) return at(entry, model.error().sentence);
    if (scenario.left_handed && entry.lettering)
      loaded.notes.push_back("the model '" + entry.name + "' is not drawn: it would be mirror-written");
    loaded.models.push_back(std::move(*model));
    if (entry.role == ModelRole::decor) continue;
    const TriangleMesh mesh_M = to_triangle_mesh(loaded.models.back());
    if (const auto question = question_of_size(entry, mesh_M)) loaded.warnings.push_back(*question);
    if (entry.role != ModelRole::tool) continue;

    const auto solid_M = solid_of(entry, mesh_M);
    if (!solid_M) return solid_M.error();
    for (const std::string& note : solid_M->notes) loaded.repaired.push_back(at(entry, note).sentence);
    loaded.p_MT = mass_properties(*solid_M).centre;
    TriangleMesh mesh_T = mesh_M;
    for (Vec3& vertex : mesh_T.vertices) vertex -= loaded.p_MT;
    auto solid_T = solid_of(entry, mesh_T);
    if (!solid_T) return solid_T.error();
    loaded.tool_T = std::move(*solid_T);
    loaded.tool = mass_properties(loaded.tool_T);
    if (const double offset = loaded.p_MT.norm(); offset > kRecentringWorthSaying) {
      loaded.notes.push_back("the tool's centre of mass lies " + millimetres(offset) +
                             " from the origin of '" + entry.file.name +
                             "'; the tool is moved and turned about its centre of mass");
    }
  }
  if (scenario.left_handed) {
    for (Model& model : loaded.models) mirror(model);
    fulcrum::mirror(loaded.p_MT);
    loaded.tool_T = mirrored(std::move(loaded.tool_T));
    loaded.tool = mirrored(loaded.tool);
  }
  return loaded;
}

}  // namespace fulcrum::scenario
