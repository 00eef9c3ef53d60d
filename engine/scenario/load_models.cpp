#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/assets/gltf.h"
#include "engine/scenario/assemble.h"
#include "engine/scenario/marked.h"
#include "engine/scenario/mirror.h"
#include "engine/scenario/model_lights.h"
#include "engine/scenario/nearby.h"
#include "engine/scenario/words.h"
#include "haptics/bake/mirrored.h"
#include "haptics/math/mirror.h"

namespace fulcrum::scenario {

namespace {

// Above this the author is told that T is not where the model's origin is.
constexpr double kRecentringWorthSaying = 1e-4;  // m

// m across: of what is held or worked on, more or less was hardly meant.
constexpr double kLargestTool = 5, kLargestScene = 50, kSmallest = 1e-3;

constexpr double kFarthest = 1e5;  // m from the origin, of a vertex; as glTF files are held to

std::string length_text(double metres) {
  char text[32];
  const bool small = metres < 1e-3, medium = metres < 1;
  std::snprintf(text, sizeof text, "%.3g %s",
                metres * (small    ? 1e6
                          : medium ? 1e3
                                   : 1),
                small    ? "um"
                : medium ? "mm"
                         : "m");
  return text;
}

Fault at(const ModelEntry& entry, const std::string& sentence) {
  return entry.file.where.fault("model '" + entry.name + "': " + sentence);
}

// X_MF with unit and scale; absent: the file is as the scenario wants it.
std::optional<Eigen::Affine3d> placement(const ModelEntry& entry) {
  Eigen::Affine3d X = Eigen::Affine3d::Identity();
  X.translate(entry.X_MF.p).rotate(entry.X_MF.q).scale(Vec3(metres(entry.unit) * entry.scale));
  if (X.matrix() == Eigen::Matrix4d::Identity()) return std::nullopt;
  return X;
}

// False: some of it is out of all bounds.
bool place(Model& model, const ModelEntry& entry) {
  const std::optional<Eigen::Affine3d> X = placement(entry);
  if (!X) return true;
  transform(model.lights, *X);
  for (const ModelLight& light : model.lights)
    if (!(light.position_M.cwiseAbs().maxCoeff() <= kFarthest)) return false;
  for (ModelPart& part : model.parts) {
    transform(part, *X);
    for (const Vec3& p : part.positions)
      if (!(p.cwiseAbs().maxCoeff() <= kFarthest)) return false;
  }
  return true;
}

// Programs that think in millimetres forget that glTF is in metres.
std::optional<Fault> question_of_size(const ModelEntry& entry, const TriangleMesh& mesh) {
  Box3 box;
  for (const Vec3& p : mesh.vertices) box.extend(p);
  const double across = mesh.vertices.empty() ? kSmallest : box.diagonal().norm();
  const bool large = across > (entry.role == ModelRole::tool ? kLargestTool : kLargestScene);
  if (across >= kSmallest && !large) return std::nullopt;
  const std::string cure = !large ? "If its file is scaled twice, say 'scale: 1000' beside 'file'"
                           : entry.unit == LengthUnit::m
                               ? "If its file is in millimetres, say 'unit: mm' beside 'file'"
                               : "See that 'unit' is the file's, and 'scale' no second one";
  return at(entry, "it is " + length_text(across) + " across; is that meant? " + cure + ".");
}

// What there is in each file of which a scenario takes marked objects.
struct MarksOfFile {
  std::vector<ObjectMark> objects;
  std::vector<LightMark> lights;
};
using MarksOfFiles = std::map<std::filesystem::path, MarksOfFile>;

// A model as the scenario places it; absent, with a fault: it cannot be.
std::optional<Model> read_model(const Scenario& scenario, const ModelEntry& entry, const FileRef& file,
                                MarksOfFiles& there, Faults& faults) {
  auto model = load_gltf(scenario.folder, file.path);
  if (!model) {
    std::string sentence = model.error().sentence;
    const std::string near = nearby_files(file.name, scenario.folder);
    if (!near.empty() && sentence.ends_with('.')) sentence.pop_back();
    faults.push_back(file.where.fault("model '" + entry.name + "': " + sentence + near));
    return std::nullopt;
  }
  if (entry.marked && &file == &entry.file) {
    there[file.path] = {marks_of(*model), light_marks_of(*model)};
    if (const std::string refused = refuse_marked(*model, entry.role, entry.material); !refused.empty()) {
      faults.push_back(
          file.where.fault("model '" + entry.name + "': " + in_quotes(file.name) + " " + refused));
      return std::nullopt;
    }
    take_marked(*model, entry.role, entry.material);
  }
  if (!place(*model, entry)) {
    faults.push_back(at(entry,
                        "it is moved or scaled out of all bounds, farther than 100 km; check its 'unit', "
                        "'scale' and 'position'."));
    return std::nullopt;
  }
  return std::move(*model);
}

// Some of what the file's author sees is not drawn.
std::optional<Fault> plainer(const ModelEntry& entry, const FileRef& file, const Model& model) {
  if (model.left_out.empty()) return std::nullopt;
  std::string sentence = in_quotes(file.name) + " is drawn without ";
  for (std::size_t i = 0; i < model.left_out.size(); ++i)
    sentence.append(i == 0 ? "" : "; ").append(model.left_out[i]);
  return at(entry, sentence.append("."));
}

// lights: of the models before, and then of this one as well.
void count_lights(const ModelEntry& entry, const FileRef& file, const Model& model, std::size_t& lights,
                  LoadedModels& loaded, Faults& faults) {
  const std::size_t more = model.lights.size();
  if (more == 0) return;
  const std::string brings = in_quotes(file.name) + " brings " +
                             (more == 1 ? "a light" : std::to_string(more) + " lights") +
                             " (KHR_lights_punctual), ";
  const bool fitted = lights <= render::kMostLights;
  lights += more;
  if (fitted && lights > render::kMostLights)
    faults.push_back(at(entry, brings + "with which the models have " + std::to_string(lights) +
                                   ": at most " + std::to_string(render::kMostLights) +
                                   " are drawn; take some out of the file."));
  for (const ModelLight& light : model.lights)
    if (!can_be_drawn(light))
      faults.push_back(
          at(entry, in_quotes(file.name) + " brings a light " + in_quotes(light.name) +
                        " of more than a billion candela, or that ends within a micrometre, where "
                        "'unit' and 'scale' are counted in: correct these, or the light."));
  loaded.lights.push_back(at(entry, brings +
                                        (more == 1 ? "which throws no shadow" : "which throw no shadows") +
                                        ": the scene's 'light' alone does."));
}

// Lights of a model in whose place another file is drawn, which has none that is called so.
std::optional<Fault> lights_of_undrawn(const ModelEntry& entry, const Model& model, const Model& drawn) {
  std::vector<std::string_view> names;
  for (const ModelLight& light : model.lights)
    if (std::ranges::find(drawn.lights, light.name, &ModelLight::name) == drawn.lights.end())
      names.push_back(light.name);
  if (names.empty()) return std::nullopt;
  const bool one = names.size() == 1;
  return at(entry, in_quotes(entry.file.name) + " has " +
                       (one ? "a light " + in_quotes(names.front()) + " that lights nothing"
                            : std::to_string(names.size()) + " lights that light nothing") +
                       ", since 'drawn' takes its place: put " + (one ? "it" : "them") + " into " +
                       in_quotes(entry.drawn.name) + ".");
}

// Objects that are marked, and that no model takes; and lights, which go with objects.
void tell_of_left_out(const Scenario& scenario, const std::filesystem::path& file, const MarksOfFile& there,
                      Faults& warnings) {
  const auto takes_of_file = [&](const ModelEntry& entry) { return entry.marked && entry.file.path == file; };
  const auto is_taken = [&](const ObjectMark& mark) {
    return std::ranges::any_of(scenario.models, [&](const ModelEntry& entry) {
      return takes_of_file(entry) && ObjectMark{entry.role, entry.material} == mark;
    });
  };
  const ModelEntry& of_file = *std::ranges::find_if(scenario.models, takes_of_file);
  for (const LightMark& light : there.lights)
    if (!light.mark || !is_taken(*light.mark))
      warnings.push_back(at(of_file, in_quotes(of_file.file.name) + " has a light " + in_quotes(light.name) +
                                         " that lights nothing, for no model takes it: mark it as an object "
                                         "that one does."));
  for (const ObjectMark& mark : there.objects) {
    if (is_taken(mark)) continue;
    const std::string role(names_of<ModelRole>[static_cast<std::size_t>(mark.role)]);
    std::string sentence = in_quotes(of_file.file.name) + " has objects that are marked '" + role + "'";
    if (!mark.material.empty()) sentence.append(" with the material ").append(in_quotes(mark.material));
    sentence.append(", which no model takes: add one with 'role: ").append(role).append("'");
    if (!mark.material.empty())
      sentence.append(", 'material: ").append(on_one_line(mark.material)).append("'");
    warnings.push_back(at(of_file, sentence.append(" and 'marked: true'.")));
  }
}

void take_tool(const ModelEntry& entry, const TriangleMesh& mesh_M, LoadedModels& loaded, Faults& faults) {
  const auto solid_M = build_solid(mesh_M);
  if (!solid_M) {
    faults.push_back(at(entry, solid_M.error().sentence));
    return;
  }
  for (const std::string& note : solid_M->notes) loaded.repaired.push_back(at(entry, note));
  loaded.p_MT = mass_properties(*solid_M).centre;
  TriangleMesh mesh_T = mesh_M;
  for (Vec3& vertex : mesh_T.vertices) vertex -= loaded.p_MT;
  auto solid_T = build_solid(mesh_T);
  if (!solid_T) {
    faults.push_back(at(entry, solid_T.error().sentence));
    return;
  }
  loaded.tool_T = std::move(*solid_T);
  loaded.tool = mass_properties(loaded.tool_T);
  if (const double offset = loaded.p_MT.norm(); offset > kRecentringWorthSaying) {
    loaded.notes.push_back("the tool's centre of mass lies " + length_text(offset) + " from the origin of '" +
                           entry.file.name + "'; the tool is moved and turned about its centre of mass");
  }
}

}  // namespace

Checked<LoadedModels> load_models(const Scenario& scenario) {
  LoadedModels loaded;
  Faults faults;
  MarksOfFiles marks;
  std::size_t lights = 0;
  if (scenario.left_handed) loaded.notes.emplace_back("the scene is mirrored, for a tool in the left hand");
  if (!scenario.why_right_handed.empty())
    loaded.notes.push_back("the scene is not mirrored, as the calibration asks: " +
                           scenario.why_right_handed);
  for (const ModelEntry& entry : scenario.models) {
    if (entry.file.path.empty()) {  // its key was refused, and said so
      loaded.models.emplace_back();
      loaded.drawn.emplace_back();
      continue;
    }
    std::optional<Model> model = read_model(scenario, entry, entry.file, marks, faults);
    if (!model) continue;
    loaded.drawn.push_back(
        entry.drawn.path.empty() ? std::nullopt : read_model(scenario, entry, entry.drawn, marks, faults));
    const bool is_drawn = !scenario.left_handed || !entry.lettering;
    if (!is_drawn)
      loaded.notes.push_back("the model '" + entry.name + "' is not drawn: it would be mirror-written");
    loaded.models.push_back(std::move(*model));
    const std::optional<Model>& drawn = loaded.drawn.back();
    if (auto warning =
            drawn ? plainer(entry, entry.drawn, *drawn) : plainer(entry, entry.file, loaded.models.back()))
      loaded.warnings.push_back(std::move(*warning));
    if (is_drawn && drawn)
      if (auto warning = lights_of_undrawn(entry, loaded.models.back(), *drawn))
        loaded.warnings.push_back(std::move(*warning));
    if (is_drawn)
      count_lights(entry, drawn ? entry.drawn : entry.file, drawn ? *drawn : loaded.models.back(), lights,
                   loaded, faults);
    if (entry.role == ModelRole::decor) continue;
    const TriangleMesh mesh_M = to_triangle_mesh(loaded.models.back());
    if (auto question = question_of_size(entry, mesh_M)) loaded.warnings.push_back(std::move(*question));
    if (entry.role == ModelRole::tool) take_tool(entry, mesh_M, loaded, faults);
  }
  if (!faults.empty()) return faults;
  for (const auto& [file, there] : marks) tell_of_left_out(scenario, file, there, loaded.warnings);
  if (scenario.left_handed) {
    for (Model& model : loaded.models) mirror(model);
    for (std::optional<Model>& model : loaded.drawn)
      if (model) mirror(*model);
    fulcrum::mirror(loaded.p_MT);
    loaded.tool_T = mirrored(std::move(loaded.tool_T));
    loaded.tool = mirrored(loaded.tool);
  }
  return loaded;
}

}  // namespace fulcrum::scenario
