#pragma once
// A small .glb, written by hand so that tests can break it on purpose.

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

namespace fulcrum::glb {

inline void put(std::vector<std::byte>& bytes, const void* data, std::size_t size) {
  const auto* from = static_cast<const std::byte*>(data);
  bytes.insert(bytes.end(), from, from + size);
}
inline void put_word(std::vector<std::byte>& bytes, std::uint32_t word) {
  put(bytes, &word, sizeof(word));
}

inline std::vector<std::byte> file(std::string json, std::vector<std::byte> buffer) {
  while (json.size() % 4 != 0) json += ' ';
  while (buffer.size() % 4 != 0) buffer.push_back(std::byte{0});
  std::vector<std::byte> bytes;
  put_word(bytes, 0x46546c67u);
  put_word(bytes, 2);
  put_word(bytes, static_cast<std::uint32_t>(28 + json.size() + buffer.size()));
  put_word(bytes, static_cast<std::uint32_t>(json.size()));
  put_word(bytes, 0x4e4f534au);
  put(bytes, json.data(), json.size());
  put_word(bytes, static_cast<std::uint32_t>(buffer.size()));
  put_word(bytes, 0x004e4942u);
  put(bytes, buffer.data(), buffer.size());
  return bytes;
}

// A tetrahedron with legs of 1 m: 4 vertices of 3 floats, then 12 indices of 16 bits.
struct Tetrahedron {
  std::vector<float> positions{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  std::vector<std::uint16_t> indices{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  std::string nodes = R"([{"name":"body","mesh":0}])";
  std::string scene = R"("scene":0,"scenes":[{"nodes":[0]}],)";
  std::string primitive = R"({"attributes":{"POSITION":0},"indices":1,"material":0})";
  std::string accessors =
      R"([{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,1]},)"
      R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}])";
  std::string views =
      R"([{"buffer":0,"byteOffset":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}])";
  std::string more = "";  // members of the top object, each followed by a comma
  std::string material = R"({"name":"steel","pbrMetallicRoughness":{"baseColorFactor":[0.1,0.2,0.3,1],)"
                         R"("metallicFactor":0.9,"roughnessFactor":0.25}})";
  std::vector<std::byte> appended;  // to the buffer, at 72

  std::vector<std::byte> bytes() const {
    std::vector<std::byte> buffer;
    put(buffer, positions.data(), positions.size() * sizeof(float));
    put(buffer, indices.data(), indices.size() * sizeof(std::uint16_t));
    buffer.insert(buffer.end(), appended.begin(), appended.end());
    const std::string json = R"({"asset":{"version":"2.0"},)" + more + scene + R"("nodes":)" + nodes +
                             R"(,"meshes":[{"primitives":[)" + primitive + R"(]}],"materials":[)" + material +
                             R"(],"accessors":)" + accessors + R"(,"bufferViews":)" + views +
                             R"(,"buffers":[{"byteLength":)" + std::to_string(buffer.size()) + "}]}";
    return file(json, buffer);
  }
};

}  // namespace fulcrum::glb
