// What the summary of a run says against its numbers, on the terminal.
#pragma once

#include <string>

namespace terp {

struct Model;
struct Summary;

void warn_of(const Summary& summary, const Model& model, const std::string& folder);

}  // namespace terp
