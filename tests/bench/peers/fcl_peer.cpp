// FCL: both triangle meshes as trees of OBBRSS, which its README has as the default, and every contact asked
// for (left alone, it stops at the first). A contact is a pair of triangles that cut each other, and its
// depth tells how far these two overlap: of solids it knows nothing, and its maintainers promise no depth for
// meshes.

#include <fcl/config.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>

#include <limits>

#include "tests/bench/peers/peer.h"

namespace fulcrum::bench {
namespace {

// Its triangle test has tolerances of 1e-5 in whatever unit is used: in metres that would be 10 um.
constexpr double kUnits = 1000;  // a metre

using Model = fcl::BVHModel<fcl::OBBRSSd>;

std::shared_ptr<Model> model_of(const TriangleMesh& mesh) {
  auto model = std::make_shared<Model>();
  model->beginModel(static_cast<int>(mesh.triangles.size()), static_cast<int>(mesh.vertices.size()));
  std::vector<Vec3> points;
  for (const Vec3& p : mesh.vertices) points.push_back(kUnits * p);
  std::vector<fcl::Triangle> triangles;
  for (const Triangle& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
  model->addSubModel(points, triangles);
  model->endModel();
  return model;
}

class FclPeer final : public Peer {
public:
  explicit FclPeer(const Workload& workload)
      : tool_(model_of(workload.tool.mesh)), scene_(model_of(workload.scene.mesh)) {}

  std::string version() const override { return FCL_VERSION; }

  void look(const Pose& X_WT) override {
    tool_.setTransform(X_WT.q, kUnits * X_WT.p);
    result_.clear();
    fcl::collide(&tool_, &scene_, request_, result_);
  }

  double depth_max() const override {
    double depth = 0;
    for (std::size_t i = 0; i < result_.numContacts(); ++i)
      depth = std::max(depth, result_.getContact(i).penetration_depth);
    return depth / kUnits;
  }
  std::size_t contacts() const override { return result_.numContacts(); }

private:
  fcl::CollisionObjectd tool_, scene_;
  fcl::CollisionRequestd request_{std::numeric_limits<std::size_t>::max(), true};
  fcl::CollisionResultd result_;
};

}  // namespace

std::unique_ptr<Peer> make_fcl_peer(const Workload& workload) {
  return std::make_unique<FclPeer>(workload);
}

}  // namespace fulcrum::bench
