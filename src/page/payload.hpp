// The data of a report page: one JSON document and chunks of compressed bytes that it points to
// (docs/report_format.md). Not for: the page around them (page).
#pragma once

#include "io/results/run_results.hpp"

#include <array>
#include <string>
#include <vector>

namespace terp {

inline constexpr int report_format = 2;  ///< of the document; one that an old page would misread is another

inline constexpr std::array<const char*, 2> report_languages{"en", "nl"};

struct ReportOptions {
  std::size_t most_bytes = 14'000'000;  ///< of the data, as they stand in the page
  std::int64_t most_points = 200'000;   ///< per run
  std::string written;                  ///< time of writing, UTC, ISO 8601
  std::string language = "en";          ///< of the page to begin with: one of report_languages
};

struct Payload {
  std::string json;
  std::vector<std::string> chunks;    ///< base64 of gzip
  std::vector<std::string> notes;     ///< one line per run on what was left out, for the user
  std::vector<std::string> warnings;  ///< of frames that are missing or damaged
};

/// JSON that may stand inside a <script> of a page, whatever its texts hold: only in a text can a "<" stand.
std::string text_for_a_page(std::string json);

/// Throws FileError if a run cannot be read.
Payload make_payload(const std::vector<std::string>& folders, const ReportOptions& options);

}  // namespace terp
