#pragma once
// The legend over a plot, in as many rows as it needs, and what lines, markers and cells look like in it and
// below.

#include <string>
#include <vector>

#include "engine/report/plot.h"

namespace fulcrum::report {

class Legend {
public:
  // left, right: px, between which it is laid out.
  Legend(const Plot& plot, double left, double right);

  double height() const { return kRow * rows_; }  // px
  std::string body(double top) const;             // top: px, of the first row

  // px, of text in a plot: on the wide side, since the viewer's font is not known.
  static double text_width(const std::string& text);

private:
  static constexpr double kRow = 22;
  struct Entry {
    std::string name;
    const Series* series = nullptr;  // null: a band
    int shade = 0;
    double x = 0;  // px
    int row = 0;
  };
  void place(Entry entry, double right);

  double left_, next_;
  int rows_ = 0;
  std::vector<Entry> entries_;
};

std::string shade_class(int shade);
std::string line_class(const Series& series);
std::string marker_class(const Series& series);
// Path data of a marker about (x, y), r px from its middle to its rim.
std::string marker_path(Marker marker, double x, double y, double r);

}  // namespace fulcrum::report
