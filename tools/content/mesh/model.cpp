#include "tools/content/mesh/model.h"

namespace fulcrum::content {

std::size_t triangle_count(const Model& model) {
  std::size_t count = 0;
  for (const Part& part : model.parts) count += part.solid.triangles.size();
  return count;
}

}  // namespace fulcrum::content
