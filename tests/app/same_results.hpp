// What tests of whole runs share: a run long enough to be disturbed, and whether two runs left the same results.
#pragma once

#include "app/coarse_column.hpp"
#include "output/checkpoint.hpp"
#include "support/simulations.hpp"

#include <algorithm>
#include <chrono>
#include <map>
#include <thread>

#include <gmock/gmock.h>

namespace terp::test {

/// The bytes of all frames of a run, by name.
inline std::map<std::string, std::string> frames_of(const std::string& folder)
{
  std::map<std::string, std::string> frames;
  for (const std::string& name : names_in(folder + "/frames")) frames[name] = text_of(folder + "/frames/" + name);
  return frames;
}

/// Results of two runs of the same case: every point, field, row and bit of the final state.
inline void expect_same_results(const std::string& a, const std::string& b, const std::string& checkpoint)
{
  EXPECT_EQ(first_difference(read_checkpoint(a + checkpoint), read_checkpoint(b + checkpoint)), "");
  EXPECT_EQ(text_of(a + "/history.csv"), text_of(b + "/history.csv"));
  EXPECT_EQ(text_of(a + "/ledger.csv"), text_of(b + "/ledger.csv"));
  EXPECT_GT(frames_of(a).size(), 1u);
  EXPECT_TRUE(frames_of(a) == frames_of(b));
  EXPECT_EQ(text_of(a + "/results.vtkhdf.series"), text_of(b + "/results.vtkhdf.series"));
  EXPECT_TRUE(text_of(a + "/mesh.vtkhdf") == text_of(b + "/mesh.vtkhdf"));
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
