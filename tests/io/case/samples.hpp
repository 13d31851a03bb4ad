// Small case files for the tests of this room.
#pragma once

#include "support/test.hpp"
#include "io/case/case_file.hpp"

namespace terp::test {

/// A complete case with nothing but required keys, 16 lines.
inline const std::string small_case = R"([time]
end = 4.0
[mesh]
size = [16.0, 3.0]
cell = 0.5
[[body]]
material = "clay"
box = [[0.0, 0.0], [8.0, 2.0]]
[material.clay]
model = "tresca_softening"
density = 1990.0
shear_modulus = 2.0e6
poisson_ratio = 0.48
su_peak = 8.0e3
su_residual = 2.0e3
eta = 50.0
)";

/// `text` with the first `from` replaced; an unchanged text would be a mistake of the test and throws.
inline std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  return text.replace(text.find(from), from.size(), to);  // find fails: std::out_of_range
}

/// small_case on another mesh: `keys` stand in [mesh] from line 4 on.
inline std::string small_case_on(const std::string& keys)
{
  return replaced(small_case, "size = [16.0, 3.0]\ncell = 0.5\n", keys + '\n');
}

/// Keys of [mesh] of other kinds.
inline const std::string graded = "origin = [-1.0, 2.0]\nsize = [16.0, 3.0]\ncells = [32, 6]\ngrading = [2.0, 0.5]";
inline const std::string mapped = R"(cells = 8
sides.bottom = [[0, 0], [4, 1], [8, 0]]
sides.right = [[8, 0], [8, 3]]
sides.top = [[0, 3], [8, 3]]
sides.left = [[0, 0], [0, 3]])";
inline const std::string polygon = R"(polygon = [[0, 0], [8, 0], [8, 1], [4, 3], [0, 3]]
cell = 0.5
edges = { base = [0], slope = [2, 3] }
refine = [
{ line = [[8, 1], [4, 3]], cell = 0.125, distance = 0.5 },
{ box = [[1, 0], [2, 1]], cell = 0.25 }]
follow_bodies = false
variant = 2)";

/// small_case with three materials.
inline const std::string two_clays =
    small_case +
    "[material.sand]\nmodel = \"linear_elastic\"\ndensity = 1800.0\nshear_modulus = 5.0e6\n"
    "poisson_ratio = 0.3\n[material.peat]\nmodel = \"tresca_softening\"\ndensity = 1100.0\n"
    "shear_modulus = 1.0e6\npoisson_ratio = 0.45\nsu_peak = 4.0e3\nsu_residual = 2.0e3\neta = 10.0\n";

/// A soil with one law below the phreatic line and another above.
inline const std::string wet_soil = R"([time]
end = 4.0
[mesh]
size = [16.0, 3.0]
cell = 0.5
[[body]]
material = "clay"
box = [[0.0, 0.0], [8.0, 2.0]]

[material.clay]
density = { below = 1800.0, above = 1600.0 }
below = { model = "tresca_softening", shear_modulus = 2.0e6, poisson_ratio = 0.48, su_peak = 8.0e3, eta = 50.0 }
above = { model = "linear_elastic", shear_modulus = 1e6, poisson_ratio = 0.3 }
[water]
phreatic_line = [[0, 1]]
)";

/// What the user sees for this text; "accepted" if it is read, followed by its warnings.
inline std::string message_for(const std::string& text, const std::vector<std::string>& overrides = {})
{
  try {
    return "accepted\n" + render_warnings(read_case_text(text, "case.toml", overrides));
  } catch (const CaseError& error) {
    return error.what();
  }
}

}  // namespace terp::test
