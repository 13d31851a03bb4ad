#include "parallel/processor.hpp"
#include "support/test.hpp"

namespace {

TEST(Processor, HasANameOnOneLine)
{
  const std::string name = processor_name();  // empty where /proc/cpuinfo has no such line, as on ARM
  EXPECT_EQ(name.find('\n'), std::string::npos);
  EXPECT_TRUE(name.empty() || name.ends_with(" processors")) << name;
}

}  // namespace
