// Points that fill the space of the random numbers more evenly than independent ones.
#pragma once

#include "batch/study_file.hpp"

#include <vector>

namespace terp {

/// The streams of counted random numbers (draw.cpp) that a study uses, the third part of the counter.
inline constexpr std::uint32_t stream_of_values = 0, stream_of_strata = 1, stream_of_audit = 2, stream_of_shift = 3;

/// Probabilities between 0 and 1 of a Latin hypercube (McKay, Beckman & Conover, Technometrics 21 (1979) 239-245) or of
/// Sobol points with a digital shift by the seed; shape [numbers, samples]. Empty for other samplers.
std::vector<std::vector<Real>> make_points(const StudySettings& settings);

/// Random numbers that Sobol points are known for.
std::size_t most_sobol_numbers();

}  // namespace terp
