#include "engine/analysis/picture/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "engine/analysis/picture/colour.h"

namespace fulcrum::analysis::picture {
namespace {

constexpr double kPi = std::numbers::pi;
using Rgb = std::array<float, 3>;
constexpr Rgb kBlack{0, 0, 0}, kWhite{1, 1, 1}, kGreen{0, 1, 0}, kBlue{0, 0, 1};

Image drawn(std::size_t width, std::size_t height,
            const std::function<Rgb(std::size_t, std::size_t)>& pixel) {
  Image image{width, height, {}};
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x) image.pixels.push_back(pixel(x, y));
  return image;
}

Image plain(const Rgb& colour, std::size_t side = 8) {
  return drawn(
      side, side, [&](std::size_t, std::size_t) { return colour; });
}

// Colours everywhere, with edges and points.
Image pattern(double phase) {
  return drawn(
      24, 17,
      [&](std::size_t x, std::size_t y) {
        const auto wave = [&](double fx, double fy) {
          return static_cast<float>(
              0.5 + 0.5 * std::sin(fx * static_cast<double>(x) + fy * static_cast<double>(y) + phase));
        };
        if (x == 6 && y == 5) return kWhite;
        if (x > 15 && y > 8) return Rgb{0.1F, 0.1F, static_cast<float>(0.5 + 0.3 * phase)};
        return Rgb{wave(0.5, 0.1), wave(-0.2, 0.7), wave(0.9, 0.9)};
      });
}

using Map = std::vector<double>;
using Kernel = std::function<double(int, int)>;

// As the paper has it, with kernels of two dimensions, written apart from what is tested.
class ByTheBook {
public:
  ByTheBook(const Image& image, double ppd)
      : w_(static_cast<int>(image.width)), h_(static_cast<int>(image.height)), ppd_(ppd) {}

  struct Half {
    std::vector<Vec3> colours;
    Map edges, points;
  };
  Half half(const Image& image) const {
    Map c[3], light;
    for (const Rgb& pixel : image.pixels) {
      const Vec3 opponent = opponent_of({decoded(pixel[0]), decoded(pixel[1]), decoded(pixel[2])});
      for (int i = 0; i < 3; ++i) c[i].push_back(opponent[i]);
      light.push_back((opponent.x() + 16) / 116);
    }
    c[0] = seen(c[0], 1, 0.0047, 0, 1e-5);
    c[1] = seen(c[1], 1, 0.0053, 0, 1e-5);
    c[2] = seen(c[2], 34.1, 0.04, 13.5, 0.025);
    Half out;
    for (std::size_t i = 0; i < c[0].size(); ++i) {
      const Vec3 lab = lab_of(linear_of({c[0][i], c[1][i], c[2][i]}).cwiseMax(0).cwiseMin(1));
      out.colours.push_back({lab.x(), lab.x() * lab.y() / 100, lab.x() * lab.z() / 100});
    }
    for (const bool edge : {true, false}) {
      const Map x = features(light, edge, false), y = features(light, edge, true);
      for (std::size_t i = 0; i < x.size(); ++i)
        (edge ? out.edges : out.points).push_back(std::hypot(x[i], y[i]));
    }
    return out;
  }

private:
  Map convolved(const Map& map, int r, const Kernel& weight) const {
    Map out;
    for (int y = 0; y < h_; ++y)
      for (int x = 0; x < w_; ++x) {
        double sum = 0;
        for (int j = -r; j <= r; ++j)
          for (int i = -r; i <= r; ++i) sum += weight(i, j) * map[at(x + i, y + j)];
        out.push_back(sum);
      }
    return out;
  }

  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(std::clamp(y, 0, h_ - 1) * w_ + std::clamp(x, 0, w_ - 1));
  }

  Map seen(const Map& map, double a1, double b1, double a2, double b2) const {
    const int r = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * kPi * kPi)) * ppd_));
    const auto raw = [=, this](int i, int j) {
      const double z = (i * i + j * j) / (ppd_ * ppd_);
      return a1 * std::sqrt(kPi / b1) * std::exp(-kPi * kPi * z / b1) +
             a2 * std::sqrt(kPi / b2) * std::exp(-kPi * kPi * z / b2);
    };
    double sum = 0;
    for (int j = -r; j <= r; ++j)
      for (int i = -r; i <= r; ++i) sum += raw(i, j);
    return convolved(map, r, [=](int i, int j) { return raw(i, j) / sum; });
  }

  Map features(const Map& map, bool edge, bool flipped) const {
    const double sd = 0.5 * 0.082 * ppd_;
    const int r = static_cast<int>(std::ceil(3 * sd));
    const auto raw = [=](int i, int j) {
      const double along = flipped ? j : i;
      return (edge ? -along : along * along / (sd * sd) - 1) * std::exp(-(i * i + j * j) / (2 * sd * sd));
    };
    double above = 0, below = 0;
    for (int j = -r; j <= r; ++j)
      for (int i = -r; i <= r; ++i) (raw(i, j) > 0 ? above : below) += std::abs(raw(i, j));
    return convolved(map, r, [=](int i, int j) { return raw(i, j) / (raw(i, j) > 0 ? above : below); });
  }

  int w_, h_;
  double ppd_;
};

std::vector<double> flip_by_the_book(const Image& reference, const Image& test, double ppd) {
  const ByTheBook book(reference, ppd);
  const ByTheBook::Half a = book.half(reference), b = book.half(test);
  const auto hyab = [](const Vec3& p, const Vec3& q) {
    return std::abs(p.x() - q.x()) + std::hypot(p.y() - q.y(), p.z() - q.z());
  };
  const Vec3 green = lab_of({0, 1, 0}), blue = lab_of({0, 0, 1});
  const auto hunt = [](const Vec3& lab) {
    return Vec3(lab.x(), 0.01 * lab.x() * lab.y(), 0.01 * lab.x() * lab.z());
  };
  const double most = std::pow(hyab(hunt(green), hunt(blue)), 0.7);
  Map out;
  for (std::size_t i = 0; i < a.colours.size(); ++i) {
    const double c = std::pow(hyab(a.colours[i], b.colours[i]), 0.7);
    const double share =
        c < 0.4 * most ? 0.95 / (0.4 * most) * c : 0.95 + (c - 0.4 * most) / (0.6 * most) * 0.05;
    const double f = std::max(std::abs(a.edges[i] - b.edges[i]), std::abs(a.points[i] - b.points[i]));
    out.push_back(std::pow(share, 1 - std::pow(f / std::sqrt(2.0), 0.5)));
  }
  return out;
}

double mean(const std::vector<double>& map) {
  double sum = 0;
  for (const double value : map) sum += value;
  return sum / static_cast<double>(map.size());
}

// CIE L*a*b* of the primaries of sRGB under D65, as published (B. Lindbloom, brucelindbloom.com).
TEST(Flip, KnowsTheColoursOfAScreen) {
  const auto expect = [](const Vec3& linear, const Vec3& lab) {
    EXPECT_LT((lab_of(linear) - lab).norm(), 0.06) << lab_of(linear).transpose();
  };
  expect({1, 0, 0}, {53.24, 80.09, 67.20});
  expect({0, 1, 0}, {87.73, -86.18, 83.18});
  expect({0, 0, 1}, {32.30, 79.19, -107.86});
  expect({1, 1, 1}, {100, 0, 0});
  expect({0, 0, 0}, {0, 0, 0});
  EXPECT_NEAR(luminance({1, 1, 1}), 1, 1e-12);
  EXPECT_NEAR(luminance({0, 1, 0}), 0.7152, 1e-4);
  const Vec3 some(0.2, 0.7, 0.4);
  EXPECT_LT((linear_of(opponent_of(some)) - some).norm(), 1e-12);
}

TEST(Flip, OfTheSamePictureIsZero) {
  for (const double difference : flip(pattern(0.3), pattern(0.3))) EXPECT_EQ(difference, 0);
}

// Nothing to filter and no feature: the formulas alone. The largest difference is 1 by its definition.
TEST(Flip, OfPlainPicturesIsWhatTheFormulasSay) {
  for (const double difference : flip(plain(kGreen), plain(kBlue))) EXPECT_NEAR(difference, 1, 1e-9);
  // Black and white are 100 apart, green and blue 203.3.
  const double share = std::pow(100 / 203.3, 0.7);
  for (const double difference : flip(plain(kBlack), plain(kWhite)))
    EXPECT_NEAR(difference, 0.95 + 0.05 * (share - 0.4) / 0.6, 1e-4);
  // L* 50 is 0.4663 on a screen.
  for (const double difference : flip(plain(kBlack), plain({0.4663F, 0.4663F, 0.4663F})))
    EXPECT_NEAR(difference, 0.95 * std::pow(50 / 203.3, 0.7) / 0.4, 1e-3);
}

TEST(Flip, IsThePapersOnAnyPicture) {
  for (const double ppd : {kPixelsPerDegree, 30.0}) {
    const std::vector<double> ours = flip(pattern(0), pattern(0.7), ppd);
    const std::vector<double> theirs = flip_by_the_book(pattern(0), pattern(0.7), ppd);
    ASSERT_EQ(ours.size(), theirs.size());
    for (std::size_t i = 0; i < ours.size(); ++i) EXPECT_NEAR(ours[i], theirs[i], 1e-9) << i;
    EXPECT_GT(mean(ours), 0.1);
  }
}

TEST(Flip, IsTheSameForSwappedTurnedAndMirroredPictures) {
  const Image a = pattern(0), b = pattern(0.7);
  const std::vector<double> one = flip(a, b), other = flip(b, a);
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_NEAR(one[i], other[i], 1e-12);
  const auto transposed = [](const Image& image) {
    return drawn(
        image.height, image.width,
        [&](std::size_t x, std::size_t y) { return image.pixels[x * image.width + y]; });
  };
  const auto mirrored = [](const Image& image) {
    return drawn(image.width, image.height, [&](std::size_t x, std::size_t y) {
      return image.pixels[y * image.width + image.width - 1 - x];
    });
  };
  EXPECT_NEAR(mean(flip(transposed(a), transposed(b))), mean(one), 1e-12);
  EXPECT_NEAR(mean(flip(mirrored(a), mirrored(b))), mean(one), 1e-12);
}

TEST(Flip, StaysBetweenNothingAndAll) {
  for (const double difference : flip(pattern(0), pattern(3))) {
    EXPECT_GE(difference, 0);
    EXPECT_LE(difference, 1);
  }
}

// An edge that moved is seen where it was and is, and more the farther it went; one pixel of grey that is a
// little off is not.
TEST(Flip, SeesAnEdgeThatMoved) {
  const auto edge = [](std::size_t at) {
    return drawn(64, 32, [=](std::size_t x, std::size_t) {
      return x < at ? Rgb{0.2F, 0.2F, 0.2F} : Rgb{0.8F, 0.8F, 0.8F};
    });
  };
  const std::vector<double> by_one = flip(edge(32), edge(33)), by_four = flip(edge(32), edge(36));
  EXPECT_GT(by_one[16 * 64 + 32], 0.2);
  EXPECT_LT(by_one[16 * 64 + 4], 1e-9);
  EXPECT_LT(by_one[16 * 64 + 60], 1e-9);
  EXPECT_GT(mean(by_four), 2 * mean(by_one));
}

// What is too fine for an eye at that distance is one grey, whichever of the two is dark.
TEST(Flip, OverlooksWhatIsTooFine) {
  const auto checks = [](std::size_t odd) {
    return drawn(48, 48, [=](std::size_t x, std::size_t y) {
      return (x + y + odd) % 2 == 0 ? Rgb{0.45F, 0.45F, 0.45F} : Rgb{0.55F, 0.55F, 0.55F};
    });
  };
  const std::size_t middle = 24 * 48 + 24;
  EXPECT_LT(flip(checks(0), checks(1), 120.0)[middle], 0.02);
  EXPECT_GT(flip(checks(0), checks(1), 10.0)[middle], 0.1);
}

}  // namespace
}  // namespace fulcrum::analysis::picture
