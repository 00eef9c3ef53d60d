// Plot -> SVG. Places are in pixels of the picture's own grid; the page scales it.

#include <algorithm>
#include <cmath>
#include <string_view>

#include "engine/report/legend.h"
#include "engine/report/markup.h"
#include "engine/report/plot.h"

namespace fulcrum::report {
namespace {

constexpr double kPageWidth = 760;  // px
constexpr double kLeft = 78, kRight = 24, kBottom = 56, kMarginTop = 12;

class Drawing {
public:
  Drawing(const Plot& plot, Axis x, Axis y, double top)
      : plot_(plot), x_(std::move(x)), y_(std::move(y)), top_(top) {}

  std::string body() const {
    std::string out;
    out += cells();
    out += grid();
    out += "<svg x=\"" + pixels(kLeft) + "\" y=\"" + pixels(top_) + "\" width=\"" + pixels(width()) +
           "\" height=\"" + pixels(plot_.height) + "\" viewBox=\"" + pixels(kLeft) + " " + pixels(top_) +
           " " + pixels(width()) + " " + pixels(plot_.height) + "\">";  // clips what lies beyond the axes
    for (const Series& series : plot_.series) out += line(series);
    out += "</svg>";
    for (const Series& series : plot_.series) out += markers(series);
    for (const Label& label : plot_.labels) out += text(label);
    return out;
  }

private:
  static double width() { return kPageWidth - kLeft - kRight; }
  double px(double x) const { return kLeft + width() * x_.place(x); }
  double py(double y) const { return top_ + plot_.height * (1 - y_.place(y)); }
  bool shows(const Point& p) const { return x_.shows(p.x) && y_.shows(p.y); }
  bool holds(const Point& p) const {
    constexpr double slack = 1e-9;
    return shows(p) && std::abs(x_.place(p.x) - 0.5) <= 0.5 + slack &&
           std::abs(y_.place(p.y) - 0.5) <= 0.5 + slack;
  }

  // Cells of one shade in a row are one rectangle.
  std::string cells() const {
    const Cells& c = plot_.cells;
    std::string out;
    if (c.band.empty()) return out;
    const std::size_t n = c.x_edges.size() - 1;
    const auto clamped = [](double v, double low, double high) { return std::clamp(v, low, high); };
    for (std::size_t j = 0; j + 1 < c.y_edges.size(); ++j) {
      const double bottom = clamped(py(c.y_edges[j]), top_, top_ + plot_.height);
      const double upper = clamped(py(c.y_edges[j + 1]), top_, top_ + plot_.height);
      for (std::size_t i = 0; i < n;) {
        std::size_t end = i + 1;
        const int band = c.band[j * n + i];
        while (end < n && c.band[j * n + end] == band) ++end;
        const double left = clamped(px(c.x_edges[i]), kLeft, kPageWidth - kRight);
        const double right = clamped(px(c.x_edges[end]), kLeft, kPageWidth - kRight);
        if (band >= 0 && right > left && bottom > upper) {
          out += "<rect class=\"" + shade_class(c.bands[static_cast<std::size_t>(band)].shade) + "\" x=\"" +
                 pixels(left) + "\" y=\"" + pixels(upper) + "\" width=\"" + pixels(right - left) +
                 "\" height=\"" + pixels(bottom - upper) + "\"/>";
        }
        i = end;
      }
    }
    return "<g shape-rendering=\"crispEdges\">" + out + "</g>";
  }

  std::string grid() const {
    std::string lines, marks, words;
    const std::string bottom = pixels(top_ + plot_.height), right = pixels(kPageWidth - kRight);
    for (const Tick& tick : x_.ticks()) {
      const std::string at = pixels(px(tick.value));
      if (!tick.label.empty()) {
        lines += "<path d=\"M" + at + " " + pixels(top_) + "V" + bottom + "\"/>";
        words += "<text x=\"" + at + "\" y=\"" + pixels(top_ + plot_.height + 20) +
                 "\" text-anchor=\"middle\">" + escaped(tick.label) + "</text>";
      }
      marks += "M" + at + " " + bottom + "v" + (tick.label.empty() ? "3" : "6");
    }
    for (const Tick& tick : y_.ticks()) {
      const double at = py(tick.value);
      if (!tick.label.empty()) {
        lines += "<path d=\"M" + pixels(kLeft) + " " + pixels(at) + "H" + right + "\"/>";
        words += "<text x=\"" + pixels(kLeft - 10) + "\" y=\"" + pixels(at + 4) + "\" text-anchor=\"end\">" +
                 escaped(tick.label) + "</text>";
      }
      marks += "M" + pixels(kLeft) + " " + pixels(at) + (tick.label.empty() ? "h-3" : "h-6");
    }
    const std::string middle = pixels(kLeft + width() / 2), centre = pixels(top_ + plot_.height / 2);
    words += "<text class=\"axis\" x=\"" + middle + "\" y=\"" + pixels(top_ + plot_.height + 44) +
             "\" text-anchor=\"middle\">" + titled(plot_.x) + "</text>";
    words += "<text class=\"axis\" transform=\"translate(18 " + centre +
             ") rotate(-90)\" text-anchor=\"middle\">" + titled(plot_.y) + "</text>";
    return "<g class=\"grid\">" + lines + "</g><g class=\"words\">" + words +
           "</g><path class=\"frame\" d=\"" + marks + "M" + pixels(kLeft) + " " + pixels(top_) + "V" +
           bottom + "H" + right + "\"/>";
  }

  static std::string titled(const AxisDesc& axis) {
    return escaped(axis.unit.empty() ? axis.title : axis.title + " (" + axis.unit + ")");
  }

  std::string line(const Series& series) const {
    if (series.line == Line::none) return {};
    std::string path;
    bool pen_down = false;
    for (const Point& p : series.points) {
      if (!shows(p)) {
        pen_down = false;
        continue;
      }
      // Far beyond the frame a viewer's own arithmetic fails; the line stays straight enough up to there.
      const auto near = [](double v) { return std::clamp(v, -1e4, 1e4); };
      path += (pen_down ? "L" : "M") + pixels(near(px(p.x))) + " " + pixels(near(py(p.y)));
      pen_down = true;
    }
    return "<path class=\"" + line_class(series) + "\" d=\"" + path + "\"/>";
  }

  std::string markers(const Series& series) const {
    std::string out;
    if (series.marker == Marker::none) return out;
    for (const Point& p : series.points)
      if (holds(p))
        out += marker_path(series.marker, px(p.x), py(p.y), series.strong ? 5.5 : series.faint ? 2.5 : 4);
    return "<path class=\"" + marker_class(series) + "\" d=\"" + out + "\"/>";
  }

  std::string text(const Label& label) const {
    if (!holds(label.at)) return {};
    double x = px(label.at.x), y = py(label.at.y) + 4;
    const char* anchor = "middle";
    switch (label.side) {
      case Side::right:
        x += 9;
        anchor = "start";
        break;
      case Side::left:
        x -= 9;
        anchor = "end";
        break;
      case Side::above:
        y -= 13;
        break;
      case Side::below:
        y += 15;
        break;
    }
    const double half = Legend::text_width(label.text) / 2;
    if (std::string_view(anchor) == "middle")
      x = std::clamp(x, kLeft + half + 4, kPageWidth - kRight - half - 4);
    return "<text class=\"label\" x=\"" + pixels(x) + "\" y=\"" + pixels(y) + "\" text-anchor=\"" + anchor +
           "\">" + escaped(label.text) + "</text>";
  }

  const Plot& plot_;
  Axis x_, y_;
  double top_;
};

}  // namespace

std::string svg(const Plot& plot) {
  std::vector<double> xs(plot.cells.x_edges), ys(plot.cells.y_edges);
  for (const Series& series : plot.series) {
    for (const Point& p : series.points) {
      xs.push_back(p.x);
      ys.push_back(p.y);
    }
  }
  const Legend legend(plot, kLeft, kPageWidth - kRight);
  const double top = kMarginTop + legend.height();
  const std::string size = pixels(kPageWidth) + " " + pixels(top + plot.height + kBottom);
  return "<svg class=\"plot\" role=\"img\" aria-label=\"" + escaped(plot.title) +
         "\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + size + "\">" + legend.body(kMarginTop) +
         Drawing(plot, Axis(plot.x, xs), Axis(plot.y, ys), top).body() + "</svg>";
}

}  // namespace fulcrum::report
