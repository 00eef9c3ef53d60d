#include "engine/importing/guess.h"

#include <cctype>
#include <cstdio>
#include <utility>
#include <vector>

namespace fulcrum::importing {
namespace {

std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : line + " ")
    if (std::isalpha(static_cast<unsigned char>(c)))
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (!word.empty())
      words.push_back(std::exchange(word, {}));
  return words;
}

std::string across_text(double across) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", across);
  return text;
}

}  // namespace

std::optional<LengthUnit> unit_named_in(const std::string& line) {
  constexpr std::pair<std::string_view, LengthUnit> kNames[] = {{"mm", LengthUnit::mm},
                                                                {"millimeter", LengthUnit::mm},
                                                                {"millimeters", LengthUnit::mm},
                                                                {"millimetre", LengthUnit::mm},
                                                                {"millimetres", LengthUnit::mm},
                                                                {"cm", LengthUnit::cm},
                                                                {"centimeter", LengthUnit::cm},
                                                                {"centimeters", LengthUnit::cm},
                                                                {"centimetre", LengthUnit::cm},
                                                                {"centimetres", LengthUnit::cm},
                                                                {"m", LengthUnit::m},
                                                                {"meter", LengthUnit::m},
                                                                {"meters", LengthUnit::m},
                                                                {"metre", LengthUnit::m},
                                                                {"metres", LengthUnit::m},
                                                                {"in", LengthUnit::in},
                                                                {"inch", LengthUnit::in},
                                                                {"inches", LengthUnit::in},
                                                                {"ft", LengthUnit::ft},
                                                                {"foot", LengthUnit::ft},
                                                                {"feet", LengthUnit::ft},
                                                                {"um", LengthUnit::um},
                                                                {"micron", LengthUnit::um},
                                                                {"microns", LengthUnit::um},
                                                                {"micrometer", LengthUnit::um},
                                                                {"micrometers", LengthUnit::um},
                                                                {"micrometre", LengthUnit::um},
                                                                {"micrometres", LengthUnit::um}};
  for (const std::string& word : words_of(line))
    for (const auto& [name, unit] : kNames)
      if (word == name) return unit;
  return std::nullopt;
}

Guess<double> guess_unit(const ReadMesh& read, double across) {
  if (const auto named = unit_named_in(read.said_of_unit))
    return {metres(*named), "since the file says '" + read.said_of_unit + "'"};
  if (read.format == "glTF") return {1.0, "since glTF is in metres"};
  if (read.unit_m) return {*read.unit_m, "since the file's own figures say so"};
  const std::string measured = "since it is " + across_text(across) + " units across, and ";
  if (across < 1) return {metres(LengthUnit::m), measured + "less than one is hardly anything but metres"};
  if (across < 5000)
    return {metres(LengthUnit::mm), measured + read.format + " files of parts for a hand are in millimetres"};
  return {metres(LengthUnit::um), measured + "more than 5000 mm is nothing for a hand"};
}

Guess<UpAxis> guess_up(const ReadMesh& read) {
  if (read.y_is_up) return {UpAxis::y, "since " + read.format + " says which axis is up"};
  if (read.format == "OBJ") return {UpAxis::y, "since most programs write OBJ so"};
  return {UpAxis::z, "since most programs write " + read.format + " so"};
}

}  // namespace fulcrum::importing
