// A verification case in a folder of its own: a box that flies through one row of cells; a row of the ledger.
#pragma once

#include "support/paths.hpp"
#include "verify/report.hpp"

namespace terp::test {

inline constexpr const char* flying_case = R"(scheme = "mpm_gp"
[time]
end = 0.5
[mesh]
size = [4.0, 1.0]
cell = 0.5
[[body]]
material = "rock"
box = [[0.5, 0.0], [1.5, 1.0]]
points_per_cell = 2
velocity = [2.0, 0.0]
[material.rock]
model = "linear_elastic"
density = 2000.0
shear_modulus = 1.0e6
poisson_ratio = 0.25
[output]
fields = { every = 0.1 }
)";

/// A folder with case.toml and expected.toml, as long as it lives.
struct LedgerSample {
  explicit LedgerSample(const std::string& expected)
  {
    std::ofstream(folder.path() + "/case.toml") << flying_case;
    std::ofstream(path()) << expected;
  }
  std::string path() const { return folder.path() + "/expected.toml"; }
  ScratchFolder folder;
};

inline Row row_that_passes(const std::string& case_name)
{
  return {.case_name = case_name,
      .run = "h = 1 m, mpm_gp",
      .quantity = "stress <zz>",
      .reference = "a|b",
      .source = "Euler",
      .terp = "2",
      .error = "0.1",
      .tolerance = "0.2",
      .verdict = Verdict::pass};
}

}  // namespace terp::test
