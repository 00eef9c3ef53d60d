// Reads a trace: the largest value of a column, and when it was.
//     fulcrum run piping --headless --out A && read_trace A/trace.csv contact/depth_max
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

int main(int argc, char** argv) {
  if (argc != 3) return std::fprintf(stderr, "usage: read_trace TRACE.csv COLUMN\n"), 2;
  std::ifstream trace(argv[1]);
  std::string line;
  std::getline(trace, line);
  const std::vector<std::string> names = cells_of(line);
  std::size_t column = 0;  // timestamp is the first
  while (column < names.size() && names[column] != argv[2]) ++column;
  if (column == names.size()) return std::fprintf(stderr, "%s has no column '%s'\n", argv[1], argv[2]), 1;

  double largest = -1e300, at = 0;
  while (std::getline(trace, line)) {
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() != names.size()) break;  // the run was killed in this line
    const double value = std::strtod(cells[column].c_str(), nullptr);
    if (value > largest) largest = value, at = std::strtod(cells[0].c_str(), nullptr);
  }
  std::printf("%s is largest at %g s: %g\n", argv[2], at, largest);
}
