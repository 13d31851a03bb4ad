#include "os/instructions.hpp"
#include "page/page.hpp"
#include "batch/reliability.hpp"
#include "support/process.hpp"

namespace main_test {

TEST(Version, SaysWhichInstructionsItUsesAndWhatItWasBuiltWith)
{
  const Finished f = succeeded(test::terp({"--version"}));
  EXPECT_THAT(f.out, StartsWith("terp " TERP_VERSION " (" + std::string(instructions()) + ")\n  compiler       "));
  EXPECT_THAT(f.out, ContainsRegex("\n  instructions   .*" + std::string(instructions())));
  EXPECT_THAT(f.out, HasSubstr(std::string("\n  OpenTURNS      ") + (has_openturns() ? "yes\n" : "no\n")));
  EXPECT_THAT(f.out, HasSubstr(std::string("\n  report page    ") + (has_page() ? "yes\n" : "no\n")));
}

}  // namespace main_test
