#pragma once
// The simplest model there is, as a file.

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <utility>

namespace fulcrum::scenario::test {

// A box from `low` to `high` as a .glb with one part, "box", of one material, "steel". Faulty: one triangle
// is wound the wrong way.
inline std::string box_glb(const Eigen::Vector3f& low, const Eigen::Vector3f& high, bool faulty = false) {
  std::string binary;
  const auto put = [&binary](const void* data, std::size_t size) {
    binary.append(static_cast<const char*>(data), size);
  };
  for (int corner = 0; corner < 8; ++corner)
    for (int axis = 0; axis < 3; ++axis) put(corner >> axis & 1 ? &high[axis] : &low[axis], 4);
  std::uint16_t indices[36] = {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                               2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};
  if (faulty) std::swap(indices[0], indices[1]);
  put(indices, sizeof indices);
  const auto vector = [](const Eigen::Vector3f& v) {
    return "[" + std::to_string(v.x()) + "," + std::to_string(v.y()) + "," + std::to_string(v.z()) + "]";
  };
  std::string json =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"name":"box"}],)"
      R"("materials":[{"name":"steel","pbrMetallicRoughness":{"metallicFactor":1.0}}],)"
      R"("meshes":[{"name":"box","primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0}]}],)"
      R"("buffers":[{"byteLength":168}],"bufferViews":[{"buffer":0,"byteLength":96},)"
      R"({"buffer":0,"byteOffset":96,"byteLength":72}],"accessors":[{"bufferView":0,)"
      R"("componentType":5126,"count":8,"type":"VEC3","min":)" +
      vector(low) + ",\"max\":" + vector(high) +
      R"(},{"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}]})";
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string glb;
  const auto word = [&glb](std::size_t value) {
    const auto bits = static_cast<std::uint32_t>(value);
    glb.append(reinterpret_cast<const char*>(&bits), 4);
  };
  glb = "glTF";
  word(2);
  word(12 + 8 + json.size() + 8 + binary.size());
  word(json.size());
  glb += "JSON" + json;
  word(binary.size());
  glb += std::string("BIN\0", 4) + binary;
  return glb;
}

}  // namespace fulcrum::scenario::test
