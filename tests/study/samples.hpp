// A study of a column that collapses within a second or stands, small and coarse.
#pragma once

#include "output/files.hpp"
#include "study/study.hpp"
#include "support/paths.hpp"

#include <string>

namespace terp::test {

/// 2 m high, 4 m wide, cells of 1 m, 2 x 2 points: 32 points.
inline const std::string column_case = R"([time]
end = 0.8
[mesh]
size = [10.0, 3.0]
cell = 1.0
[[body]]
material = "clay"
box = [[0.0, 0.0], [4.0, 2.0]]
points_per_cell = [2, 2]
[material.clay]
model = "tresca_softening"
density = 1900.0
shear_modulus = 1.0e6
poisson_ratio = 0.45
su_peak = 6.0e3
sensitivity = 2.0
eta = 5.0
[forces]
gravity = [0.0, -9.81]
[boundary]
left = "roller"
bottom = "fixed"
[output]
ledger = { every = 0.1 }
)";

inline const std::string column_study = R"(case = "column.toml"
seed = 3
[[random]]
key = "material.clay.su_peak"
distribution = "lognormal"
mean = "8 kPa"
cov = 0.4
[estimator]
kind = "monte_carlo"
[stop]
number = 12
[events]
volume = 1.0
displacement = 0.3
)";

/// Text of a study whose soil has a field.
inline const std::string field_study = R"(case = "column.toml"
seed = 3
[[field]]
key = "material.clay.su_peak"
cov = 0.3
theta = [8.0, 4.0]
[estimator]
kind = "monte_carlo"
[stop]
number = 6
[events]
volume = 1.0
displacement = 0.3
)";

/// The study file with that text, beside its case, in a folder.
inline std::string write_study(
    const std::string& folder, const std::string& study, const std::string& column = column_case)
{
  write_file_atomically(folder + "/column.toml", column);
  write_file_atomically(folder + "/demo.toml", study);
  return folder + "/demo.toml";
}

/// `text` with the first `from` replaced; throws where it does not stand there.
inline std::string changed(std::string text, const std::string& from, const std::string& to)
{
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace terp::test
