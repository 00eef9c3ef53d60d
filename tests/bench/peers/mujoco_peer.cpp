// MuJoCo: convex geoms on both sides, since it takes the hull of every mesh and asks for concave bodies to be
// cut up: meshes for the spanner's pieces and the bends, cylinders for the runs. The spanner is a free body;
// of a step only kinematics and collision are run. Contact margin 0, as by default. A body for each piece
// takes a third longer than all of them in the world's; the option multiccd adds contacts, time, and nothing
// to the deepest one. Depths are those of libccd's MPR, which are mostly too large.

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cstring>
#include <sstream>
#include <stdexcept>

#include "tests/bench/convex_pieces.h"
#include "tests/bench/peers/peer.h"

namespace fulcrum::bench {
namespace {

struct Numbers {
  const Vec3& v;
};
std::ostream& operator<<(std::ostream& out, const Numbers& numbers) {
  return out << numbers.v.x() << ' ' << numbers.v.y() << ' ' << numbers.v.z();
}

void write_meshes(const char* name, const std::vector<HullPoints>& pieces, std::ostream& out) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    out << "<mesh name='" << name << i << "' vertex='";
    for (const Vec3& p : pieces[i]) out << Numbers{p} << ' ';
    out << "'/>\n";
  }
}

void write_geoms(const char* name, std::size_t count, std::ostream& out) {
  for (std::size_t i = 0; i < count; ++i) out << "<geom type='mesh' mesh='" << name << i << "'/>\n";
}

std::string scene_text(const Workload& workload) {
  const std::vector<HullPoints> spanner = spanner_pieces(workload.tool.mesh);
  const PipePieces pipes = pipe_pieces(workload.pipes);
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(9);
  out << "<mujoco><size nconmax='2000' njmax='10000'/><asset>\n";
  write_meshes("spanner", spanner, out);
  write_meshes("bend", pipes.bends, out);
  out << "</asset><worldbody>\n";
  for (const PipePieces::Cylinder& run : pipes.runs) {
    out << "<geom type='cylinder' fromto='" << Numbers{run.from} << ' ' << Numbers{run.to} << "' size='"
        << run.radius << "'/>\n";
  }
  write_geoms("bend", pipes.bends.size(), out);
  out << "<body><freejoint/><inertial pos='0 0 0' mass='0.15' diaginertia='1e-4 1e-4 1e-4'/>\n";
  write_geoms("spanner", spanner.size(), out);
  out << "</body></worldbody></mujoco>\n";
  return out.str();
}

mjModel* model_of(const std::string& text) {
  constexpr const char* kName = "workload.xml";
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), kName, static_cast<int>(text.size()));
  std::memcpy(files->filedata[mj_findFileVFS(files.get(), kName)], text.data(), text.size());
  char fault[1000] = "";
  mjModel* model = mj_loadXML(kName, files.get(), fault, sizeof fault);
  mj_deleteVFS(files.get());
  if (model == nullptr) throw std::runtime_error(std::string("MuJoCo refuses the workload: ") + fault);
  return model;
}

struct Free {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};

class MujocoPeer final : public Peer {
public:
  explicit MujocoPeer(const Workload& workload)
      : model_(model_of(scene_text(workload))), data_(mj_makeData(model_.get())) {}

  std::string version() const override { return mj_versionString(); }

  void look(const Pose& X_WT) override {
    const double pose[7] = {X_WT.p.x(), X_WT.p.y(), X_WT.p.z(), X_WT.q.w(),
                            X_WT.q.x(), X_WT.q.y(), X_WT.q.z()};
    std::copy(std::begin(pose), std::end(pose), data_->qpos);
    mj_kinematics(model_.get(), data_.get());
    mj_comPos(model_.get(), data_.get());
    mj_collision(model_.get(), data_.get());
  }
  double depth_max() const override {
    double depth = 0;
    for (int i = 0; i < data_->ncon; ++i) depth = std::max(depth, -data_->contact[i].dist);
    return depth;
  }
  std::size_t contacts() const override { return static_cast<std::size_t>(data_->ncon); }

private:
  std::unique_ptr<mjModel, Free> model_;
  std::unique_ptr<mjData, Free> data_;
};

}  // namespace

std::unique_ptr<Peer> make_mujoco_peer(const Workload& workload) {
  return std::make_unique<MujocoPeer>(workload);
}

}  // namespace fulcrum::bench
