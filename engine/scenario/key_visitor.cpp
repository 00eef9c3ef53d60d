#include "engine/scenario/key_visitor.h"

#include "engine/scenario/to_glm.h"
#include "engine/scenario/words.h"

namespace fulcrum::scenario {

namespace {

Vec3 widened(const glm::vec3& v) {
  return {scenario::widened(v.x), scenario::widened(v.y), scenario::widened(v.z)};
}

}  // namespace

void KeyVisitor::real(const Key& key, float& value, const Range& range) {
  double wide = scenario::widened(value);
  number(key, wide, range);
  value = static_cast<float>(wide);
}

void KeyVisitor::vector(const Key& key, glm::vec3& value, const Range& each) {
  Vec3 wide = widened(value);
  vector(key, wide, each);
  value = narrowed(wide);
}

void KeyVisitor::colour(const Key& key, glm::vec3& value) {
  Vec3 wide = widened(value);
  colour(key, wide);
  value = narrowed(wide);
}

void describe_pose(KeyVisitor& visitor, Pose& pose, std::string_view position_doc,
                   std::string_view orientation_doc) {
  visitor.vector({"position", "m", position_doc}, pose.p, kPosition);
  visitor.rotation({"orientation", "", orientation_doc}, pose.q);
}

}  // namespace fulcrum::scenario
