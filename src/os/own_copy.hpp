// This process once more, made by fork, for calls of code that may end it or never return.
// Not for: the program begun anew (children.hpp), other programs (process.hpp).
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace terp {

/// Calls task(result) in a copy of this process, and takes over the n_bytes that it wrote there. They may point at
/// nothing that the task made. Returns "" or, in words, what befell the copy before the task was through; `result` is
/// then as it was. What the copy started ends with it. An exception of the task is lost. On Windows, which has no
/// copies, the task is called here. Throws FileError where the system grants no copy.
std::string call_in_copy(
    const std::function<void(void* result)>& task, void* result, std::size_t n_bytes, double limit_s);

/// Whether this process was made by call_in_copy.
bool is_copy();

/// Another number than before a call: that call made a copy of the process by fork(), and this is it.
int fork_count();

}  // namespace terp
