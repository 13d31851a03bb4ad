// The harnesses of this folder, for replay.cpp.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

/// NAME of NAME_fuzz.cpp, and the function in it that libFuzzer would call.
struct Harness {
  std::string_view name;
  int (*input)(const unsigned char* data, std::size_t size);
};

const std::vector<Harness>& harnesses();
