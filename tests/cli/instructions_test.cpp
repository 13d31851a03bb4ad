#include "cli/coarse_column.hpp"
#include "io/files/checkpoint.hpp"
#include "os/instructions.hpp"
#include "support/environment.hpp"
#include "support/simulations.hpp"
#include <nlohmann/json.hpp>

namespace instructions_test {

bool offered(std::string_view name)
{
  for (const InstructionSet& set : instruction_sets())
    if (set.name == name) return set.offered;
  return false;
}

/// The end of model 2 on cells of 0.2 m after 2 s: it has slid, softened, and points have changed cell.
StateImage end_of_column(const std::string& instructions, const std::string& scheme)
{
  const Variable variable("TERP_INSTRUCTIONS", instructions);
  const ScratchFolder folder;
  const Finished f = test::terp({"run", column_file, "--set", "mesh.cell=[0.2,0.2]", "--set", "time.end=2", "--set",
      "scheme=" + scheme, "-q", "-o", folder.path() + "/run"});
  EXPECT_EQ(f.status, 0) << f.err;
  const auto summary = nlohmann::json::parse(text_of(folder.path() + "/run/summary.json"));
  EXPECT_EQ(summary["instructions"], instructions);
  return newest_good_checkpoint(folder.path() + "/run").image.value();
}

TEST(EverySet, WithFusedProductsEndsInTheSameBits)
{
  if (!offered("avx2") || !offered("avx512")) GTEST_SKIP() << "this machine or build has not both AVX2 and AVX-512";
  for (const char* scheme : {"mpm_gp", "mpm_mixed", "standard_mpm"})
    EXPECT_EQ(first_difference(end_of_column("avx2", scheme), end_of_column("avx512", scheme)), "") << scheme;
}

TEST(EverySet, IsTheOneThatTheVariableNames)
{
  for (const InstructionSet& set : instruction_sets()) {
    const Variable variable("TERP_INSTRUCTIONS", std::string(set.name));
    const Finished f = test::terp({"--version"});
    EXPECT_THAT(f.out + f.err,
        HasSubstr(set.offered ? "(" + std::string(set.name) + ")\n" : "this processor does not offer it"));
    EXPECT_EQ(f.status, set.offered ? 0 : 2);
  }
}

TEST(EverySet, ARunThatGoesOnWithAnotherSetSaysSoAndNamesBoth)
{
  const ScratchFolder scratch;
  const std::string folder = scratch.path() + "/run", path = folder + "/summary.json";
  succeeded(run_column(folder, {"-q"}));
  auto summary = nlohmann::json::parse(text_of(path));
  const std::string now = summary["instructions"];
  EXPECT_EQ(test::terp({"resume", folder, "-q", "-j", "1"}).err, "");  // the same set
  summary["instructions"] = "abacus";
  summary.erase("checksum");
  write_text(path, summary.dump());
  EXPECT_THAT(succeeded(test::terp({"resume", folder, "-q", "-j", "1"})).err,
      HasSubstr("warning: the run was solved with the instruction set abacus so far, and goes on with " + now +
                "; its results may differ in the last digits"));
  EXPECT_EQ(nlohmann::json::parse(text_of(path))["instructions"], "abacus, " + now);
}

/// What the points of the short column carry. Without local damping: it pushes against the sign of a velocity, which
/// round-off decides in soil that a wave has not yet reached.
std::vector<NamedArray> rows_of_short_column(const std::string& instructions)
{
  const Variable variable("TERP_INSTRUCTIONS", instructions);
  const ScratchFolder folder;
  EXPECT_EQ(run_column(folder.path() + "/run", {"--set", "forces.damping.local=0"}).status, 0);
  std::vector<NamedArray> rows = newest_good_checkpoint(folder.path() + "/run").image.value().arrays;
  std::erase_if(rows, [](const NamedArray& array) {
    return !array.name.starts_with("points/") || !std::holds_alternative<std::vector<Real>>(array.values);
  });
  return rows;
}

/// SSE2 rounds a product before it is added: other bits, the same numbers.
TEST(EverySet, WithoutFusedProductsDiffersByRoundOff)
{
  if (!offered("sse2") || !offered("avx2")) GTEST_SKIP() << "this machine or build has not both SSE2 and AVX2";
  const std::vector<NamedArray> rounded = rows_of_short_column("sse2"), fused = rows_of_short_column("avx2");
  ASSERT_EQ(rounded.size(), fused.size());
  bool any_differs = false;
  for (std::size_t array = 0; array < fused.size(); ++array) {
    ASSERT_EQ(rounded[array].shape, fused[array].shape);
    const auto &a = std::get<std::vector<Real>>(rounded[array].values),
               &b = std::get<std::vector<Real>>(fused[array].values);
    any_differs |= a != b;
    const auto n = static_cast<std::size_t>(fused[array].shape.size() > 1 ? fused[array].shape[1] : 1);
    std::vector<Real> largest(n, 0.0);
    for (std::size_t k = 0; k < b.size(); ++k) largest[k % n] = std::max(largest[k % n], std::abs(b[k]));
    for (std::size_t k = 0; k < b.size(); ++k)
      ASSERT_NEAR(a[k], b[k], 1e-12 * largest[k % n]) << fused[array].name << ", component " << k % n;
  }
  EXPECT_TRUE(any_differs);
}

}  // namespace instructions_test
