#include "engine/scenario/marked.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>

#include "engine/scenario/words.h"

namespace fulcrum::scenario {
namespace {

constexpr std::span<const std::string_view> kRoles(names_of<ModelRole>);

// None: the object is not marked, or with a word that is no role.
template <class Object>
std::optional<ObjectMark> mark_of(const Object& object) {
  const auto role = std::ranges::find(kRoles, object.marked_role);
  if (role == kRoles.end()) return std::nullopt;
  ObjectMark mark{static_cast<ModelRole>(role - kRoles.begin()), {}};
  if (mark.role == ModelRole::scene) mark.material = object.marked_material;
  return mark;
}

std::string in_words(ModelRole role, const std::string& material) {
  std::string words = "marked with the role " + in_quotes(kRoles[static_cast<std::size_t>(role)]);
  if (!material.empty()) words += " and the material " + in_quotes(material);
  return words;
}

}  // namespace

std::vector<ObjectMark> marks_of(const Model& model) {
  std::vector<ObjectMark> marks;
  for (const ModelPart& part : model.parts)
    if (const auto mark = mark_of(part); mark && std::ranges::find(marks, *mark) == marks.end())
      marks.push_back(*mark);
  return marks;
}

std::vector<LightMark> light_marks_of(const Model& model) {
  std::vector<LightMark> marks;
  for (const ModelLight& light : model.lights) marks.push_back({light.name, mark_of(light)});
  return marks;
}

std::string refuse_marked(const Model& model, ModelRole role, const std::string& material) {
  const auto unknown = [](const auto& object) { return !object.marked_role.empty() && !mark_of(object); };
  const auto refused = [](const auto& object) {
    return "has an object " + in_quotes(object.name) + " that is marked with the role " +
           in_quotes(object.marked_role) +
           did_you_mean(object.marked_role, kRoles, "the roles are " + joined(kRoles));
  };
  if (const auto part = std::ranges::find_if(model.parts, unknown); part != model.parts.end())
    return refused(*part);
  if (const auto light = std::ranges::find_if(model.lights, unknown); light != model.lights.end())
    return refused(*light);
  const std::vector<ObjectMark> marks = marks_of(model);
  if (marks.empty())
    return "has no object with a custom property 'fulcrum_role': mark them in the modelling program, and in "
           "Blender tick Include > Custom Properties when exporting";
  if (std::ranges::find(marks, ObjectMark{role, material}) != marks.end()) return {};
  std::string there;
  for (const ObjectMark& mark : marks)
    there += (there.empty() ? "" : "; others are ") + in_words(mark.role, mark.material);
  return "has no object " + in_words(role, material) + (material.empty() ? " and no material" : "") +
         "; some are " + there;
}

void take_marked(Model& model, ModelRole role, const std::string& material) {
  const auto of_others = [&](const auto& object) { return mark_of(object) != ObjectMark{role, material}; };
  std::erase_if(model.parts, of_others);
  std::erase_if(model.lights, of_others);
}

}  // namespace fulcrum::scenario
