#pragma once

#include <vector>

#include "tools/content/piping/flanges.h"
#include "tools/content/piping/plant.h"

namespace fulcrum::content {

// A pair of flanges on a straight run: at this coordinate of the run's own world axis.
struct Joint {
  std::size_t run;
  double at;  // m
};

enum class LineEnd {
  open,   // the drawing ends here; the pipe does not
  blind,  // closed by a blind flange; the last corner is the face of the pipe's flange
};

struct PipeLine {
  int number;
  Finish finish;
  FlangeSize size;
  std::vector<Eigen::Vector3d> corners;  // (n x 3) m; runs lie along world axes
  std::vector<Joint> joints;
  LineEnd end = LineEnd::open;
  FlangeSize end_size = size;  // of the blind flange
};

// Pipe, flanges, gaskets and bolts.
void add_pipe_line(Plant* plant, const PipeLine& line);

// Where the flanges of two parts meet: X_WJ has its origin in the middle of the gasket, z along the pipe.
// `name` is "07/a".
void add_bolts(Plant* plant, const std::string& name, const Eigen::Isometry3d& X_WJ, const FlangeSize& size);

// A flange whose face looks along +z (towards = 1) or -z (towards = -1) of the joint's frame.
Eigen::Isometry3d flange_pose(const Eigen::Isometry3d& X_WJ, int towards);

}  // namespace fulcrum::content
