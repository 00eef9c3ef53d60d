#pragma once
// Small maps side by side: cells in discs or squares, in rows and columns that are named, under one legend.

#include <string>
#include <vector>

#include "engine/report/plot.h"

namespace fulcrum::report {

struct Panels {
  std::string title;
  std::vector<std::string> columns, rows;  // names
  std::size_t across = 0, down = 0;        // cells of each panel
  bool round = false;                      // a disc about the cells that are there
  std::string above, below;                // words at the first panel
  std::vector<std::vector<int>> panels;    // (rows x columns), row by row: (down x across) from the top left:
                                           // index into bands, -1: left empty
  std::vector<Band> bands;
};

// An SVG element. Colours are the page's: report/page.h.
std::string svg(const Panels& panels);

}  // namespace fulcrum::report
