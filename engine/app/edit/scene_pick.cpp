#include "engine/app/edit/scene_pick.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "haptics/math/functions.h"

namespace fulcrum::app {
namespace {

struct Ray {
  Vec3 from, way;  // way: unit
};

Vec3 to_vec3(const glm::vec3& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

Ray ray_through(const render::Camera& camera, const render::Extent& picture, double x, double y) {
  const double half_height = 0.5 * picture.height, half_width = 0.5 * picture.width;
  const double slope = math::tan(0.5 * static_cast<double>(camera.vertical_fov_rad)) / half_height;
  const Vec3 eye = to_vec3(camera.eye), forward = (to_vec3(camera.target) - eye).normalized();
  const Vec3 up = std::abs(forward.y()) > 0.9999 ? Vec3(0, 0, -1) : Vec3(0, 1, 0);  // as the picture has it
  const Vec3 right = forward.cross(up).normalized();
  const double lean_right = static_cast<double>(camera.lean.x), lean_up = static_cast<double>(camera.lean.y);
  const Vec3 way = forward + (slope * (x - half_width) + lean_right) * right +
                   (slope * (half_height - y) + lean_up) * right.cross(forward);
  return {eye, way.normalized()};
}

// m along the ray to the triangle, if it is met: T. Moeller and B. Trumbore, "Fast, minimum storage
// ray-triangle intersection" (Journal of Graphics Tools 2(1), 1997), either side.
std::optional<double> meets(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, p = ray.way.cross(ac);
  const double determinant = ab.dot(p);
  if (determinant == 0) return std::nullopt;
  const Vec3 s = ray.from - a;
  const double u = s.dot(p) / determinant;
  if (!(u >= 0 && u <= 1)) return std::nullopt;
  const Vec3 q = s.cross(ab);
  const double v = ray.way.dot(q) / determinant;
  if (!(v >= 0 && u + v <= 1)) return std::nullopt;
  const double along = ac.dot(q) / determinant;
  return along > 0 ? std::optional(along) : std::nullopt;
}

struct Hit {
  double along = std::numeric_limits<double>::infinity();
  Vec3 normal = Vec3::Zero();
};

// Calls hit(along, normal) for each triangle of the part that is met.
template <class OnHit>
void for_each_hit(const ModelPart& part, const Ray& ray, const OnHit& hit) {
  for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3) {
    const Vec3 &a = part.positions[part.indices[i]], &b = part.positions[part.indices[i + 1]],
               &c = part.positions[part.indices[i + 2]];
    if (const auto along = meets(ray, a, b, c)) hit(*along, (b - a).cross(c - a));
  }
}

std::string triple(const Vec3& v, const char* form) {
  std::string text = "[";
  for (int axis = 0; axis < 3; ++axis) {
    char number[32];
    std::snprintf(number, sizeof number, form, v[axis]);
    std::string digits = number;
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.back() == '.') digits.pop_back();
    text += (axis > 0 ? ", " : "") + (digits == "-0" ? std::string("0") : digits);
  }
  return text + "]";
}

}  // namespace

std::optional<Picked> pick(const Prepared& prepared, const Pose& X_WT, const render::Camera& camera,
                           const render::Extent& picture, double x, double y) {
  const Ray seen = ray_through(camera, picture, x, y);
  const Pose X_MW = Pose{Quat::Identity(), prepared.models.p_MT} * X_WT.inverse();
  const Ray in_M{X_MW * seen.from, X_MW.q * seen.way};
  Hit nearest;
  const scenario::ModelEntry* entry_hit = nullptr;
  const ModelPart* part_hit = nullptr;
  for (std::size_t i = 0; i < prepared.scenario.models.size(); ++i) {
    const scenario::ModelEntry& entry = prepared.scenario.models[i];
    if (!entry.cut_of.empty()) continue;
    const Ray& ray = entry.role == scenario::ModelRole::tool ? in_M : seen;
    for (const ModelPart& part : prepared.models.models[i].parts) {
      for_each_hit(
          part, ray,
          [&](double along, const Vec3& normal) {
            if (along >= nearest.along) return;
            nearest = {along, normal};
            entry_hit = &entry;
            part_hit = &part;
          });
    }
  }
  if (part_hit == nullptr) return std::nullopt;
  Picked picked;
  picked.on_tool = entry_hit->role == scenario::ModelRole::tool;
  const Ray& ray = picked.on_tool ? in_M : seen;
  picked.p = ray.from + nearest.along * ray.way;
  picked.nhat = nearest.normal.normalized();
  if (picked.nhat.dot(ray.way) > 0) picked.nhat = -picked.nhat;
  picked.part = entry_hit->name + "/" + part_hit->name;
  double out = std::numeric_limits<double>::infinity();
  for_each_hit(*part_hit, ray, [&](double along, const Vec3&) {
    if (along > nearest.along + 1e-7) out = std::min(out, along);
  });
  if (std::isfinite(out)) picked.depth = out - nearest.along;
  return picked;
}

std::string picked_text(const Picked& picked) {
  std::string text = triple(picked.p, "%.5f") + "  # ";
  if (picked.on_tool) text += "of the tool's model: ";
  text += picked.part + ", normal " + triple(picked.nhat, "%.3f");
  if (picked.depth) {
    char deep[48];
    std::snprintf(deep, sizeof deep, ", %.2f mm deep", 1e3 * *picked.depth);
    text += deep;
  }
  return text;
}

}  // namespace fulcrum::app
