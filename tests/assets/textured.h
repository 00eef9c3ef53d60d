#pragma once
// A .glb with a texture, for tests to say of it what they like.

#include <stdexcept>
#include <string>

#include "engine/assets/gltf.h"
#include "tests/assets/glb_builder.h"
#include "tests/assets/pictures.h"

namespace fulcrum::test {

// A tetrahedron with coordinates, a picture in the buffer and that material.
struct Textured {
  glb::Tetrahedron file;
  std::vector<std::uint8_t> png = test::png_of(1, 1, PNG_FORMAT_RGB, {1, 2, 3});

  explicit Textured(const std::string& material, const std::string& more = "") {
    const std::vector<float> uv{0, 0, 1, 0, 0, 1, 0.5F, 0.25F};
    glb::put(file.appended, uv.data(), 32);
    glb::put(file.appended, png.data(), png.size());
    file.primitive = R"({"attributes":{"POSITION":0,"TEXCOORD_0":2},"indices":1,"material":0})";
    file.accessors.insert(file.accessors.size() - 1,
                          R"(,{"bufferView":2,"componentType":5126,"count":4,"type":"VEC2"})");
    file.views.insert(file.views.size() - 1, R"(,{"buffer":0,"byteOffset":72,"byteLength":32},{"buffer":0,)"
                                             R"("byteOffset":104,"byteLength":)" +
                                                 std::to_string(png.size()) + "}");
    file.material = material;
    file.more = R"("images":[{"bufferView":3,"mimeType":"image/png","name":"grain"}],)" +
                (more.empty() ? R"("samplers":[{"wrapS":33071,"wrapT":33648,"magFilter":9728}],)"
                                R"("textures":[{"source":0,"sampler":0}],)"
                              : more);
  }

  Model read() const {
    auto model = parse_glb(file.bytes(), "a.glb");
    if (!model) throw std::runtime_error(model.error().sentence);
    return std::move(*model);
  }
};

}  // namespace fulcrum::test
