#pragma once
// A model with lights of its own (KHR_lights_punctual) and pictures on its surfaces, as a .glb.

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "engine/render/visual_desc.h"
#include "tests/assets/glb_builder.h"

namespace fulcrum::test {

struct LitGlb {
  struct Part {
    render::Mesh mesh;
    glm::vec3 at{0.0F};    // m
    std::string material;  // JSON
  };
  std::vector<Part> parts;
  std::vector<std::string> lights;  // JSON of each
  std::vector<std::string> nodes;   // of each, what places it: members, each with a comma before it
  std::vector<std::vector<std::uint8_t>> pictures{};  // PNG or JPEG
  std::string textures{};                             // members "samplers" and "textures", a comma after each
  std::vector<std::string> extensions{};              // that materials and textures use

  std::string bytes() const {
    std::vector<std::byte> buffer;
    std::string views, accessors, meshes, materials, held, roots, shining;
    std::size_t views_there = 0;
    const auto add = [&](const auto& items, int target, const std::string& of) {
      const std::size_t size = items.size() * sizeof(items.front());
      append(views, R"({"buffer":0,"byteOffset":)" + std::to_string(buffer.size()) + R"(,"byteLength":)" +
                        std::to_string(size) + R"(,"target":)" + std::to_string(target) + "}");
      append(accessors, R"({"bufferView":)" + std::to_string(views_there++) + R"(,"count":)" +
                            std::to_string(items.size()) + of + "}");
      glb::put(buffer, items.data(), size);
    };
    for (const Part& part : parts) {
      glm::vec3 low = part.mesh.positions.front(), high = low;
      for (const glm::vec3& p : part.mesh.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
      }
      const std::string of = R"(,"componentType":5126,"type":"VEC3")", first = std::to_string(views_there);
      add(part.mesh.positions, 34962, of + R"(,"min":)" + triple(low) + R"(,"max":)" + triple(high));
      add(part.mesh.normals, 34962, of);
      std::string attributes =
          whole({R"("POSITION":)", first, R"(,"NORMAL":)", std::to_string(views_there - 1)});
      if (!part.mesh.uv.empty()) {
        for (const std::size_t set : {std::size_t{0}, std::size_t{1}}) {
          attributes += whole({R"(,"TEXCOORD_)", std::to_string(set), R"(":)", std::to_string(views_there)});
          add(coordinates(part.mesh, set), 34962, R"(,"componentType":5126,"type":"VEC2")");
        }
      }
      const std::string index = std::to_string(&part - parts.data()), indices = std::to_string(views_there);
      add(part.mesh.indices, 34963, R"(,"componentType":5125,"type":"SCALAR")");
      append(meshes, whole({R"({"primitives":[{"attributes":{)", attributes, R"(},"indices":)", indices,
                            R"(,"material":)", index, "}]}"}));
      append(materials, part.material);
      append(held, whole({R"({"name":"part )", index, R"(","mesh":)", index, R"(,"translation":)",
                          triple(part.at), "}"}));
      append(roots, index);
    }
    for (std::size_t i = 0; i < lights.size(); ++i) {
      append(shining, lights[i]);
      const std::string index = std::to_string(i);
      append(held, whole({R"({"name":"holder )", index, R"(","extensions":{"KHR_lights_punctual":{"light":)",
                          index, "}}", nodes[i], "}"}));
      append(roots, std::to_string(parts.size() + i));
    }
    std::string images;
    for (const std::vector<std::uint8_t>& picture : pictures) {
      append(images, whole({R"({"bufferView":)", std::to_string(views_there++), R"(,"mimeType":"image/)",
                            picture.front() == 0xff ? "jpeg" : "png", R"("})"}));
      append(views, whole({R"({"buffer":0,"byteOffset":)", std::to_string(buffer.size()), R"(,"byteLength":)",
                           std::to_string(picture.size()), "}"}));
      glb::put(buffer, picture.data(), picture.size());
    }
    const std::string pictured = pictures.empty() ? "" : whole({R"("images":[)", images, "],", textures});
    std::string used = lights.empty() ? "" : R"("KHR_lights_punctual")";
    for (const std::string& extension : extensions) append(used, "\"" + extension + "\"");
    const std::string lit =
        (used.empty() ? "" : R"("extensionsUsed":[)" + used + "],") +
        (lights.empty() ? "" : R"("extensions":{"KHR_lights_punctual":{"lights":[)" + shining + "]}},");
    const std::vector<std::byte> file =
        glb::file(R"({"asset":{"version":"2.0"},)" + lit + pictured + R"("scene":0,"scenes":[{"nodes":[)" +
                      roots + R"(]}],"nodes":[)" + held + R"(],"meshes":[)" + meshes + R"(],"materials":[)" +
                      materials + R"(],"accessors":[)" + accessors + R"(],"bufferViews":[)" + views +
                      R"(],"buffers":[{"byteLength":)" + std::to_string(buffer.size()) + "}]}",
                  buffer);
    return {reinterpret_cast<const char*>(file.data()), file.size()};
  }

private:
  static void append(std::string& list, const std::string& item) { list += (list.empty() ? "" : ",") + item; }
  static std::vector<glm::vec2> coordinates(const render::Mesh& mesh, std::size_t set) {
    std::vector<glm::vec2> uv;
    for (const glm::vec4& both : mesh.uv)
      uv.emplace_back(set == 0 ? both.x : both.z, set == 0 ? both.y : both.w);
    return uv;
  }
  static std::string whole(std::initializer_list<std::string_view> pieces) {
    std::string text;
    for (const std::string_view piece : pieces) text.append(piece);
    return text;
  }
  static std::string triple(const glm::vec3& v) {
    return "[" + std::to_string(v.x) + "," + std::to_string(v.y) + "," + std::to_string(v.z) + "]";
  }
};

}  // namespace fulcrum::test
