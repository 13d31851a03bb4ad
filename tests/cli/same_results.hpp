// What tests of whole runs share: a run long enough to be disturbed, and whether two runs left the same results.
#pragma once

#include "cli/coarse_column.hpp"
#include "io/files/checkpoint.hpp"
#include "io/files/hdf5_file.hpp"
#include "io/results/frames.hpp"
#include "support/simulations.hpp"

#include <chrono>
#include <thread>

namespace terp::test {

/// The bytes of all frames of a run, by name.
inline std::map<std::string, std::string> frames_of(const std::string& folder)
{
  std::map<std::string, std::string> frames;
  for (const std::string& name : names_in(folder + "/frames")) frames[name] = text_of(folder + "/frames/" + name);
  return frames;
}

/// Times, positions and fields of all frames are the same. Their bytes differ where the runs began as different cases:
/// each frame bears the digest of its case.
inline void expect_same_frames(const std::string& a, const std::string& b)
{
  const Frames ours(a), theirs(b);
  EXPECT_GT(ours.times().size(), 1u);
  ASSERT_EQ(ours.times(), theirs.times());
  ASSERT_EQ(ours.fields().size(), theirs.fields().size());
  const auto same = [](const std::vector<Real>& x, const std::vector<Real>& y) {
    return std::ranges::equal(x, y, [](Real p, Real q) { return p == q || (p != p && q != q); });
  };
  for (std::size_t k = 0; k < ours.times().size(); ++k) {
    EXPECT_TRUE(same(ours.places(k), theirs.places(k))) << k;
    for (const auto& field : ours.fields())
      EXPECT_TRUE(same(ours.read(field.name, k), theirs.read(field.name, k))) << field.name;
  }
}

/// Results of two runs of the same case: every point, field, row and bit of the final state.
inline void expect_same_results(const std::string& a, const std::string& b, const std::string& checkpoint)
{
  EXPECT_EQ(first_difference(read_checkpoint(a + checkpoint), read_checkpoint(b + checkpoint)), "");
  EXPECT_EQ(text_of(a + "/history.csv"), text_of(b + "/history.csv"));
  EXPECT_EQ(text_of(a + "/ledger.csv"), text_of(b + "/ledger.csv"));
  expect_same_frames(a, b);
  EXPECT_EQ(text_of(a + "/results.vtkhdf.series"), text_of(b + "/results.vtkhdf.series"));
  const Hdf5File mesh_a(a + "/mesh.vtkhdf", Hdf5File::Mode::read), mesh_b(b + "/mesh.vtkhdf", Hdf5File::Mode::read);
  EXPECT_TRUE(mesh_a.read<Real>("/VTKHDF/Points") == mesh_b.read<Real>("/VTKHDF/Points"));
  EXPECT_TRUE(mesh_a.read<std::int64_t>("/VTKHDF/Connectivity") == mesh_b.read<std::int64_t>("/VTKHDF/Connectivity"));
}

/// 1320 steps of 6400 points.
inline std::vector<std::string> longer_run(const std::string& folder, const char* threads)
{
  return {"run", column_file, "--set", "mesh.cell=0.25", "--set", "time.end=2.0", "-o", folder, "-j", threads};
}

inline void wait_for_rows(const std::string& folder)
{
  for (int k = 0; k < 2000; ++k) {
    const std::string rows = text_of(folder + "/ledger.csv");
    if (std::count(rows.begin(), rows.end(), '\n') > 3) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  FAIL() << "the run does not start";
}

inline void wait_for_checkpoint(const std::string& folder)
{
  const auto is_checkpoint = [](const std::string& name) {
    return name.starts_with("checkpoint_") && name.ends_with(".h5");
  };
  for (int k = 0; k < 6000; ++k) {
    const auto names = std::filesystem::exists(folder) ? names_in(folder) : std::vector<std::string>{};
    if (std::any_of(names.begin(), names.end(), is_checkpoint)) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  FAIL() << "the run writes no checkpoint";
}

}  // namespace terp::test
