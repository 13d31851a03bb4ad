// Whether this program may go on with a store that another build, or another instruction set, began.
#pragma once

#include "study/store.hpp"

#include <atomic>
#include <string>

namespace terp {

/// Throws FileError where the results of the two would not have the same bits. What is not known is tried: a
/// realisation of the store is solved once more. Returns what to tell the user; empty: nothing.
std::string check_that_bits_agree(
    const Study& study, const std::string& folder, const StoredStudy& stored, const std::atomic<bool>& stop);

}  // namespace terp
