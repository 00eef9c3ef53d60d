// Bullet: the spanner as a compound of convex hulls, the pipes as a static triangle mesh with a tree, as its
// manual has it for a moving and a standing concave body. Every hull is shrunk by the margin that Bullet adds
// around it, so that hull and margin together have the spanner's size; the triangles have none. Contacts are
// asked for by contactPairTest(), afresh at every pose: the world's own manifolds keep four points a pair and
// some of earlier poses, which costs as much and puts depths off by a quarter.

#include <LinearMath/btConvexHullComputer.h>
#include <btBulletCollisionCommon.h>

#include <algorithm>
#include <vector>

#include "tests/bench/convex_pieces.h"
#include "tests/bench/peers/peer.h"

namespace fulcrum::bench {
namespace {

// Its manual asks for moving bodies of 0.05 to 10 units, and its tolerances are made for them.
constexpr double kUnits = 100;           // a metre
constexpr btScalar kMargin = 0.04F;      // units, Bullet's own
constexpr btScalar kShrinkClamp = 0.5F;  // of a hull's inner radius

btVector3 vector_of(const Vec3& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

btTransform transform_of(const Pose& X) {
  const btQuaternion q(static_cast<btScalar>(X.q.x()), static_cast<btScalar>(X.q.y()),
                       static_cast<btScalar>(X.q.z()), static_cast<btScalar>(X.q.w()));
  return btTransform(q, vector_of(kUnits * X.p));
}

class BulletPeer final : public Peer {
public:
  explicit BulletPeer(const Workload& workload) : dispatcher_(&configuration_) {
    for (const HullPoints& piece : spanner_pieces(workload.tool.mesh)) add_hull(piece);
    for (const Triangle& t : workload.scene.mesh.triangles) {
      const auto at = [&](std::size_t i) { return vector_of(kUnits * workload.scene.mesh.vertices[t[i]]); };
      triangles_.addTriangle(at(0), at(1), at(2));
    }
    pipes_ = std::make_unique<btBvhTriangleMeshShape>(&triangles_, true);
    pipes_->setMargin(0);
    tool_.setCollisionShape(&spanner_);
    scene_.setCollisionShape(pipes_.get());
    scene_.setCollisionFlags(btCollisionObject::CF_STATIC_OBJECT);
    world_.addCollisionObject(&scene_);
    world_.addCollisionObject(&tool_);
  }
  ~BulletPeer() override {
    world_.removeCollisionObject(&tool_);
    world_.removeCollisionObject(&scene_);
  }
  BulletPeer(const BulletPeer&) = delete;
  BulletPeer& operator=(const BulletPeer&) = delete;

  std::string version() const override {
    return std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100);
  }

  void look(const Pose& X_WT) override {
    tool_.setWorldTransform(transform_of(X_WT));
    found_ = {};
    world_.contactPairTest(&tool_, &scene_, found_);
  }
  double depth_max() const override { return found_.depth / kUnits; }
  std::size_t contacts() const override { return found_.count; }

private:
  struct Found final : btCollisionWorld::ContactResultCallback {
    double depth = 0;  // units
    std::size_t count = 0;
    btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                             const btCollisionObjectWrapper*, int, int) override {
      if (point.getDistance() > 0) return 0;
      depth = std::max(depth, -static_cast<double>(point.getDistance()));
      ++count;
      return 0;
    }
  };

  void add_hull(const HullPoints& piece) {
    std::vector<btVector3> points;
    for (const Vec3& p : piece) points.push_back(vector_of(kUnits * p));
    btConvexHullComputer hull;
    hull.compute(points.front().m_floats, sizeof(btVector3), static_cast<int>(points.size()), kMargin,
                 kShrinkClamp);
    auto shape = std::make_unique<btConvexHullShape>();
    for (int i = 0; i < hull.vertices.size(); ++i) shape->addPoint(hull.vertices[i], false);
    shape->setMargin(kMargin);
    shape->recalcLocalAabb();
    spanner_.addChildShape(btTransform::getIdentity(), shape.get());
    hulls_.push_back(std::move(shape));
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btCollisionWorld world_{&dispatcher_, &broadphase_, &configuration_};
  btTriangleMesh triangles_;
  std::vector<std::unique_ptr<btConvexHullShape>> hulls_;
  btCompoundShape spanner_;
  std::unique_ptr<btBvhTriangleMeshShape> pipes_;
  btCollisionObject tool_, scene_;
  Found found_;
};

}  // namespace

std::unique_ptr<Peer> make_bullet_peer(const Workload& workload) {
  return std::make_unique<BulletPeer>(workload);
}

}  // namespace fulcrum::bench
