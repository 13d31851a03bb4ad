#include "run/report/library_watch.hpp"
#include "run/loop/simulation.hpp"
#include "support/law_cases.hpp"

#include <chrono>

namespace library_watch_test {

std::vector<std::string> told_in_a_pause(const MaterialCase& material)
{
  const Simulation s(moving_box("mpm_gp", material), 1);
  std::mutex mutex;
  std::vector<std::string> told;
  LibraryWatch watch(
      s.model.description,
      [&](const std::string& text) {
        const std::lock_guard lock(mutex);
        told.push_back(text);
      },
      0.1);
  Progress now{};
  now.step = 17;
  watch.progress(now);
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  const std::lock_guard lock(mutex);
  return told;
}

TEST(LibraryWatch, NamesTheLawsOfARunThatDoesNotGoOn)
{
  const std::vector<std::string> told = told_in_a_pause(wrong_umat(elastic_law));
  ASSERT_GE(told.size(), 1U);
  EXPECT_THAT(told[0], AllOf(HasSubstr("no step was made for "), HasSubstr(" s, the last one was step 17: a law of a "),
                           HasSubstr("(wrong_umat.so)"), HasSubstr("Ctrl-C twice")));
}

TEST(LibraryWatch, IsSilentWithoutALibrary)
{
  EXPECT_THAT(told_in_a_pause(elastic(3e6, 0.3, 1900.0)), testing::IsEmpty());
}

}  // namespace library_watch_test
