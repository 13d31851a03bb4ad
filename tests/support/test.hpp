// What nearly every test takes: GoogleTest, the standard library, names of Terp and of matchers without namespaces.
#pragma once

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace terp::test {

/// What the Error says that `call` throws; "" if it throws nothing. Any other exception fails the test.
template <class Error = std::exception, class Call>
std::string refusal(Call&& call)
{
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace terp::test

using namespace terp;
using namespace terp::test;
using testing::AllOf, testing::AnyOf, testing::Contains, testing::ContainsRegex, testing::DoubleEq, testing::DoubleNear;
using testing::Each, testing::ElementsAre, testing::ElementsAreArray, testing::EndsWith, testing::HasSubstr;
using testing::IsEmpty, testing::MatchesRegex, testing::Not, testing::Optional, testing::Pointwise, testing::SizeIs;
using testing::StartsWith, testing::TestWithParam, testing::ThrowsMessage, testing::UnorderedElementsAre;
using testing::ValuesIn, testing::_;
