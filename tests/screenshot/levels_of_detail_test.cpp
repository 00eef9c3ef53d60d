// Coarser triangles: how far they are off, that they have no gaps, and that a picture does not show them.

#include "engine/render/levels_of_detail.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <set>

#include "engine/render/renderer.h"
#include "test_scene.h"

namespace fulcrum::render {
namespace {

constexpr float kRadius = 0.08F;  // m

// A ball of 2 x 192 x 192 triangles, its halves of two colours.
Mesh fine_ball() {
  constexpr std::uint32_t kAround = 192, kDown = 193;
  Mesh mesh;
  mesh.name = "fine ball";
  mesh.positions.push_back({0.0F, kRadius, 0.0F});
  for (std::uint32_t i = 1; i < kDown; ++i)
    for (std::uint32_t j = 0; j < kAround; ++j) {
      const float polar = std::numbers::pi_v<float> * static_cast<float>(i) / kDown;
      const float azimuth = 2.0F * std::numbers::pi_v<float> * static_cast<float>(j) / kAround;
      mesh.positions.push_back(kRadius * glm::vec3(std::sin(polar) * std::cos(azimuth), std::cos(polar),
                                                   std::sin(polar) * std::sin(azimuth)));
    }
  mesh.positions.push_back({0.0F, -kRadius, 0.0F});
  for (const glm::vec3& p : mesh.positions) {
    mesh.normals.push_back(glm::normalize(p));
    mesh.colours.push_back(p.x < 0.0F ? glm::vec3(0.8F, 0.1F, 0.1F) : glm::vec3(0.1F, 0.2F, 0.8F));
  }
  const auto last = static_cast<std::uint32_t>(mesh.positions.size() - 1);
  const auto at = [](std::uint32_t i, std::uint32_t j) { return 1 + (i - 1) * kAround + j % kAround; };
  for (std::uint32_t j = 0; j < kAround; ++j) {
    for (const std::uint32_t v : {0U, at(1, j + 1), at(1, j)}) mesh.indices.push_back(v);
    for (const std::uint32_t v : {last, at(kDown - 1, j), at(kDown - 1, j + 1)}) mesh.indices.push_back(v);
    for (std::uint32_t i = 1; i + 1 < kDown; ++i)
      for (const std::uint32_t v :
           {at(i, j), at(i, j + 1), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)})
        mesh.indices.push_back(v);
  }
  return mesh;
}

// Triangles of each piece at the level that `choose` gives for it.
template <class Choose>
std::vector<std::uint32_t> chosen(const LevelsOfDetail& all, Choose choose) {
  std::vector<std::uint32_t> indices;
  for (std::size_t i = 0; i < all.pieces.size(); ++i) {
    const LevelsOfDetail::Level& level =
        all.pieces[i].levels[static_cast<std::size_t>(choose(i, all.pieces[i].levels.size()))];
    indices.insert(indices.end(), all.indices.begin() + level.first,
                   all.indices.begin() + level.first + level.count);
  }
  return indices;
}

// Every edge of a surface without a rim is run along once each way.
bool is_closed(const std::vector<std::uint32_t>& indices) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::size_t t = 0; t + 2 < indices.size(); t += 3)
    for (std::size_t i = 0; i < 3; ++i) ++edges[{indices[t + i], indices[t + (i + 1) % 3]}];
  return std::ranges::all_of(edges, [&edges](const auto& edge) {
    const auto back = edges.find({edge.first.second, edge.first.first});
    return edge.second == 1 && back != edges.end() && back->second == 1;
  });
}

TEST(LevelsOfDetail, TheFinestOfAllPiecesAreTheMesh) {
  const Mesh mesh = fine_ball();
  const LevelsOfDetail all = levels_of_detail(mesh);
  ASSERT_GT(all.pieces.size(), 1U);
  std::multiset<std::array<std::uint32_t, 3>> expected, found;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    expected.insert({mesh.indices[t], mesh.indices[t + 1], mesh.indices[t + 2]});
    found.insert({all.indices[t], all.indices[t + 1], all.indices[t + 2]});
  }
  EXPECT_EQ(found, expected);
  EXPECT_EQ(chosen(all, [](std::size_t, std::size_t) { return 0; }),
            std::vector<std::uint32_t>(
                all.indices.begin(), all.indices.begin() + static_cast<std::ptrdiff_t>(mesh.indices.size())));
}

TEST(LevelsOfDetail, AreFewerAndOffByMore) {
  const LevelsOfDetail all = levels_of_detail(fine_ball());
  for (const LevelsOfDetail::Piece& piece : all.pieces) {
    ASSERT_GE(piece.levels.size(), 4U);
    EXPECT_EQ(piece.levels.front().error, 0.0F);
    for (std::size_t i = 1; i < piece.levels.size(); ++i) {
      EXPECT_LT(4 * piece.levels[i].count, 3 * piece.levels[i - 1].count);
      EXPECT_GE(piece.levels[i].error, piece.levels[i - 1].error);
    }
    EXPECT_LT(8 * piece.levels.back().count, piece.levels.front().count);
  }
}

// Of a ball one knows where its surface is. What they say is a mean over the triangles round a vertex: in the
// worst place it is less than twice as much.
TEST(LevelsOfDetail, AreOffByLittleMoreThanTheySay) {
  const Mesh mesh = fine_ball();
  const LevelsOfDetail all = levels_of_detail(mesh);
  for (const LevelsOfDetail::Piece& piece : all.pieces)
    for (const LevelsOfDetail::Level& level : piece.levels) {
      float most = 0.0F;
      for (std::size_t t = level.first; t < level.first + level.count; t += 3) {
        const glm::vec3 a = mesh.positions[all.indices[t]], b = mesh.positions[all.indices[t + 1]],
                        c = mesh.positions[all.indices[t + 2]];
        EXPECT_GT(glm::dot(glm::cross(b - a, c - a), a), 0.0F) << "turned inside out";
        most = std::max(most, kRadius - glm::length((a + b + c) / 3.0F));
      }
      EXPECT_LT(most, 2.0F * level.error + 2e-4F * kRadius);
    }
}

TEST(LevelsOfDetail, PiecesMeetWithoutAGapWhateverTheirLevels) {
  const LevelsOfDetail all = levels_of_detail(fine_ball());
  EXPECT_TRUE(is_closed(chosen(
      all, [](std::size_t, std::size_t levels) { return levels - 1; })));
  EXPECT_TRUE(is_closed(chosen(all, [](std::size_t piece, std::size_t levels) { return piece % levels; })));
}

// Both layers of a wall without thickness: rims between pieces are of two layers there, as seams are.
TEST(LevelsOfDetail, PiecesOfTwoLayersMeetWithoutAGap) {
  Mesh mesh = fine_ball();
  const std::size_t count = mesh.positions.size(), corners = mesh.indices.size();
  for (std::size_t v = 0; v < count; ++v) {
    mesh.positions.push_back(mesh.positions[v]);
    mesh.normals.push_back(-mesh.normals[v]);
    mesh.colours.push_back(mesh.colours[v]);
  }
  for (std::size_t i = corners; i-- > 0;)
    mesh.indices.push_back(mesh.indices[i] + static_cast<std::uint32_t>(count));
  const LevelsOfDetail all = levels_of_detail(mesh);
  ASSERT_GT(all.pieces.size(), 4u);
  for (const std::size_t one : {0U, 1U})
    EXPECT_TRUE(is_closed(chosen(
        all, [one](std::size_t i, std::size_t n) { return i % 2 == one ? n - 1 : 0; })));
  EXPECT_TRUE(is_closed(chosen(all, [](std::size_t, std::size_t n) { return n - 1; })));
}

// m, how wide the widest triangle is across the line where two colours meet.
float widest_mixture(const Mesh& mesh, const LevelsOfDetail& all) {
  const std::vector<std::uint32_t> indices = chosen(all, [&all](std::size_t piece, std::size_t levels) {
    std::size_t level = 0;
    while (level + 1 < levels && all.pieces[piece].levels[level + 1].error < 0.01F * kRadius) ++level;
    return level;
  });
  float widest = 0.0F;
  for (std::size_t t = 0; t < indices.size(); t += 3) {
    const auto [low, high] = std::minmax(
        {mesh.positions[indices[t]].x, mesh.positions[indices[t + 1]].x, mesh.positions[indices[t + 2]].x});
    if (low < 0.0F && high >= 0.0F) widest = std::max(widest, high - low);
  }
  return widest;
}

// A triangle across would blur them.
TEST(LevelsOfDetail, ColoursStayWhereTheyAre) {
  Mesh mesh = fine_ball();
  const float coloured = widest_mixture(mesh, levels_of_detail(mesh));
  mesh.colours.clear();
  EXPECT_LT(2.0F * coloured, widest_mixture(mesh, levels_of_detail(mesh)));
}

TEST(LevelsOfDetail, AreTheSameEachTime) {
  const Mesh mesh = fine_ball();
  EXPECT_EQ(levels_of_detail(mesh).indices, levels_of_detail(mesh).indices);
}

// A round bar along z with flat ends, of which every edge is sharp: vertices at its two rims are there twice.
// 4 x 384 triangles.
Mesh bar() {
  constexpr std::uint32_t kAround = 384;
  Mesh mesh;
  mesh.name = "bar";
  const auto add = [&mesh](const glm::vec3& p, const glm::vec3& n) {
    mesh.positions.push_back(p);
    mesh.normals.push_back(n);
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
  };
  const auto turn = [&mesh](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    for (const std::uint32_t v : {a, b, c}) mesh.indices.push_back(v);
  };
  const std::uint32_t low_middle = add({0.0F, 0.0F, -kRadius}, {0.0F, 0.0F, -1.0F});
  const std::uint32_t high_middle = add({0.0F, 0.0F, kRadius}, {0.0F, 0.0F, 1.0F});
  std::vector<std::array<std::uint32_t, 4>> columns;  // end, side, side, end
  for (std::uint32_t i = 0; i < kAround; ++i) {
    const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / kAround;
    const glm::vec3 n(std::cos(angle), std::sin(angle), 0.0F);
    const glm::vec3 low = kRadius * n - glm::vec3(0, 0, kRadius),
                    high = kRadius * n + glm::vec3(0, 0, kRadius);
    columns.push_back({add(low, {0, 0, -1}), add(low, n), add(high, n), add(high, {0, 0, 1})});
  }
  for (std::uint32_t i = 0; i < kAround; ++i) {
    const auto& a = columns[i];
    const auto& b = columns[(i + 1) % kAround];
    turn(low_middle, b[0], a[0]);
    turn(a[1], b[1], b[2]), turn(a[1], b[2], a[2]);
    turn(high_middle, a[3], b[3]);
  }
  return mesh;
}

// The same corners by place: where two surfaces meet at a sharp edge, there are two at one.
std::vector<std::uint32_t> welded(const Mesh& mesh, std::vector<std::uint32_t> indices) {
  std::map<std::array<float, 3>, std::uint32_t> places;
  for (std::uint32_t& v : indices) {
    const glm::vec3& p = mesh.positions[v];
    v = places.try_emplace({p.x, p.y, p.z}, v).first->second;
  }
  return indices;
}

TEST(LevelsOfDetail, GoAlongSharpEdges) {
  const Mesh mesh = bar();
  const LevelsOfDetail all = levels_of_detail(mesh);
  ASSERT_EQ(all.pieces.size(), 1U);
  const LevelsOfDetail::Piece& piece = all.pieces.front();
  EXPECT_LT(8 * piece.levels.back().count, piece.levels.front().count);
  for (std::size_t level = 0; level < piece.levels.size(); ++level) {
    const std::vector<std::uint32_t> indices =
        chosen(all, [level](std::size_t, std::size_t) { return level; });
    EXPECT_TRUE(is_closed(welded(mesh, indices))) << level;
    float most = 0.0F;
    for (std::size_t t = 0; t < indices.size(); t += 3) {
      const glm::vec3 a = mesh.positions[indices[t]], b = mesh.positions[indices[t + 1]],
                      c = mesh.positions[indices[t + 2]];
      const glm::vec3 n = glm::normalize(glm::cross(b - a, c - a));
      // Each surface keeps its own normals: what was sharp is sharp.
      for (int i = 0; i < 3; ++i)
        EXPECT_GT(glm::dot(n, mesh.normals[indices[t + static_cast<std::size_t>(i)]]), 0.7F);
      for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
        if (std::abs(n.z) < 0.5F) most = std::max(most, kRadius - glm::length(glm::vec2(from + to) / 2.0F));
    }
    EXPECT_LT(most, 2.0F * piece.levels[level].error + 2e-4F * kRadius) << level;
  }
}

TEST(LevelsOfDetail, ALineOnAFlatSheetStaysWhereItIs) {
  // A sheet of which the part below a wave is of another colour, with vertices of both along it.
  constexpr std::uint32_t kColumns = 256, kRows = 12;
  Mesh mesh;
  mesh.name = "sheet";
  const auto line = [](float x) { return 0.004F * std::sin(60.0F * x); };
  for (const bool above : {false, true})
    for (std::uint32_t j = 0; j <= kRows; ++j)
      for (std::uint32_t i = 0; i <= kColumns; ++i) {
        const float x = 0.4F * static_cast<float>(i) / kColumns;
        const float part = static_cast<float>(j) / kRows;
        const float y = above ? std::lerp(line(x), 0.05F, part) : std::lerp(-0.05F, line(x), part);
        mesh.positions.push_back({x, j == (above ? 0 : kRows) ? line(x) : y, 0.0F});
        mesh.normals.push_back({0.0F, 0.0F, 1.0F});
        mesh.colours.push_back(above ? glm::vec3(0.8F, 0.1F, 0.1F) : glm::vec3(0.1F, 0.2F, 0.8F));
      }
  for (std::uint32_t half = 0; half < 2; ++half)
    for (std::uint32_t j = 0; j < kRows; ++j)
      for (std::uint32_t i = 0; i < kColumns; ++i) {
        const std::uint32_t a = (half * (kRows + 1) + j) * (kColumns + 1) + i, b = a + 1,
                            c = b + kColumns + 1, d = c - 1;
        for (const std::uint32_t v : {a, b, c, a, c, d}) mesh.indices.push_back(v);
      }
  const LevelsOfDetail all = levels_of_detail(mesh);
  ASSERT_EQ(all.pieces.size(), 1U);
  const auto& levels = all.pieces.front().levels;
  EXPECT_LT(8 * levels.back().count, levels.front().count);
  for (std::size_t level = 0; level < levels.size(); ++level) {
    const std::vector<std::uint32_t> indices =
        chosen(all, [level](std::size_t, std::size_t) { return level; });
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (std::size_t t = 0; t < indices.size(); t += 3)
      for (std::size_t i = 0; i < 3; ++i) edges.emplace(indices[t + i], indices[t + (i + 1) % 3]);
    float most = 0.0F;
    for (const auto& [v, w] : edges) {
      const glm::vec3 p = mesh.positions[v], q = mesh.positions[w];
      const bool is_on_line = std::abs(p.y - line(p.x)) < 1e-6F && std::abs(q.y - line(q.x)) < 1e-6F;
      if (!is_on_line || edges.contains({w, v})) continue;
      for (int k = 1; k < 8; ++k) {
        const glm::vec3 at = glm::mix(p, q, static_cast<float>(k) / 8.0F);
        most = std::max(most, std::abs(at.y - line(at.x)));
      }
    }
    EXPECT_LT(most, 2.0F * levels[level].error + 1e-5F) << level;
  }
}

// A place in a texture, of one on a sheet (m).
using Laid = glm::vec2 (*)(const glm::vec2&);
constexpr float kTiles = 10.0F;  // of a texture, 1/m

glm::vec2 evenly(const glm::vec2& p) {
  return kTiles * p;
}

// Pressed together and stretched by up to two thirds, in waves of 50 mm.
glm::vec2 in_waves(const glm::vec2& p) {
  constexpr float kWave = 2.0F * std::numbers::pi_v<float> / 0.05F;
  return kTiles * (p + 0.6F / kWave * glm::vec2(std::sin(kWave * p.y), std::sin(kWave * p.x)));
}

// A flat sheet of 0.2 x 0.2 m and 2 x 128 x 128 triangles.
Mesh laid_sheet(Laid first, Laid second) {
  constexpr std::uint32_t kSide = 129;
  Mesh mesh;
  mesh.name = "sheet";
  for (std::uint32_t j = 0; j < kSide; ++j)
    for (std::uint32_t i = 0; i < kSide; ++i) {
      const glm::vec2 p = 0.2F / (kSide - 1) * glm::vec2(i, j);
      mesh.positions.emplace_back(p, 0.0F);
      mesh.normals.emplace_back(0.0F, 0.0F, 1.0F);
      mesh.uv.emplace_back(first(p), second(p));
    }
  for (std::uint32_t j = 0; j + 1 < kSide; ++j)
    for (std::uint32_t i = 0; i + 1 < kSide; ++i) {
      const std::uint32_t a = j * kSide + i, b = a + 1, c = b + kSide, d = c - 1;
      for (const std::uint32_t v : {a, b, c, a, c, d}) mesh.indices.push_back(v);
    }
  return mesh;
}

// A vase about y, 0.2 m high, of 2 x 192 x 96 triangles: a texture goes twice round it and meets itself in
// a seam.
Mesh vase() {
  constexpr std::uint32_t kAround = 192, kUp = 96;
  Mesh mesh;
  mesh.name = "vase";
  for (std::uint32_t j = 0; j <= kUp; ++j)
    for (std::uint32_t i = 0; i <= kAround; ++i) {
      const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(i % kAround) / kAround;
      const float y = 0.2F * (static_cast<float>(j) / kUp - 0.5F);
      const float wave = 30.0F * y;
      const float radius = 0.05F + 0.015F * std::sin(wave), slope = 0.45F * std::cos(wave);
      const glm::vec3 out(std::sin(angle), 0.0F, std::cos(angle));
      mesh.positions.push_back(radius * out + glm::vec3(0.0F, y, 0.0F));
      mesh.normals.push_back(glm::normalize(out - glm::vec3(0.0F, slope, 0.0F)));
      mesh.uv.emplace_back(2.0F * static_cast<float>(i) / kAround, kTiles * y, 0.0F, 0.0F);
    }
  for (std::uint32_t j = 0; j < kUp; ++j)
    for (std::uint32_t i = 0; i < kAround; ++i) {
      const std::uint32_t a = j * (kAround + 1) + i, b = a + 1, c = b + kAround + 1, d = c - 1;
      for (const std::uint32_t v : {a, b, c, a, c, d}) mesh.indices.push_back(v);
    }
  return mesh;
}

double twice_area_in_texture(const Mesh& mesh, const std::vector<std::uint32_t>& indices, std::size_t t) {
  const glm::vec4 &a = mesh.uv[indices[t]], &b = mesh.uv[indices[t + 1]], &c = mesh.uv[indices[t + 2]];
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// A flat sheet could go to two triangles: what is laid on it in waves holds the others.
TEST(LevelsOfDetail, TexturesSlideByLittleMoreThanTheySay) {
  const Mesh mesh = laid_sheet(in_waves, evenly);
  const LevelsOfDetail all = levels_of_detail(mesh);
  for (const LevelsOfDetail::Piece& piece : all.pieces) {
    ASSERT_GE(piece.levels.size(), 4U);
    for (const LevelsOfDetail::Level& level : piece.levels) {
      float sum = 0.0F, most = 0.0F;
      for (std::size_t t = level.first; t < level.first + level.count; t += 3) {
        EXPECT_GT(twice_area_in_texture(mesh, all.indices, t), 0.0) << "folded over";
        const std::uint32_t a = all.indices[t], b = all.indices[t + 1], c = all.indices[t + 2];
        const glm::vec2 middle((mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3.0F);
        const glm::vec2 shown((mesh.uv[a] + mesh.uv[b] + mesh.uv[c]) / 3.0F);
        const float off = glm::length(shown - in_waves(middle)) / kTiles;
        most = std::max(most, off);
        sum += off;
      }
      // Where it is stretched the most it slides by half as much again as in the mean.
      EXPECT_LT(3.0F * sum / static_cast<float>(level.count), 1.5F * level.error + 3e-5F);
      EXPECT_LT(most, 4.0F * level.error + 1e-4F);
    }
  }
}

TEST(LevelsOfDetail, OnlyTexturesThatAreReadHoldTriangles) {
  const Mesh mesh = laid_sheet(evenly, in_waves);
  const auto coarsest = [&mesh](const UvSets& read) {
    std::uint32_t count = 0;
    const LevelsOfDetail all = levels_of_detail(mesh, read);
    for (const LevelsOfDetail::Piece& piece : all.pieces) {
      std::size_t level = 0;
      while (level + 1 < piece.levels.size() && piece.levels[level + 1].error < 2e-4F) ++level;
      count += piece.levels[level].count;
    }
    return count;
  };
  const auto both = static_cast<double>(coarsest({true, true}));
  EXPECT_LT(3.0 * coarsest({true, false}), both);
  EXPECT_NEAR(coarsest({false, true}), both, 0.02 * both);
  Mesh bare = mesh;
  bare.uv.clear();
  EXPECT_EQ(levels_of_detail(mesh, {false, false}).indices, levels_of_detail(bare).indices);
}

TEST(LevelsOfDetail, ASeamOfATextureIsNotCrossed) {
  const Mesh mesh = vase();
  const LevelsOfDetail all = levels_of_detail(mesh);
  std::size_t deepest = 0;
  for (const LevelsOfDetail::Piece& piece : all.pieces) {
    EXPECT_LT(8 * piece.levels.back().count, piece.levels.front().count);
    deepest = std::max(deepest, piece.levels.size());
  }
  for (std::size_t level = 0; level < deepest; ++level) {
    const std::vector<std::uint32_t> indices =
        chosen(all, [level](std::size_t, std::size_t levels) { return std::min(level, levels - 1); });
    for (std::size_t t = 0; t < indices.size(); t += 3)
      EXPECT_GT(twice_area_in_texture(mesh, indices, t), 0.0) << level;
    // Where both sides of the seam meet no gap opens: what has no neighbour is at the upper or lower rim.
    const std::vector<std::uint32_t> places = welded(mesh, indices);
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (std::size_t t = 0; t < places.size(); t += 3)
      for (std::size_t i = 0; i < 3; ++i) edges.emplace(places[t + i], places[t + (i + 1) % 3]);
    for (const auto& [v, w] : edges)
      if (!edges.contains({w, v})) {
        EXPECT_NEAR(std::abs(mesh.positions[v].y), 0.1F, 1e-6F) << level;
        EXPECT_NEAR(std::abs(mesh.positions[w].y), 0.1F, 1e-6F) << level;
      }
  }
}

class DrawnLevels : public testing::Test {
protected:
  void TearDown() override {
    for (const std::string& message : gpu_.instance.messages()) ADD_FAILURE() << message;
  }

  Picture draw(const VisualDesc& desc, float coarseness) {
    auto made = Renderer::create(*gpu_.device, desc, {{320, 180}, {1, 512, 1.0F, coarseness}, {}});
    if (!made) throw std::runtime_error(made.error().sentence);
    FrameState state;
    state.camera = desc.camera;
    const std::optional<Error> error = (*made)->frame(state);
    EXPECT_FALSE(error) << error->sentence;
    triangles_ = (*made)->triangles();
    return *(*made)->read_back();
  }

  static VisualDesc scene() {
    VisualDesc desc;
    desc.meshes.push_back(fine_ball());
    desc.meshes.front().levels = levels_of_detail(desc.meshes.front());
    desc.materials.push_back({});
    desc.instances.push_back({});
    desc.camera = {{0.1F, 0.15F, 0.5F}, {0.0F, 0.0F, 0.0F}, 0.5F};
    return desc;
  }

  test::Gpu gpu_ = test::make_gpu();
  std::uint64_t triangles_ = 0;  // of the last picture
};

// Of 255 levels: how much two pictures differ, and the share of pixels that do so by more than 24.
struct Off {
  double mean = 0.0, clearly = 0.0;
};

Off off_by(const Picture& fine, const Picture& coarse) {
  std::size_t clearly = 0, sum = 0;
  for (std::size_t i = 0; i < fine.rgba.size(); i += 4) {
    const int off =
        std::max({std::abs(fine.rgba[i] - coarse.rgba[i]), std::abs(fine.rgba[i + 1] - coarse.rgba[i + 1]),
                  std::abs(fine.rgba[i + 2] - coarse.rgba[i + 2])});
    sum += static_cast<std::size_t>(off);
    clearly += off > 24 ? 1 : 0;
  }
  const auto pixels = static_cast<double>(fine.rgba.size() / 4);
  return {static_cast<double>(sum) / pixels, static_cast<double>(clearly) / pixels};
}

TEST_F(DrawnLevels, HardlyShow) {
  const VisualDesc desc = scene();
  const Picture fine = draw(desc, 0.0F);
  const std::uint64_t all = triangles_;
  const Off off = off_by(fine, draw(desc, 0.5F));
  EXPECT_LT(4 * triangles_, all);
  EXPECT_LT(off.mean, 0.5);
  EXPECT_LT(off.clearly, 0.01);  // where the colours meet and at the outline, one sample is there or not
}

// Stripes lie where they lay, within half a pixel, round a vase that has a seam before the camera.
TEST_F(DrawnLevels, OfATexturedSurfaceHardlyShow) {
  VisualDesc desc = scene();
  desc.meshes = {vase()};
  desc.meshes.front().levels = levels_of_detail(desc.meshes.front(), {true, false});
  Texture stripes{"stripes", 64, 64, {}, false, false};
  for (std::uint32_t row = 0; row < 64; ++row)
    for (std::uint32_t column = 0; column < 64; ++column) {
      const auto value = static_cast<std::uint8_t>((row / 16 + column / 16) % 2 == 0 ? 220 : 60);
      stripes.rgba.insert(stripes.rgba.end(), {value, value, value, 255});
    }
  desc.textures.push_back(stripes);
  SurfaceDetail& detail = desc.materials.front().detail.emplace();
  detail.layers[SurfaceDetail::base_colour] = TextureLayer{};
  const Picture fine = draw(desc, 0.0F);
  const std::uint64_t all = triangles_;
  const Off off = off_by(fine, draw(desc, 0.5F));
  EXPECT_LT(3 * triangles_, all);
  EXPECT_LT(off.mean, 1.0);
  EXPECT_LT(off.clearly, 0.02);  // at edges of stripes, where half a pixel is half of their difference
}

TEST_F(DrawnLevels, AreCoarserFarAway) {
  VisualDesc desc = scene();
  draw(desc, 0.1F);
  const std::uint64_t near = triangles_;
  desc.camera.eye *= 8.0F;
  draw(desc, 0.1F);
  EXPECT_LT(2 * triangles_, near);
}

TEST_F(DrawnLevels, AnInstanceThatIsLargerIsFiner) {
  VisualDesc desc = scene();
  desc.camera.eye *= 16.0F;
  draw(desc, 0.25F);
  const std::uint64_t small = triangles_;
  desc.instances.front().X_WM = glm::mat4(glm::mat3(60.0F));
  draw(desc, 0.25F);
  EXPECT_GT(triangles_, 2 * small);
}

TEST_F(DrawnLevels, WhatIsBesideTheViewIsLeftOut) {
  VisualDesc desc = scene();
  desc.key_light->casts_shadow = false;
  draw(desc, 0.0F);
  EXPECT_EQ(triangles_, desc.meshes.front().indices.size() / 3);
  desc.camera.target = {2.0F, 0.0F, 0.5F};
  draw(desc, 0.0F);
  EXPECT_EQ(triangles_, 0U);
}

}  // namespace
}  // namespace fulcrum::render
