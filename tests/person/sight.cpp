#include "tests/person/sight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/person/blobs.h"

namespace fulcrum::person {
namespace {

// The colours of the overlay, engine/ui/theme.h.
constexpr std::array<Colour, 5> kColours{
    // blue, orange, green, violet, white
    {{84, 164, 255}, {255, 178, 54}, {66, 206, 138}, {226, 130, 255}, {236, 240, 245}}};
constexpr int kTolerance = 26;

// px, of the unit in which the overlay is drawn.
double unit_of(const Picture& picture) {
  return std::clamp(std::round(picture.height / 90.0) / 8.0, 0.75, 4.0);
}

struct Circle {
  Place middle;
  double radius = 0;
};

// Least squares, by Kasa: x^2 + y^2 + a x + b y + c = 0. The pixels are taken about their mean.
std::optional<Circle> circle_through(const std::vector<Place>& pixels) {
  if (pixels.size() < 8) return std::nullopt;
  Place mean;
  for (const Place& at : pixels) mean = mean + at;
  mean = mean * (1.0 / static_cast<double>(pixels.size()));
  double xx = 0, xy = 0, yy = 0, xr = 0, yr = 0, r = 0;
  for (const Place& at : pixels) {
    const Place from = at - mean;
    const double square = from.x * from.x + from.y * from.y;
    xx += from.x * from.x;
    xy += from.x * from.y;
    yy += from.y * from.y;
    xr += from.x * square;
    yr += from.y * square;
    r += square;
  }
  const double determinant = xx * yy - xy * xy;
  if (determinant < 1e-6 * xx * yy) return std::nullopt;
  const Place to{(xr * yy - yr * xy) / (2 * determinant), (yr * xx - xr * xy) / (2 * determinant)};
  return Circle{mean + to, std::sqrt(r / static_cast<double>(pixels.size()) + to.x * to.x + to.y * to.y)};
}

// Of each direction from the middle the pixel that is farthest: what is inside a ring, such as the checkpoint
// itself, may be as blue as the ring is.
std::vector<Place> outline(const Blob& blob) {
  constexpr std::size_t directions = 48;
  std::array<double, directions> farthest{};
  std::array<Place, directions> there;
  const Place middle = blob.middle();
  for (const Place& at : blob.pixels) {
    const Place from = at - middle;
    const double turn = std::atan2(from.y, from.x) / (2 * std::numbers::pi) + 0.5;
    const std::size_t i = std::min(directions - 1, static_cast<std::size_t>(directions * turn));
    if (length(from) < farthest[i]) continue;
    farthest[i] = length(from);
    there[i] = at;
  }
  std::vector<Place> pixels;
  for (std::size_t i = 0; i < directions; ++i)
    if (farthest[i] > 0) pixels.push_back(there[i]);
  return pixels;
}

// 0..1, of the directions from the middle, where the outline is the circle.
double part_round(const Circle& circle, const std::vector<Place>& pixels) {
  const auto on_it = [&](const Place& at) {
    return std::abs(length(at - circle.middle) - circle.radius) < 2;
  };
  return static_cast<double>(std::ranges::count_if(pixels, on_it)) / 48;
}

// The gauges at the lower left, whose scales are arcs of a size of their own and whose needles are blue and
// white.
bool is_in_gauges(const Picture& picture, const Place& at, double unit) {
  return at.x < 312 * unit && at.y > picture.height - 150 * unit;
}

// The column of panels at the right, whose sliders have knobs that look like the mark, and whose switches are
// wide and round.
bool is_in_panels(const Picture& picture, const Place& at, double unit) {
  return at.x > picture.width - 240 * unit && at.y < 420 * unit;
}

// Of a colour that which is most like a ring, whatever is drawn over a part of it. A gauge is none.
std::optional<Ring> find_ring(const Picture& picture, const std::vector<Blob>& found, double unit,
                              bool filling) {
  std::optional<Ring> ring;
  double best = 0.5;  // of the directions
  for (const Blob& blob : found) {
    const std::vector<Place> pixels = outline(blob);
    const std::optional<Circle> circle = circle_through(pixels);
    if (!circle || circle->radius < 9 * unit) continue;
    const bool is_wide = blob.width() > 1.3 * blob.height();
    if (is_wide && is_in_panels(picture, circle->middle, unit)) continue;
    if (is_in_gauges(picture, circle->middle, unit) && circle->radius > 30 * unit) continue;
    const double round = part_round(*circle, pixels);
    if (round < best) continue;
    best = round;
    ring = Ring{circle->middle, circle->radius, filling};
  }
  return ring;
}

// A small blue disc in a white one.
std::optional<Place> find_touch(const Picture& picture, const std::vector<Blob>& blue, double unit) {
  const auto white = [&](double x, double y) {
    const int px = static_cast<int>(std::lround(x)), py = static_cast<int>(std::lround(y));
    if (px < 0 || py < 0 || px >= picture.width || py >= picture.height) return false;
    const Colour seen = picture.at(px, py);
    return std::min({seen.red, seen.green, seen.blue}) > 130;
  };
  std::optional<Place> best;
  int most = 9;  // of 16
  for (const Blob& blob : blue) {
    if (std::max(blob.width(), blob.height()) > 8 * unit) continue;
    const Place middle = blob.middle();
    if (is_in_panels(picture, middle, unit) || is_in_gauges(picture, middle, unit)) continue;
    int around = 0;
    for (int i = 0; i < 16; ++i) {
      const double angle = i * std::numbers::pi / 8;
      around += white(middle.x + 3.6 * unit * std::cos(angle), middle.y + 3.6 * unit * std::sin(angle));
    }
    if (around <= most) continue;
    most = around;
    best = middle;
  }
  return best;
}

// From a foot at the touch point's height to a tip, which is its narrow end.
double find_farther(const std::vector<Blob>& violet, const Place& touch, double unit) {
  const auto arrow =
      std::ranges::max_element(violet, {}, [](const Blob& blob) { return blob.pixels.size(); });
  if (arrow == violet.end() || static_cast<double>(arrow->pixels.size()) < 20 * unit * unit) return 0;
  const auto width_at = [&](double y) {
    return std::ranges::count_if(arrow->pixels, [&](const Place& at) { return std::abs(at.y - y) < 1.5; });
  };
  const bool up = width_at(arrow->top) < width_at(arrow->bottom);
  // Where the tip is thinner than a pixel its colour is not seen.
  const double unseen = 1.5;
  return up ? touch.y - arrow->top + unseen : touch.y - arrow->bottom - unseen;
}

// A white arrow head near the picture's edge: its tip is the pixel that is farthest from the mean of all.
std::optional<Place> find_lost(const std::vector<Blob>& white, double unit) {
  for (const Blob& blob : white) {
    const auto count = static_cast<double>(blob.pixels.size());
    const double filled = count / (blob.width() * blob.height());
    const double size = std::sqrt(count);
    if (size < 12 * unit || size > 24 * unit || filled < 0.4 || filled > 0.65) continue;
    Place mean;
    for (const Place& at : blob.pixels) mean = mean + at * (1 / count);
    const auto from_mean = [&](const Place& at) { return length(at - mean); };
    const Place way = *std::ranges::max_element(blob.pixels, {}, from_mean) - mean;
    return way * (1 / length(way));
  }
  return std::nullopt;
}

// In the column of the list, at the left.
int count_done(const std::vector<Blob>& green, double unit) {
  return static_cast<int>(std::ranges::count_if(
      green,
      [&](const Blob& blob) {
        return std::abs(blob.middle().x - 39 * unit) < 4 * unit && blob.width() > 10 * unit &&
               blob.height() > 10 * unit && blob.width() < 18 * unit;
      }));
}

}  // namespace

Sight look_at(const Picture& picture) {
  const double unit = unit_of(picture);
  const std::vector<std::vector<Blob>> found = find_blobs(picture, kColours, kTolerance);
  const std::vector<Blob>&blue = found[0], &orange = found[1], &green = found[2], &violet = found[3],
        &white = found[4];
  Sight sight;
  sight.ring = find_ring(picture, blue, unit, false);
  if (!sight.ring) sight.ring = find_ring(picture, orange, unit, true);
  sight.touch = find_touch(picture, blue, unit);
  if (sight.touch) sight.farther = find_farther(violet, *sight.touch, unit);
  if (!sight.touch) sight.lost = find_lost(white, unit);
  sight.done = count_done(green, unit);
  return sight;
}

}  // namespace fulcrum::person
