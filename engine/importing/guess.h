#pragma once
// In which unit a mesh was made, and which of its axes points up: as its file says, or guessed, with the
// reason. A guess is for a person to look at.

#include <optional>
#include <string>

#include "engine/assets/length_unit.h"
#include "engine/importing/mesh_reader.h"

namespace fulcrum::importing {

enum class UpAxis { y, z };

template <class T>
struct Guess {
  T value;
  std::string why;  // "since ..."
};

// m for one unit. across: the diagonal of the mesh's box, in its own unit. What is worked on with a hand is
// millimetres to metres across: less than one unit is metres, more millimetres.
Guess<double> guess_unit(const ReadMesh& read, double across);

Guess<UpAxis> guess_up(const ReadMesh& read);

// The unit that a line of text names: "File units = millimeters".
std::optional<LengthUnit> unit_named_in(const std::string& line);

}  // namespace fulcrum::importing

template <>
inline constexpr std::array<std::string_view, 2> fulcrum::names_of<fulcrum::importing::UpAxis>{"y", "z"};
