#pragma once
// How different two pictures look to who alternates between them, pixel by pixel.
//
// P. Andersson, J. Nilsson, T. Akenine-Möller, M. Oskarsson, K. Åström, M. D. Fairchild, "FLIP: A Difference
// Evaluator for Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020: LDR-FLIP.

#include <array>
#include <cstddef>
#include <vector>

namespace fulcrum::analysis::picture {

struct Image {
  std::size_t width = 0, height = 0;         // pixels
  std::vector<std::array<float, 3>> pixels;  // (height x width) rows from the top; sRGB encoded, 0..1
};

// The paper's viewer: 0.7 m away from a screen 0.7 m and 3840 pixels wide.
inline constexpr double kPixelsPerDegree = 67.0206432765823;

// (height x width) 0: no difference is seen .. 1: the largest that there is. Both are of one size, of a pixel
// at least. Swapped pictures give the same.
std::vector<double> flip(const Image& reference, const Image& test,
                         double pixels_per_degree = kPixelsPerDegree);

}  // namespace fulcrum::analysis::picture
