#pragma once
// Boards of wood, with what their faces look like in a picture.

#include <string>

#include "tools/content/mesh/model.h"
#include "tools/content/mesh/wood.h"

namespace fulcrum::content {

struct Board {
  std::string name;
  Eigen::Vector3d half;  // m; its grain runs along z
  Wood wood;
  double roughness = 0.5;
};

// Adds a board, from -half to +half in the frame B, its edges bevelled, and its material. W: the model.
void add_board(Model* model, const Board& board, const Eigen::Isometry3d& X_WB);

}  // namespace fulcrum::content
