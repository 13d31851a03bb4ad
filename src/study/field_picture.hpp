// A random field of a study as a picture, before anything is solved.
#pragma once

#include "study/study.hpp"

#include <string>

namespace terp {

/// <svg> of a field over its trend in a realisation; without the values of soundings. Colours: half to twice the trend.
std::string field_picture(const Study& study, std::size_t field, Index realisation);

}  // namespace terp
