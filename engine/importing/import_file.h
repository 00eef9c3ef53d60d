#pragma once
// One mesh file of another program -> a .glb that scenarios can name, and what there is to know about it.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/importing/guess.h"

namespace fulcrum::importing {

struct ImportOptions {
  std::optional<LengthUnit> unit;  // without it guessed
  std::optional<UpAxis> up;        // without it guessed
  std::optional<double> simplify;  // m: a coarser model to draw is made, too
};

// Of the model as it is written: metres, Y up.
struct Imported {
  Model model;
  std::optional<Model> drawn;  // the coarser one, where it has fewer triangles
  double drawn_deviation = 0;  // m, measured at corners and middles of both surfaces
  std::string format;
  Guess<double> unit_m;      // of the file; why is empty where it was given
  Guess<UpAxis> up;          // likewise
  Vec3 size = Vec3::Zero();  // (3) m, of its box
  std::size_t triangles = 0;
  std::size_t drawn_triangles = 0;
  std::size_t images = 0;                       // left out
  std::size_t lights = 0;                       // left out
  std::vector<std::string> materials_left_out;  // by name: "opacity", "emission"
  std::size_t thin_triangles = 0;               // lower than kThin
  std::vector<std::string> mended;  // sentences: what a scenario mends of its surface when it loads it
  std::string why_not_solid;        // empty: it can be touched
  std::string question;             // a sentence about its size; empty: there is none
};

inline constexpr double kThin = 1e-6;  // m, of a triangle's least height

Result<Imported> import_file(const std::filesystem::path& file, const ImportOptions& options);

}  // namespace fulcrum::importing
