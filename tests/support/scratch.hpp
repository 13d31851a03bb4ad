// Tests in a new folder of their own.
#pragma once

#include "support/paths.hpp"

#include <gtest/gtest.h>

namespace terp::test {

struct ScratchTest : testing::Test {
  const ScratchFolder scratch;
  const std::string folder = scratch.path();
};

}  // namespace terp::test
