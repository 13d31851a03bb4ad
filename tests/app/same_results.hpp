// What tests of whole runs share: a run long enough to be disturbed, and whether two runs left the same results.
#pragma once

#include "app/coarse_column.hpp"
#include "output/checkpoint.hpp"
#include "output/hdf5_file.hpp"
#include "support/simulations.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

#include <gmock/gmock.h>

namespace terp::test {

/// Results of two runs of the same case: every point, field, row and bit of the final state.
inline void expect_same_results(const std::string& a, const std::string& b, const std::string& checkpoint)
{
  EXPECT_EQ(first_difference(read_checkpoint(a + checkpoint), read_checkpoint(b + checkpoint)), "");
  EXPECT_EQ(text_of(a + "/history.csv"), text_of(b + "/history.csv"));
  EXPECT_EQ(text_of(a + "/ledger.csv"), text_of(b + "/ledger.csv"));
  const Hdf5File first(a + "/results.vtkhdf", Hdf5File::Mode::read), second(b + "/results.vtkhdf", Hdf5File::Mode::read);
  std::vector<std::string> tables{"/VTKHDF/Points", "/VTKHDF/Steps/Values"};
  for (const std::string& name : first.members("/VTKHDF/PointData")) tables.push_back("/VTKHDF/PointData/" + name);
  EXPECT_GT(tables.size(), 10u);
  for (const std::string& table : tables) {
    const bool same = first.holds_reals(table) ? first.read<Real>(table) == second.read<Real>(table)
                                               : first.read<std::int64_t>(table) == second.read<std::int64_t>(table);
    EXPECT_TRUE(same) << table;
  }
}

/// 1320 steps of 6400 points.
inline std::vector<std::string> longer_run(const std::string& folder, const char* threads)
{
  return {"run", column_file, "--set", "mesh.cell=0.25", "--set", "time.end=2.0", "-o", folder, "-j", threads};
}

/// Waits until a run has written some rows of its ledger.
inline void wait_for_rows(const std::string& folder)
{
  for (int k = 0; k < 2000; ++k) {
    const std::string rows = text_of(folder + "/ledger.csv");
    if (std::count(rows.begin(), rows.end(), '\n') > 3) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  FAIL() << "the run does not start";
}

}  // namespace terp::test
