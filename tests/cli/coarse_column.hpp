// The column of cases/ on coarse cells, as command lines.
#pragma once

#include "support/process.hpp"

namespace terp::test {

inline const std::string column_file = source_path("cases/column_collapse/model_2.toml");

/// A command for the column; short: 0.2 s on cells of 0.5 m, 66 steps of 1600 points.
inline std::vector<std::string> column_command(const std::string& command, const std::vector<std::string>& more = {})
{
  return with({command, column_file, "--set", "mesh.cell=0.5", "--set", "time.end=0.2", "-j", "1"}, more);
}

inline Finished run_column(const std::string& folder, const std::vector<std::string>& more = {})
{
  return terp(column_command("run", with({"-o", folder}, more)));
}

}  // namespace terp::test
