#include "engine/report/panels.h"

#include <algorithm>

#include "engine/report/legend.h"
#include "engine/report/markup.h"

namespace fulcrum::report {
namespace {

constexpr double kWidth = 760, kNames = 150, kGap = 14, kSide = 16;  // px
constexpr double kTop = 12, kHead = 24, kMax = 150;

std::string word(double x, double y, const char* anchor, const std::string& text) {
  return "<text x=\"" + pixels(x) + "\" y=\"" + pixels(y) + "\" text-anchor=\"" + anchor + "\">" +
         escaped(text) + "</text>";
}

std::string cells(const Panels& panels, const std::vector<int>& band, double left, double top, double size) {
  const double wide = size / static_cast<double>(panels.across),
               high = size / static_cast<double>(panels.down);
  std::string out;
  for (std::size_t j = 0; j < panels.down; ++j) {
    for (std::size_t i = 0; i < panels.across;) {
      std::size_t end = i + 1;
      const int at = band[j * panels.across + i];
      while (end < panels.across && band[j * panels.across + end] == at) ++end;
      if (at >= 0) {
        out += "<rect class=\"" + shade_class(panels.bands[static_cast<std::size_t>(at)].shade) + "\" x=\"" +
               pixels(left + wide * static_cast<double>(i)) + "\" y=\"" +
               pixels(top + high * static_cast<double>(j)) + "\" width=\"" +
               pixels(wide * static_cast<double>(end - i)) + "\" height=\"" + pixels(high) + "\"/>";
      }
      i = end;
    }
  }
  return (panels.round ? "<g class=\"disc\" shape-rendering=\"crispEdges\">"
                       : "<g shape-rendering=\"crispEdges\">") +
         out + "</g>";
}

std::string rim(bool round, double left, double top, double size) {
  return round ? "<circle class=\"frame\" cx=\"" + pixels(left + size / 2) + "\" cy=\"" +
                     pixels(top + size / 2) + "\" r=\"" + pixels(size / 2) + "\"/>"
               : "<rect class=\"frame\" x=\"" + pixels(left) + "\" y=\"" + pixels(top) + "\" width=\"" +
                     pixels(size) + "\" height=\"" + pixels(size) + "\"/>";
}

}  // namespace

std::string svg(const Panels& panels) {
  Plot keys;
  keys.cells.bands = panels.bands;
  const Legend legend(keys, 0, kWidth);
  const auto columns = static_cast<double>(panels.columns.size()),
             rows = static_cast<double>(panels.rows.size());
  const double size = std::min(kMax, (kWidth - kNames - kSide) / columns - kGap), pitch = size + kGap;
  const double first = kTop + legend.height() + kHead + kSide;
  const double height = first + rows * (pitch + kSide);
  std::string words, drawn;
  for (std::size_t j = 0; j < panels.rows.size(); ++j) {
    const double top = first + (pitch + kSide) * static_cast<double>(j);
    words += word(0, top + size / 2 + 4, "start", panels.rows[j]);
    for (std::size_t i = 0; i < panels.columns.size(); ++i) {
      const double left = kNames + kSide + pitch * static_cast<double>(i);
      if (j == 0)
        words += "<g class=\"axis\">" +
                 word(left + size / 2, first - kSide - 8, "middle", panels.columns[i]) + "</g>";
      drawn += cells(panels, panels.panels[j * panels.columns.size() + i], left, top, size) +
               rim(panels.round, left, top, size);
      if (i != 0 || j != 0) continue;
      words += word(left + size / 2, top - 5, "middle", panels.above) +
               word(left + size / 2, top + size + 14, "middle", panels.below);
    }
  }
  return "<svg class=\"plot\" role=\"img\" aria-label=\"" + escaped(panels.title) +
         "\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + pixels(kWidth) + " " + pixels(height) +
         "\">" + legend.body(kTop) + drawn + "<g class=\"words\">" + words + "</g></svg>";
}

}  // namespace fulcrum::report
