// report.md of an imported case: what moved, what was assumed, what was left out.
#pragma once

#include "import/dstability/soil_strength.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace terp {

struct SoilSum {
  Real area = 0.0, weight = 0.0;  ///< [m^2], [N/m]
  SoilSum& operator+=(const SoilSum& other)
  {
    area += other.area;
    weight += other.weight;
    return *this;
  }
};

struct FolderReport {
  std::string title = {};
  std::vector<std::string> head = {};
  std::map<std::string, SoilSum> weights = {};                                  ///< by material
  std::vector<std::pair<std::string, std::vector<std::string>>> sections = {};  ///< title, sentences
};

std::string text_of(const FolderReport& report);

/// What a case is of, for its head and its report.
std::vector<std::string> origin_comments(
    const StixProject& project, std::size_t scenario, std::size_t stage, StixBasis basis);

}  // namespace terp
