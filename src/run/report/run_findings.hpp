// What the results of a run say against themselves, in English and Dutch: the terminal, summary.json and the page show
// the same list. Not for: what is odd in a case before it runs (run/findings).
#pragma once

#include "math/types.hpp"

#include <string>
#include <vector>

namespace terp {

struct Model;
struct Summary;

inline constexpr Real much_damping =
    7.0;  ///< times what the factor promises: runs of damped mean force have 1.4 to 5.6
inline constexpr Real much_damped = 0.05;  ///< of the energy exchanged
inline constexpr Real least_cells = 2.0;   ///< in a softening length

struct RunFinding {
  std::string id;      ///< of its kind
  std::string en, nl;  ///< a full sentence
  std::string see;     ///< page of the documentation that explains it
};

/// What may change the verdict on a flood comes first. Of a summary that is whole but for its findings.
std::vector<RunFinding> findings_against(const Model& model, const Summary& summary);

}  // namespace terp
