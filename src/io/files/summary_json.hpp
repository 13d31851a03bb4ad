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

/// The text of summary.json. finished: the run reached its end time.
std::string summary_text(const Summary& summary, bool finished, const CaseText& case_text);

struct SavedSummary {
  Summary values;
  bool finished = false;
  std::string terp_version;
  std::string text;  ///< the whole file
};

/// Throws FileError if the file is missing or not JSON. What an older Terp did not write keeps its default.
SavedSummary read_summary(const std::string& path);

/// The case's name in the summary of a run folder; the folder's own name if there is none to be read.
std::string case_name_in(const std::string& folder);

void write_summary(const std::string& path, const Summary& summary, bool finished, const CaseText& case_text);

}  // namespace terp
