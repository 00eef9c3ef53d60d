#include "tests/bench/peer_cost.h"

#include <cmath>

#include "tests/bench/cpu_time.h"
#include "tests/bench/peers/peer.h"

namespace fulcrum::bench {
namespace {

constexpr std::size_t kWarm = 16;

PeerCost cost_of(Peer& peer, const Workload& workload, const std::vector<Pose>& poses) {
  for (std::size_t i = 0; i < kWarm; ++i) peer.look(poses[poses.size() - 1 - i]);
  std::vector<double> us;
  double contacts = 0, error = 0, whole = 0;
  for (const Pose& X_WT : poses) {
    us.push_back(cpu_us([&] { peer.look(X_WT); }));
    const double truth = workload.truth.depth(X_WT, kDepthTolerance);
    contacts += static_cast<double>(peer.contacts());
    error += std::abs(peer.depth_max() - truth);
    whole += truth;
  }
  return {quantile(us, 0.5), quantile(us, 0.99), contacts / static_cast<double>(poses.size()),
          100 * error / whole};
}

}  // namespace

std::vector<PeerResult> cost_of_peers(const Workload& workload, const std::vector<Pose>& poses) {
  std::vector<PeerResult> results{{"fcl", "FCL", "libfcl-dev", {}},
                                  {"bullet", "Bullet", "libbullet-dev", {}},
                                  {"mujoco", "MuJoCo", "libmujoco-dev", {}}};
  for (PeerResult& result : results) {
    std::unique_ptr<Peer> peer;
#ifdef FULCRUM_BENCH_FCL
    if (result.key == "fcl") peer = make_fcl_peer(workload);
#endif
#ifdef FULCRUM_BENCH_BULLET
    if (result.key == "bullet") peer = make_bullet_peer(workload);
#endif
#ifdef FULCRUM_BENCH_MUJOCO
    if (result.key == "mujoco") peer = make_mujoco_peer(workload);
#endif
    if (!peer) continue;
    result.name += " " + peer->version();
    result.cost = cost_of(*peer, workload, poses);
  }
  return results;
}

}  // namespace fulcrum::bench
