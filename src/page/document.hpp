// The data of a page that shows no single run but a study, a reach or a sequence of meshes: the JSON that the program
// also writes for other programs, with tables of numbers beside it (docs/report_format.md).
// Not for: pages of runs (payload).
#pragma once

#include "math/types.hpp"
#include "page/payload.hpp"

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace terp {

struct PageColumn {
  std::string name, label, unit;  ///< unit: "-" of none
  std::vector<Real> values;       ///< NaN: not known
};

class PageDocument {
 public:
  /// json: an object; the page finds it under `data`.
  explicit PageDocument(const std::string& json) : data(nlohmann::ordered_json::parse(json)) {}

  nlohmann::ordered_json data;

  /// Adds the numbers as a chunk; returns what `data` says of the table. All columns have equal lengths.
  nlohmann::ordered_json table(const std::vector<PageColumn>& columns);

  /// kind: study, reach, convergence or element. written: time, UTC, ISO 8601. language: one of report_languages.
  Payload payload(const std::string& kind, const std::string& written, const std::string& language = "en") const;

 private:
  std::vector<std::string> chunks_;
};

}  // namespace terp
