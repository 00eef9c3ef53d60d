#pragma once
// A plot as plain data: curves, points and filled cells over two axes.

#include <string>
#include <vector>

#include "engine/report/axis.h"

namespace fulcrum::report {

struct Point {
  double x = 0, y = 0;  // in the units of the axes
};

// Colours that people tell apart whichever way they see colour, in light and in dark: kHues of them, then
// again from the first. M. Okabe, K. Ito, "Color universal design", 2008.
inline constexpr int kHues = 7;
inline constexpr int kInk = -1;  // the colour of the text

enum class Line { none, solid, dashed, dotted };
enum class Marker { none, circle, square, triangle, diamond, cross };

struct Series {
  std::string name;           // in the legend; empty: not there
  std::vector<Point> points;  // one that an axis cannot show interrupts the line
  Line line = Line::solid;
  Marker marker = Marker::none;
  int hue = 0;          // 0 to kHues - 1, or kInk
  bool strong = false;  // drawn wider: a front, a limit
  bool faint = false;   // drawn thin and pale: one of many
};

// Of a filled cell: -4 (cool, deep) over 0 (neutral) to 4 (warm, deep).
inline constexpr int kDeepestShade = 4;

struct Band {
  std::string name;  // what the cells of this shade have in common; empty: not in the legend
  int shade = 0;
};

// A heat map. Cell (i, j) lies between x_edges[i], x_edges[i + 1] and y_edges[j], y_edges[j + 1].
struct Cells {
  std::vector<double> x_edges, y_edges;  // (n + 1), (m + 1), rising
  std::vector<int> band;                 // (m x n), row j by row: index into bands; -1: left empty
  std::vector<Band> bands;
};

enum class Side { right, left, above, below };

// A word at a place in the plot.
struct Label {
  Point at;
  std::string text;
  Side side = Side::right;
};

struct Plot {
  std::string title;
  AxisDesc x, y;
  Cells cells;
  std::vector<Series> series;
  std::vector<Label> labels;
  double height = 360;  // px, between the axes; it is 658 px wide there
};

// An SVG element. Colours are the page's: report/page.h.
std::string svg(const Plot& plot);

// Of points that are better the smaller x and y are: those that no other beats in both, by rising x.
std::vector<Point> pareto_front(std::vector<Point> points);

}  // namespace fulcrum::report
