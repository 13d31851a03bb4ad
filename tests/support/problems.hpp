// What is said of a case: what is refused, and what is told before a run.
#pragma once

#include "math/errors.hpp"
#include "support/test.hpp"

namespace terp {

/// As a test that fails shows it.
inline void PrintTo(const Problem& problem, std::ostream* out)
{
  *out << problem.key << ": " << problem.what << '\n' << problem.detail;
}

}  // namespace terp

namespace terp::test {

using Words = testing::Matcher<const std::string&>;

inline testing::Matcher<const Problem&> told(const Words& key, const Words& what, const Words& detail = testing::_)
{
  return AllOf(testing::Field("key", &Problem::key, key), testing::Field("what", &Problem::what, what),
      testing::Field("detail", &Problem::detail, detail));
}

/// What the InputError tells that `call` throws; nothing if it throws none.
template <class Call>
std::vector<Problem> problems_of(Call&& call)
{
  try {
    call();
  } catch (const InputError& error) {
    return error.problems();
  }
  return {};
}

}  // namespace terp::test
