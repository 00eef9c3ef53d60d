// The forces of six seconds of the clumsy hand against recorded ones. Tolerance: 2 % of the largest force and
// 0.1 mm. The same machine gives the same bits; another C library may round a sine otherwise, and contact
// carries that on.
//
// FULCRUM_RECORD=1 in the environment writes the golden anew; say why in the commit.

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "haptics/math/number_text.h"
#include "tests/scenarios/piping/piping.h"

namespace fulcrum::test {
namespace {

constexpr int kTicks = 6000, kEvery = 50;

std::vector<double> row_of(const TickRecord& record) {
  std::vector<double> row;
  for (const Vec3& v :
       {record.X_WT.p, record.coupling_F_T_W.force, record.contact_F_T_W.force, record.device_F_H_D.force})
    row.insert(row.end(), v.begin(), v.end());
  row.push_back(record.depth_max);
  return row;
}

TEST(Trace, ForcesAreThoseRecorded) {
  const std::filesystem::path golden = std::filesystem::path(FULCRUM_GOLDENS) / "clumsy_forces.csv";
  std::vector<std::vector<double>> rows;
  PipingRun run("clumsy");
  // Forces are means over the ticks since the row before. The tool scrapes along under a trembling hand:
  // which tick a slip comes in is decided by the last bits of a distance, and with it the force of that tick.
  std::vector<double> mean(row_of({}).size(), 0.0);
  for (int i = 0; i < kTicks; ++i) {
    const std::vector<double> now = row_of(run.tick());
    for (std::size_t c = 0; c < now.size(); ++c) mean[c] += now[c] / kEvery;
    if ((i + 1) % kEvery != 0) continue;
    rows.push_back(mean);
    std::fill(mean.begin(), mean.end(), 0.0);
  }
  if (std::getenv("FULCRUM_RECORD") != nullptr) {
    std::ofstream out(golden);
    for (const std::vector<double>& row : rows) {
      for (std::size_t i = 0; i < row.size(); ++i) out << (i > 0 ? "," : "") << number_text(row[i], 9);
      out << '\n';
    }
  }
  std::ifstream in(golden);
  std::string line;
  double largest_N = 0;
  for (const std::vector<double>& row : rows) {
    ASSERT_TRUE(std::getline(in, line)) << golden << " ends early";
    std::istringstream cells(line);
    std::string cell;
    for (std::size_t i = 0; i < row.size(); ++i) {
      ASSERT_TRUE(std::getline(cells, cell, ','));
      const bool length = i < 3 || i + 1 == row.size();
      EXPECT_NEAR(row[i], std::stod(cell), length ? 1e-4 : 0.02 * 6.0) << "column " << i << " of " << line;
      if (!length) largest_N = std::max(largest_N, std::abs(row[i]));
    }
  }
  EXPECT_GT(largest_N, 2.0) << "it was to push";
}

TEST(Trace, TwoRunsAreTheSameBits) {
  PipingRun a("clumsy"), b("clumsy");
  for (int i = 0; i < 3000; ++i) {
    const TickRecord one = a.tick(), other = b.tick();
    ASSERT_EQ(one.X_WT.p, other.X_WT.p) << i;
    ASSERT_EQ(one.device_F_H_D.force, other.device_F_H_D.force) << i;
    ASSERT_EQ(one.energy_port, other.energy_port) << i;
  }
}

}  // namespace
}  // namespace fulcrum::test
