// A run folder as the writers leave it, without a run: for tests of what reads it.
#pragma once

#include "io/case/case_file.hpp"
#include "io/files/files.hpp"
#include "io/files/point_frames.hpp"
#include "io/files/run_folder.hpp"
#include "io/files/samples.hpp"
#include "io/files/summary_json.hpp"
#include "io/files/table_csv.hpp"
#include "support/paths.hpp"

namespace terp::test {

/// Three frames of the sample points, two rows of each table, a summary. change: of the summary, before it is written.
template <class Change>
std::string write_run(const std::string& folder, Change&& change)
{
  std::filesystem::create_directories(folder);
  write_file_atomically(path_in(folder, case_file), read_file(source_path("cases/column_collapse/model_2.toml")));
  PointFrameWriter results({folder, point_frames, "0123456789abcdef"});
  for (int k = 0; k < 3; ++k) results.append(sample_frame(k));
  TableFile(path_in(folder, history_file), header_of(*history_table()))
      .append(csv_lines(sample_history(0.0)) + csv_lines(sample_history(0.25)));
  TableFile(path_in(folder, ledger_file), header_of(*sample_ledger_table()))
      .append(csv_lines(sample_ledger(0.0)) + csv_lines(sample_ledger(0.25)));
  Summary summary;
  summary.scheme = "mpm_gp", summary.n_points = 5, summary.n_steps = 100, summary.front_x = 13.0, summary.run_out = 5.0,
  summary.facing = Facing::right;
  change(summary);
  write_summary(path_in(folder, summary_file), summary, true, {"model_2", read_file(path_in(folder, case_file))});
  return folder;
}

inline std::string write_run(const std::string& folder)
{
  return write_run(folder, [](Summary&) {});
}

/// What a wrong option says.
template <class Call>
std::string case_error_of(Call&& call)
{
  return refusal<CaseError>(call);
}

}  // namespace terp::test
