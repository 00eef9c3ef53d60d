#pragma once
// Mesh files of other programs -> Model, through assimp: OBJ, STL, PLY, 3DS and what else it reads; glTF as
// any scenario reads it.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/assets/model.h"
#include "haptics/math/result.h"

namespace fulcrum::importing {

struct ReadMesh {
  Model model;         // in the numbers and along the axes of the file
  std::string format;  // as people call it: "OBJ"
  // What the file's own text says of its unit, before its triangles begin: "File units = millimeters".
  std::string said_of_unit;
  std::optional<double> unit_m;                 // what its format, or its own figures, say one unit is
  bool y_is_up = false;                         // its format says so, or its reader has turned it
  std::size_t images = 0;                       // that its materials name, and that are left out
  std::size_t lights = 0;                       // of the file, left out too
  std::vector<std::string> materials_left_out;  // by name: what else the materials of its parts have
};

// Refused, with a sentence: no file, no such format, damaged, no triangles, numbers that are not finite, more
// than 50 million triangles.
Result<ReadMesh> read_mesh(const std::filesystem::path& file);

}  // namespace fulcrum::importing
