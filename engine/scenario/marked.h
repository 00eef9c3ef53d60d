#pragma once
// Objects that a modelling program has marked: their roles and materials are custom properties of theirs.

#include <optional>
#include <string>
#include <vector>

#include "engine/assets/model.h"
#include "engine/scenario/scenario.h"

namespace fulcrum::scenario {

struct ObjectMark {
  ModelRole role = ModelRole::scene;
  std::string material;  // of what is touched; empty: none

  bool operator==(const ObjectMark&) const = default;
};

// Those that there are, each once, in the order of the objects; a word that is no role is none.
std::vector<ObjectMark> marks_of(const Model& model);

struct LightMark {
  std::string name;
  std::optional<ObjectMark> mark;  // none: it is not marked, or with a word that is no role
};

// Of each light, in their order.
std::vector<LightMark> light_marks_of(const Model& model);

// What is wrong with the marks of a file, or that none is these, to be said after the file's name; empty:
// nothing.
std::string refuse_marked(const Model& model, ModelRole role, const std::string& material);

// Leaves the objects that are marked so. There are such.
void take_marked(Model& model, ModelRole role, const std::string& material);

}  // namespace fulcrum::scenario
