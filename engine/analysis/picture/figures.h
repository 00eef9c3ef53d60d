#pragma once
// How far each quality level's picture is from a reference of the same scene, and what it costs.

#include <string>
#include <vector>

#include "engine/analysis/picture/flip.h"

namespace fulcrum::analysis::picture {

struct LevelFigures {
  std::string quality;         // what the level does, in words
  double flip_mean = 0;        // 0..1, over all pixels
  double flip_p99 = 0;         // 0..1, the 99th percentile of the pixels
  double luminance_error = 0;  // of the whole picture's light on the screen, in relation to the reference's
  double frame_ms = 0;         // the median of a few frames
};

struct ShownPicture {
  std::string name, png;  // the file's bytes
};

struct ViewFigures {
  std::string scene, view;
  double time_s = 0;                   // of the moment
  std::vector<LevelFigures> levels;    // from the best to the cheapest
  std::vector<ShownPicture> pictures;  // reference, pictures and maps of differences
  bool stale = false;                  // the reference is of another state of the scene
};

// All but quality and time. map receives the differences (height x width), to be looked at.
LevelFigures compared(const Image& reference, const Image& test, std::vector<double>& map);

// 0..1 from black over violet and orange to a pale yellow, each lighter than the one before.
Image coloured(const std::vector<double>& map, std::size_t width);

}  // namespace fulcrum::analysis::picture
