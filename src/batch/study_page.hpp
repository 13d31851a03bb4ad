// The page of a study: one HTML file with everything in it, without the viewer of runs.
#pragma once

#include "batch/estimates.hpp"

#include <string>

namespace terp {

/// written: when, in UTC.
std::string page_of_study(const Study& study, const Realisations& rows, const std::string& written);

/// The page of `terp study sample`: what would be drawn, before a long run.
std::string page_of_samples(const Study& study, Index n, const std::string& written);

/// Its part of a sweep: events and outcomes against the first key that takes numbers; empty if there is none.
std::string sweep_section(const Study& study, const Realisations& rows, Index n);

/// <svg> of a field over its trend in a realisation; without the values of soundings. Colours: half to twice the trend.
std::string field_picture(const Study& study, std::size_t field, Index realisation);

}  // namespace terp
