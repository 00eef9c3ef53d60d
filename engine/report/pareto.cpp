#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/report/plot.h"

namespace fulcrum::report {

std::vector<Point> pareto_front(std::vector<Point> points) {
  std::erase_if(
      points, [](const Point& p) { return std::isnan(p.x) || std::isnan(p.y); });
  std::sort(points.begin(), points.end(),
            [](const Point& a, const Point& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<Point> front;
  double best = std::numeric_limits<double>::infinity();
  for (const Point& p : points) {
    if (p.y >= best) continue;
    best = p.y;
    front.push_back(p);
  }
  return front;
}

}  // namespace fulcrum::report
