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

/// Every table of fields, and what `also` names, of two VTKHDF files.
inline void expect_same_fields(
    const std::string& a, const std::string& b, const std::vector<std::string>& groups, std::vector<std::string> also)
{
  const Hdf5File first(a, Hdf5File::Mode::read), second(b, Hdf5File::Mode::read);
  for (const std::string& group : groups)
    for (const std::string& name : first.members(group)) also.push_back(group + "/" + name);
  for (const std::string& table : also) {
    const auto same_numbers = [&]<class T>(T) {
      const auto one = first.read<T>(table), other = second.read<T>(table);
      return std::equal(
          one.begin(), one.end(), other.begin(), other.end(), [](T x, T y) { return x == y || (x != x && y != y); });
    };
    EXPECT_TRUE(first.holds_reals(table) ? same_numbers(Real{}) : same_numbers(std::int64_t{})) << table;
  }
}

/// Results of two runs of the same case: every point, field, row and bit of the final state.
inline void expect_same_results(const std::string& a, const std::string& b, const std::string& checkpoint)
{
  EXPECT_EQ(first_difference(read_checkpoint(a + checkpoint), read_checkpoint(b + checkpoint)), "");
  EXPECT_EQ(text_of(a + "/history.csv"), text_of(b + "/history.csv"));
  EXPECT_EQ(text_of(a + "/ledger.csv"), text_of(b + "/ledger.csv"));
  EXPECT_GT(Hdf5File(a + "/results.vtkhdf", Hdf5File::Mode::read).members("/VTKHDF/PointData").size(), 8u);
  expect_same_fields(
      a + "/results.vtkhdf", b + "/results.vtkhdf", {"/VTKHDF/PointData"}, {"/VTKHDF/Points", "/VTKHDF/Steps/Values"});
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
