#include "engine/scenario/device_shapes.h"

#include <algorithm>
#include <string>
#include <vector>

#include "engine/render/turned.h"
#include "engine/scenario/device_links.h"
#include "engine/scenario/to_glm.h"

namespace fulcrum::scenario {

namespace {

// One link, all angles 0, in D's axes from its own joint.
struct Link {
  Vec3 axis;  // (3) unit, of the joint that turns it
  Vec3 next;  // (3) m, to the next joint, or to the arm's end
  bool last;
};

std::vector<Link> links_of(const ArmDesc& arm, const Quat& q_DK) {
  std::vector<Link> links;
  for (std::size_t j = 0; j < arm.joints.size(); ++j) {
    const bool last = j + 1 == arm.joints.size();
    const Vec3& next_K = last ? arm.end_K : arm.joints[j + 1].point_K;
    links.push_back(
        {(q_DK * arm.joints[j].axis_K).normalized(), q_DK * (next_K - arm.joints[j].point_K), last});
  }
  return links;
}

// A device's models in units of this, m: 1 mm where the longest link has 180 mm.
double unit_of(const MechanismDesc& mechanism) {
  double longest = 0;
  for (const ArmDesc& arm : mechanism.arms)
    for (const Link& link : links_of(arm, mechanism.q_DK)) longest = std::max(longest, link.next.norm());
  return longest / 180;
}

// One of the device's bodies: what is anodised, and what is brass.
struct Body {
  render::Mesh dark, brass;
};

class Shapes {
public:
  explicit Shapes(double unit) : unit_(static_cast<float>(unit)) {}

  void bar(render::Mesh& mesh, const Vec3& from, const Vec3& to, float radius_from, float radius_to) const {
    render::add_bar(mesh, narrowed(from), narrowed(to), unit_ * radius_from, unit_ * radius_to);
  }
  void ball(render::Mesh& mesh, const Vec3& centre, float radius) const {
    render::add_ball(mesh, narrowed(centre), unit_ * radius);
  }
  // About a joint's axis, from one place on it to another.
  void drum(render::Mesh& mesh, const Vec3& joint, const Vec3& axis, float radius, float from,
            float to) const {
    bar(mesh, joint + static_cast<double>(unit_ * from) * axis,
        joint + static_cast<double>(unit_ * to) * axis, radius, radius);
  }

private:
  float unit_;
};

// knuckle: in L, from where a finger leads to the end.
Body make_link(const Link& link, const Shapes& shapes, const std::optional<Vec3>& knuckle, bool ball_at_end) {
  Body body;
  shapes.drum(body.brass, Vec3::Zero(), link.axis, 9, -10, 10);
  shapes.drum(body.dark, Vec3::Zero(), link.axis, 6, -12, 12);
  if (knuckle) {
    shapes.bar(body.dark, Vec3::Zero(), *knuckle, 6.5F, 4.5F);
    shapes.ball(body.brass, *knuckle, 5.5F);
    shapes.bar(body.dark, *knuckle, link.next, 3.4F, 1.3F);
  } else {
    // Along the joint's axis first, then away from it.
    const Vec3 corner = link.axis.dot(link.next) * link.axis;
    shapes.bar(body.dark, Vec3::Zero(), corner, 8, 8);
    shapes.bar(body.dark, corner, link.next, 8, link.last ? 4 : 6.5F);
    if (corner.norm() > 0) shapes.ball(body.dark, corner, 8);
  }
  if (ball_at_end) shapes.ball(body.brass, link.next, 7);
  return body;
}

// A post behind the arms, and what holds their first joints. In D.
Body make_base(const std::vector<std::vector<Link>>& arms, const std::vector<Vec3>& first_D, double unit,
               const Vec3& up_D, std::optional<double> floor_below) {
  const Shapes shapes(unit);
  Body body;
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : first_D) middle += p / static_cast<double>(first_D.size());
  const Vec3 behind = (middle - middle.dot(up_D) * up_D).normalized() * 42 * unit;
  for (std::size_t i = 0; i < arms.size(); ++i) {
    const Link& link = arms[i].front();
    // The motor, on the side of the joint that the link leaves free.
    const Vec3 axis = link.axis.dot(link.next) > 0 ? Vec3(-link.axis) : link.axis;
    shapes.drum(body.dark, first_D[i], axis, 17, 11, 46);
    shapes.drum(body.brass, first_D[i], axis, 17.6F, 16, 18);
    shapes.drum(body.brass, first_D[i], axis, 17.6F, 39, 41);
    const Vec3 held = first_D[i] + 28 * unit * axis;
    shapes.bar(body.dark, held, held + behind, 9, 9);
    shapes.bar(body.dark, held + behind, middle + 28 * unit * axis + behind, 9, 9);
    shapes.ball(body.dark, held + behind, 9);
  }
  const Vec3 top = middle + behind + 52 * unit * up_D;
  if (!floor_below) return body;
  const Vec3 foot = top - (*floor_below + up_D.dot(top)) * up_D;
  shapes.bar(body.dark, foot, top, 13, 13);
  shapes.bar(body.brass, top - 34 * unit * up_D, top - 14 * unit * up_D, 15, 15);
  shapes.bar(body.dark, foot, foot + 12 * unit * up_D, 60, 60);
  shapes.bar(body.brass, foot + 12 * unit * up_D, foot + 16 * unit * up_D, 18, 18);
  return body;
}

}  // namespace

void add_device_arms(render::VisualDesc& desc, const MechanismDesc& mechanism, const MappingDesc& mapping,
                     std::optional<double> floor, std::uint32_t layers) {
  const std::size_t dark = desc.materials.size();
  desc.materials.push_back({"anodised aluminium", {0.028F, 0.032F, 0.042F}, 0.35F, 0.36F});
  desc.materials.push_back({"brass", {0.83F, 0.60F, 0.26F}, 1.0F, 0.30F});
  const auto add = [&](Body&& body, const std::string& name, const Pose& X_WB, std::size_t follows) {
    const auto add_mesh = [&](render::Mesh&& mesh, std::size_t material) {
      if (mesh.indices.empty()) return;
      mesh.name = name;
      render::Instance instance;
      instance.mesh = desc.meshes.size();
      instance.material = material;
      instance.name = name;
      instance.X_WM = to_glm(X_WB);
      instance.movable = follows > 0;
      instance.follows = follows;
      instance.layers = layers;
      desc.meshes.push_back(std::move(mesh));
      desc.instances.push_back(std::move(instance));
    };
    add_mesh(std::move(body.dark), dark);
    add_mesh(std::move(body.brass), dark + 1);
  };

  const double unit = unit_of(mechanism);
  const Shapes shapes(unit);
  const Mechanism at_home(mechanism);
  std::vector<std::vector<Link>> arms;
  std::vector<Vec3> first_D;
  for (int arm = 0; arm < at_home.arms(); ++arm) {
    arms.push_back(links_of(mechanism.arms[static_cast<std::size_t>(arm)], mechanism.q_DK));
    first_D.push_back(at_home.placed(arm).point_D[0]);
  }
  const Vec3 up_D = mapping.X_WD.q.conjugate() * Vec3::UnitY();
  std::optional<double> floor_below;  // of D's origin
  if (floor) floor_below = mapping.X_WD.p.y() - *floor;
  add(make_base(arms, first_D, unit, up_D, floor_below), "device/base", mapping.X_WD, 0);

  // From an arm's end to its knuckle: along the handle, and behind it.
  std::optional<Vec3> way_D;
  if (arms.size() == 2) {
    const Vec3 handle = (at_home.placed(1).X_DE.p - at_home.placed(0).X_DE.p).normalized();
    const Vec3 base = 0.5 * (first_D[0] + first_D[1]);
    way_D = unit * (60 * handle + 45 * (base - base.dot(handle) * handle).normalized());
  }
  DeviceLinks places(mechanism, mapping);
  const std::vector<Pose>& X_WL = places.follow(mapping.X_WD);
  std::size_t body = 0;
  for (std::size_t arm = 0; arm < arms.size(); ++arm) {
    for (std::size_t j = 0; j < arms[arm].size(); ++j, ++body) {
      const Link& link = arms[arm][j];
      std::optional<Vec3> knuckle;
      if (link.last && way_D) knuckle = link.next + X_WL[body].q.conjugate() * (mapping.X_WD.q * *way_D);
      add(make_link(link, shapes, knuckle, link.last && arm > 0),
          "device/" + mechanism.arms[arm].name + "/" + mechanism.arms[arm].joints[j].name, X_WL[body],
          body + 1);
    }
  }
}

}  // namespace fulcrum::scenario
