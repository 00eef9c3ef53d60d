#pragma once
// Another library's answer to the benchmark's question: where does the spanner touch the pipes, and how deep?
// One is made where its library was found when the benchmark was configured.

#include <memory>
#include <string>

#include "haptics/math/pose.h"
#include "tests/bench/contact_workload.h"

namespace fulcrum::bench {

class Peer {
public:
  virtual ~Peer() = default;
  virtual std::string version() const = 0;

  // What is timed: the tool is moved and its contacts are found.
  virtual void look(const Pose& X_WT) = 0;

  // Of the last look().
  virtual double depth_max() const = 0;  // m, of the deepest contact, 0 when nothing touches
  virtual std::size_t contacts() const = 0;
};

std::unique_ptr<Peer> make_fcl_peer(const Workload& workload);
std::unique_ptr<Peer> make_bullet_peer(const Workload& workload);
std::unique_ptr<Peer> make_mujoco_peer(const Workload& workload);

}  // namespace fulcrum::bench
