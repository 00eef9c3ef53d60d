#pragma once
// The places that a scenario's file has, each with a handle that an author drags.

#include <cstddef>
#include <string>
#include <vector>

#include "engine/app/prepare/prepare.h"
#include "engine/scenario/write_back.h"

namespace fulcrum::app {

struct Handle {
  enum class Kind {
    checkpoint,
    corner,  // of a line that a checkpoint has to be followed along
    ball,    // to be avoided
    start,   // of the touch point
    grasp,   // where the tool is held, on the tool
    eye,     // of a view
    target,  // that it looks at
    light    // its own place, or for one from far away the end of an arm towards it
  };
  Kind kind = Kind::start;
  std::size_t index = 0;   // of checkpoints, balls, views
  std::size_t corner = 0;  // of a checkpoint's line
  std::string name;        // as the picture names it
  Vec3 p_W = Vec3::Zero();
  double radius = 0;  // m, of what can be taken hold of all over; 0: the handle alone

  bool operator==(const Handle&) const = default;
};

// X_WT: where the tool is. In the order in which the file's own kinds are listed above.
std::vector<Handle> handles_of(const Prepared& prepared, const Pose& X_WT);

// What the file has to say for this handle to be at p_W.
std::vector<scenario::NumberChange> put_at(const Prepared& prepared, const Pose& X_WT, const Handle& handle,
                                           const Vec3& p_W);

}  // namespace fulcrum::app
