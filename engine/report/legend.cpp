#include "engine/report/legend.h"

#include <algorithm>
#include <utility>

#include "engine/report/markup.h"

namespace fulcrum::report {
namespace {

constexpr double kKey = 30, kAfterKey = 8, kBetween = 22;  // px

std::string hue_class(int hue) {
  return hue == kInk ? "ink" : "h" + std::to_string(hue % kHues);
}

}  // namespace

std::string shade_class(int shade) {
  const int s = std::clamp(shade, -kDeepestShade, kDeepestShade);
  return (s < 0 ? "cool" : s > 0 ? "warm" : "even") + (s == 0 ? "" : std::to_string(std::abs(s)));
}

std::string line_class(const Series& series) {
  std::string name = "line " + hue_class(series.hue);
  if (series.line == Line::dashed) name += " dashed";
  if (series.line == Line::dotted) name += " dotted";
  if (series.strong) name += " strong";
  if (series.faint) name += " faint";
  return name;
}

std::string marker_class(const Series& series) {
  return (series.marker == Marker::cross ? "stroke " : "fill ") + hue_class(series.hue) +
         (series.faint ? " faint" : "");
}

std::string marker_path(Marker marker, double x, double y, double r) {
  const auto point = [x, y](double dx, double dy) { return pixels(x + dx) + " " + pixels(y + dy); };
  switch (marker) {
    case Marker::none:
      return {};
    case Marker::circle: {
      const std::string arc = "a" + pixels(r) + " " + pixels(r) + " 0 1 0 ";
      return "M" + point(-r, 0) + arc + pixels(2 * r) + " 0" + arc + pixels(-2 * r) + " 0z";
    }
    case Marker::square: {
      const double h = 0.9 * r;
      return "M" + point(-h, -h) + "L" + point(h, -h) + "L" + point(h, h) + "L" + point(-h, h) + "z";
    }
    case Marker::triangle:
      return "M" + point(0, -1.2 * r) + "L" + point(1.1 * r, 0.8 * r) + "L" + point(-1.1 * r, 0.8 * r) + "z";
    case Marker::diamond:
      return "M" + point(0, -1.3 * r) + "L" + point(1.3 * r, 0) + "L" + point(0, 1.3 * r) + "L" +
             point(-1.3 * r, 0) + "z";
    case Marker::cross:
      return "M" + point(-r, -r) + "L" + point(r, r) + "M" + point(-r, r) + "L" + point(r, -r);
  }
  return {};
}

double Legend::text_width(const std::string& text) {
  constexpr double per_letter = 7.1;
  return per_letter * static_cast<double>(std::count_if(text.begin(), text.end(), [](char c) {
           return (static_cast<unsigned char>(c) & 0xc0) != 0x80;  // UTF-8's other bytes take no room
         }));
}

Legend::Legend(const Plot& plot, double left, double right) : left_(left), next_(left) {
  for (const Series& series : plot.series)
    if (!series.name.empty()) place({series.name, &series, 0, 0, 0}, right);
  next_ = right + 1;  // bands on rows of their own
  for (const Band& band : plot.cells.bands)
    if (!band.name.empty()) place({band.name, nullptr, band.shade, 0, 0}, right);
}

void Legend::place(Entry entry, double right) {
  const double wide = kKey + kAfterKey + text_width(entry.name);
  if (rows_ == 0 || next_ + wide > right) {
    ++rows_;
    next_ = left_;
  }
  entry.x = next_;
  entry.row = rows_ - 1;
  next_ += wide + kBetween;
  entries_.push_back(std::move(entry));
}

std::string Legend::body(double top) const {
  std::string out;
  for (const Entry& entry : entries_) {
    const double y = top + kRow * entry.row + 8;
    if (entry.series == nullptr) {
      out += "<rect class=\"" + shade_class(entry.shade) + " key\" x=\"" + pixels(entry.x + kKey - 18) +
             "\" y=\"" + pixels(y - 7) + "\" width=\"18\" height=\"14\"/>";
    } else {
      const Series& series = *entry.series;
      if (series.line != Line::none) {
        out += "<path class=\"" + line_class(series) + "\" d=\"M" + pixels(entry.x) + " " + pixels(y) + "h" +
               pixels(kKey) + "\"/>";
      }
      if (series.marker != Marker::none) {
        out += "<path class=\"" + marker_class(series) + "\" d=\"" +
               marker_path(series.marker, entry.x + kKey / 2, y, 4) + "\"/>";
      }
    }
    out += "<text x=\"" + pixels(entry.x + kKey + kAfterKey) + "\" y=\"" + pixels(y + 4) + "\">" +
           escaped(entry.name) + "</text>";
  }
  return "<g class=\"words\">" + out + "</g>";
}

}  // namespace fulcrum::report
