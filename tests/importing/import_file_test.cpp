// Meshes of other programs become models in metres with Y up. The truth is the shape that the file was
// written of: its size, its volume, which way is up; a torus has no corner that could be missed.

#include "engine/importing/import_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "engine/assets/gltf.h"
#include "engine/assets/gltf_writer.h"
#include "haptics/bake/mass_properties.h"
#include "tests/assets/glb_builder.h"
#include "tests/importing/mesh_files.h"

namespace fulcrum::importing::test {
namespace {

// 20 wide, 40 to the file's second axis, 30 to its third.
const Shape kBlock = box({0, 0, 0}, {20, 40, 30});

class ImportFile : public testing::Test {
protected:
  Imported read(const std::string& name, const std::string& bytes, const ImportOptions& options = {}) {
    auto imported = import_file(folder_.write(name, bytes), options);
    if (!imported) ADD_FAILURE() << imported.error().sentence;
    return imported ? std::move(*imported) : Imported{};
  }

  MeshFolder folder_;
};

double volume(const Model& model) {
  const auto solid = build_solid(to_triangle_mesh(model));
  if (!solid) ADD_FAILURE() << solid.error().sentence;
  return solid ? mass_properties(*solid).volume_m3 : 0;
}

TEST_F(ImportFile, TakesEachFormatAsItsUnitAndItsUpSay) {
  struct Case {
    const char* name;
    std::string bytes;
    Vec3 size_mm;
  };
  const Case cases[] = {
      {"block.obj", obj(kBlock), {20, 40, 30}},          // Y up
      {"block.stl", stl(kBlock), {20, 30, 40}},          // Z up
      {"block.ply", ply(kBlock), {20, 30, 40}},          // Z up
      {"block.3ds", max_3ds(kBlock, "b"), {20, 30, 40}}  // Z up, by its format
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    const Imported imported = read(c.name, c.bytes);
    EXPECT_LT((1e3 * imported.size - c.size_mm).norm(), 1e-4);
    EXPECT_NEAR(volume(imported.model), 24e-6, 1e-11) << "of its outside, not of its inside";
    EXPECT_EQ(imported.triangles, 12u);
    EXPECT_EQ(imported.why_not_solid, "");
    EXPECT_TRUE(imported.mended.empty());
    EXPECT_NE(imported.unit_m.why, "");
    EXPECT_NE(imported.up.why, "");
    // Sharp edges are drawn sharp: every corner has a normal along an axis.
    for (const ModelPart& part : imported.model.parts)
      for (const Vec3& normal : part.normals) EXPECT_NEAR(normal.cwiseAbs().maxCoeff(), 1, 1e-6);
  }
}

TEST_F(ImportFile, WhatIsGivenIsNotGuessed) {
  const Imported imported = read("block.obj", obj(kBlock, "# units: mm\n"),
                                 {.unit = LengthUnit::in, .up = UpAxis::z, .simplify = {}});
  EXPECT_LT((imported.size - 0.0254 * Vec3(20, 30, 40)).norm(), 1e-6);
  EXPECT_EQ(imported.unit_m.why, "");
  EXPECT_EQ(imported.up.why, "");
}

// What pointed up in the file does so in the model, and the outside stays outside.
TEST_F(ImportFile, TurnsWhatPointsUpAndMirrorsNothing) {
  Shape arrow = box({-1, -1, 0}, {1, 1, 10});
  for (auto& p : arrow.points)
    if (p.z() > 5) p.x() *= 0.1;  // it narrows along x towards the top
  const Imported imported = read("arrow.stl", stl(arrow), {.unit = LengthUnit::mm, .up = {}, .simplify = {}});
  double widest_x = 0, widest_z = 0, top = 0;
  for (const Vec3& p : imported.model.parts.at(0).positions) top = std::max(top, p.y());
  EXPECT_NEAR(top, 0.01, 1e-8);
  for (const Vec3& p : imported.model.parts.at(0).positions) {
    if (p.y() < 0.5 * top) continue;
    widest_x = std::max(widest_x, std::abs(p.x()));
    widest_z = std::max(widest_z, std::abs(p.z()));
  }
  EXPECT_NEAR(widest_x, 1e-4, 1e-8);
  EXPECT_NEAR(widest_z, 1e-3, 1e-8);
  EXPECT_GT(volume(imported.model), 0);
}

TEST_F(ImportFile, TheFilesOwnWordsAreTaken) {
  EXPECT_NEAR(read("a.obj", obj(kBlock, "# File units = centimeters\n")).size.x(), 0.2, 1e-7);
  EXPECT_NEAR(read("a.ply", ply(kBlock, "comment unit: inch\n")).size.x(), 20 * 0.0254, 1e-7);
  EXPECT_NEAR(read("a.stl", stl(kBlock, "UNITS=um, made by hand")).size.x(), 20e-6, 1e-12);
  EXPECT_NE(read("a.obj", obj(kBlock, "# File units = centimeters\n")).unit_m.why.find("centimeters"),
            std::string::npos);
}

TEST_F(ImportFile, SizesWithoutAWordAreThoseOfAHand) {
  EXPECT_EQ(read("a.obj", obj(box({0, 0, 0}, {0.1, 0.2, 0.3}))).unit_m.value, 1.0);
  EXPECT_EQ(read("a.obj", obj(box({0, 0, 0}, {100, 200, 300}))).unit_m.value, 1e-3);
  EXPECT_EQ(read("a.obj", obj(box({0, 0, 0}, {1e5, 2e5, 3e5}))).unit_m.value, 1e-6);
  EXPECT_EQ(read("a.obj", obj(kBlock)).question, "");
  EXPECT_NE(read("a.obj", obj(kBlock), {.unit = LengthUnit::m, .up = {}, .simplify = {}}).question, "");
  EXPECT_NE(read("a.obj", obj(box({0, 0, 0}, {1e-4, 1e-4, 1e-4}))).question, "");
}

TEST_F(ImportFile, NamesPartsAndColoursThem) {
  folder_.write("paint.mtl", "newmtl red\nKd 1 0 0.5\nmap_Kd wood.png\n");
  const Imported imported = read("two.obj", "mtllib paint.mtl\n" + obj(kBlock, "o block\nusemtl red\n"));
  ASSERT_EQ(imported.model.parts.size(), 1u);
  const ModelPart& part = imported.model.parts[0];
  EXPECT_EQ(part.name, "block");
  const ModelMaterial& material = imported.model.materials.at(part.material);
  EXPECT_EQ(material.name, "red");
  EXPECT_FLOAT_EQ(material.base_colour[0], 1);
  EXPECT_NEAR(material.base_colour[2], 0.2140, 1e-4) << "half of a screen's white is 0.214 of its light";
  EXPECT_EQ(imported.images, 1u);
  const Imported coloured = read("c.ply", ply(kBlock));
  ASSERT_EQ(coloured.model.parts.at(0).colours.size(), coloured.model.parts[0].positions.size());
  EXPECT_LT((coloured.model.parts[0].colours[0] - Vec3(1, 0.5029, 0)).norm(), 1e-3);
}

TEST_F(ImportFile, NamesWhatElseMaterialsHave) {
  using Names = std::vector<std::string>;
  folder_.write("paint.mtl",
                "newmtl lamp\nKd 1 1 1\nd 0.2\nKe 5 5 0\nKs 1 1 1\nNs 900\n"
                "newmtl plain\nKd 1 1 1\nKe 0 0 0\nd 1\n"
                "newmtl leaf\nKd 1 1 1\nmap_d leaf.png\n");
  const auto left_out = [&](const std::string& material) {
    return read("a.obj", "mtllib paint.mtl\n" + obj(kBlock, "usemtl " + material + "\n")).materials_left_out;
  };
  EXPECT_EQ(left_out("lamp"), (Names{"opacity", "emission", "shininess"}));
  EXPECT_EQ(left_out("plain"), Names{}) << "no part is made of the others";
  EXPECT_EQ(left_out("leaf"), Names{"opacity"});
  EXPECT_EQ(read("b.obj", obj(kBlock)).materials_left_out, Names{});
  EXPECT_EQ(read("b.stl", stl(kBlock)).materials_left_out, Names{});
  EXPECT_EQ(read("b.ply", ply(kBlock)).materials_left_out, Names{});
  EXPECT_EQ(read("b.3ds", max_3ds(kBlock, "b")).materials_left_out, Names{});
  glb::Tetrahedron file;
  file.material = R"({"alphaMode":"BLEND","emissiveFactor":[1,0,0],"extensions":{"KHR_materials_clearcoat":)"
                  R"({"clearcoatFactor":1}}})";
  const auto bytes = file.bytes();
  const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  EXPECT_EQ(read("c.glb", text).materials_left_out, (Names{"opacity", "emission", "clearcoat"}));
}

TEST_F(ImportFile, SaysWhatCannotBeTouched) {
  Shape open = kBlock;
  open.triangles.resize(10);
  EXPECT_NE(read("open.obj", obj(open)).why_not_solid.find("hole"), std::string::npos);
  Shape turned = kBlock;
  std::swap(turned.triangles[3][0], turned.triangles[3][1]);
  const Imported imported = read("turned.obj", obj(turned));
  EXPECT_EQ(imported.why_not_solid, "");
  ASSERT_EQ(imported.mended.size(), 1u);
  EXPECT_NE(imported.mended[0].find("1 triangle was wound against the rest"), std::string::npos);
}

TEST_F(ImportFile, CountsTrianglesThatAreTooThin) {
  Shape shape = kBlock;
  shape.points.emplace_back(10, 1e-4, 0);  // 0.1 um beside an edge of 20 mm
  const auto thin = static_cast<std::uint32_t>(shape.points.size() - 1);
  // Triangle 0 3 1 of the face z = 0 has that edge.
  shape.triangles.back() = {4, 7, 6};
  for (auto& t : shape.triangles)
    if (t == std::array<std::uint32_t, 3>{0, 3, 1}) t = {0, 3, thin};
  shape.triangles.push_back({thin, 3, 1});
  shape.triangles.push_back({0, thin, 1});
  EXPECT_EQ(read("thin.obj", obj(shape)).thin_triangles, 1u);
}

// From each point of a grid on the true torus to the surface that is drawn: no triangle of it is asked for.
TEST_F(ImportFile, WhatIsDrawnIsWithinTheTolerance) {
  const double ring = 20, tube = 3;
  const std::string file = stl(torus(ring, tube, 300, 80));
  std::size_t before = 48000;
  for (const double tolerance : {0.05e-3, 0.1e-3, 0.4e-3}) {
    SCOPED_TRACE(tolerance);
    const Imported imported =
        read("ring.stl", file, {.unit = LengthUnit::mm, .up = {}, .simplify = tolerance});
    EXPECT_EQ(imported.triangles, 48000u) << "what is felt stays";
    ASSERT_TRUE(imported.drawn);
    EXPECT_LT(imported.drawn_triangles, before);
    before = imported.drawn_triangles;
    EXPECT_LE(imported.drawn_deviation, tolerance);
    // Corners and middles of what is drawn lie on the torus, but for the tolerance and the file's own chords.
    const double chord = 1e-3 * tube * (1 - std::cos(std::numbers::pi / 80)) +
                         1e-3 * (ring + tube) * (1 - std::cos(std::numbers::pi / 300));
    const TriangleMesh mesh = to_triangle_mesh(*imported.drawn);
    double largest = 0;
    for (const Triangle& t : mesh.triangles) {
      const Vec3 middle = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3;
      const double out = std::hypot(middle.x(), middle.z()) - 1e-3 * ring;
      largest = std::max(largest, std::abs(std::hypot(out, middle.y()) - 1e-3 * tube));
    }
    EXPECT_LE(largest, tolerance + chord);
  }
}

// The model that a scenario loads is the one that was imported.
TEST_F(ImportFile, IsReadBackAsItWasWritten) {
  const Imported imported = read("c.ply", ply(kBlock));
  const std::string bytes = to_glb(imported.model, "c", "a test");
  const auto model = parse_glb(std::as_bytes(std::span(bytes)), "c.glb");
  ASSERT_TRUE(model) << model.error().sentence;
  ASSERT_EQ(model->parts.size(), 1u);
  const ModelPart &a = imported.model.parts[0], &b = model->parts[0];
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.indices, b.indices);
  ASSERT_EQ(a.positions.size(), b.positions.size());
  ASSERT_EQ(a.colours.size(), b.colours.size());
  for (std::size_t i = 0; i < a.positions.size(); ++i) {
    EXPECT_LT((a.positions[i] - b.positions[i]).norm(), 1e-8);
    EXPECT_LT((a.normals[i] - b.normals[i]).norm(), 1e-6);
    EXPECT_LT((a.colours[i] - b.colours[i]).norm(), 1e-6);
  }
}

TEST_F(ImportFile, RefusesWhatItCannotRead) {
  const auto why = [&](const std::string& name, const std::string& bytes) {
    const auto imported = import_file(folder_.write(name, bytes), {});
    return imported ? "read" : imported.error().sentence;
  };
  EXPECT_NE(import_file("/nowhere/a.obj", {}).error().sentence.find("No such file"), std::string::npos);
  EXPECT_NE(why("a.sldprt", "no mesh").find("export it as OBJ, STL"), std::string::npos);
  EXPECT_NE(why("a.obj", "").find("cannot be read"), std::string::npos);
  EXPECT_NE(why("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\n").find("cannot be read"), std::string::npos);
  EXPECT_NE(why("a.stl", stl(kBlock).substr(0, 300)).find("cannot be read"), std::string::npos);
  // A header without an end, after which the reader would ask for more for ever.
  EXPECT_NE(why("a.ply", "ply\nformat ascii 1.0\nelement vertex 8\nend_hea\n").find("ends before"),
            std::string::npos);
  EXPECT_NE(why("a.glb", "glTF").find("a.glb"), std::string::npos);
}

}  // namespace
}  // namespace fulcrum::importing::test
