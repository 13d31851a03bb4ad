// summary.json: the numbers that remain of a run, and the case that gave them (docs/formats.md).
#pragma once

#include "io/files/run_folder.hpp"
#include "run/report/summary.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace terp {

/// Its list of slides, each with its slip surface.
nlohmann::ordered_json slides_json(const Summary& summary);

/// Its verdict on the water, or null.
nlohmann::ordered_json flood_json(const Summary& summary);

/// What a run has written of one of its tables.
struct WrittenTable {
  std::string file;  ///< "ledger.csv"
  std::int64_t n_bytes = 0;
  std::string checksum;  ///< of so many bytes from the start of the file
};

/// The text of summary.json, with its own checksum at the end. finished: the run reached its end time.
std::string summary_text(
    const Summary& summary, bool finished, const CaseText& case_text, const std::vector<WrittenTable>& tables = {});

struct SavedSummary {
  Summary values;
  bool finished = false;
  std::string terp_version;
  std::string text;                      ///< the whole file
  std::optional<std::string> case_toml;  ///< of the case that was solved; none: an older terp wrote no checksum
  std::vector<WrittenTable> tables;
};

/// Throws FileError if the file is missing, not JSON, or not as it was written. What an older Terp did not write keeps
/// its default.
SavedSummary read_summary(const std::string& path);

/// The case's name in the summary of a run folder; the folder's own name if there is none to be read.
std::string case_name_in(const std::string& folder);

void write_summary(const std::string& path, const Summary& summary, bool finished, const CaseText& case_text,
    const std::vector<WrittenTable>& tables = {});

}  // namespace terp
