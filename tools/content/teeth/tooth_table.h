#pragma once
// How large the teeth of a lower jaw are.
//
// Assumed: means in millimetres as remembered from S. Nelson, "Wheeler's Dental Anatomy, Physiology and
// Occlusion", tables of the mandibular teeth, and not checked against the book: length of crown, mesiodistal
// and labio- or buccolingual diameter of crown, and mesiodistal and labio- or buccolingual diameter at the
// cervix.

#include <array>

namespace fulcrum::content {

struct ToothSize {
  const char* kind;
  double crown_length, width, depth, cervix_width, cervix_depth;  // mm
};

inline constexpr std::array<ToothSize, 7> tooth_table{{
    {"central incisor", 9.0, 5.0, 6.0, 3.5, 5.3},
    {"lateral incisor", 9.5, 5.5, 6.5, 4.0, 5.8},
    {"canine", 11.0, 7.0, 7.5, 5.5, 7.0},
    {"first premolar", 8.5, 7.0, 7.5, 5.0, 6.5},
    {"second premolar", 8.0, 7.0, 8.0, 5.0, 7.0},
    {"first molar", 7.5, 11.0, 10.5, 9.0, 9.0},
    {"second molar", 7.0, 10.5, 10.0, 8.0, 9.0},
}};

}  // namespace fulcrum::content
