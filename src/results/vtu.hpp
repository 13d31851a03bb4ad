// Frames for tools older than VTKHDF: .vtu (one file per frame) and .pvd (which file at which time).
#pragma once

#include "results/frames.hpp"

#include <string>
#include <utility>
#include <vector>

namespace terp {

/// A frame that is exported: places [m], shape [n, 2], and some fields.
struct ExportFrame {
  Real time = 0.0;  ///< [s]
  std::int64_t step = 0;
  std::vector<Real> x;
  std::vector<std::pair<ResultField, std::vector<Real>>> fields;

  std::int64_t n_points() const { return std::ssize(x) / 2; }
};

/// Names of the components: "" for one, else "_x" ... or "_xx" ...
std::vector<std::string> component_suffixes(int n_components);

/// The text of a .vtu file: one vertex cell per point, values in base64.
std::string vtu_text(const ExportFrame& frame);

/// The text of a .pvd file. files: time [s] and name of each.
std::string pvd_text(const std::vector<std::pair<Real, std::string>>& files);

}  // namespace terp
