// Terp's own interface (terp_law.h): one call for a block of points. Where the law asks for a smaller step, all points
// of the block are taken in halves of the step, then quarters.

#include "math/errors.hpp"
#include "os/own_copy.hpp"
#include "os/turn.hpp"
#include "soil/libraries/interface.hpp"
#include "soil/libraries/terp_law.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace terp {
namespace {

constexpr int most_halvings = 12;
static_assert(smallest_part == 1.0 / (1 << most_halvings));
constexpr int most_parameters = 1000, most_state = 100, rows_behind = 28;

/// What the library is given beside the points. Behind the rows of the state there are others, all of the same numbers,
/// and behind the parameters there are some, too.
struct NativeArrays {
  Real* increment;  ///< of the part, 4 rows
  Real* behind;     ///< a row
  const Real* parameters;
  std::array<Real*, most_state + rows_behind> state;
};

class NativeCalls final : public LawCalls {
 public:
  NativeCalls(const terp_law_description& law, const LibraryCase& library)
      : update_(law.update), n_state_(library.state.size())
  {
    for (const NamedNumber& number : library.parameters) parameters_.push_back(number.value);
  }

  /// The start of the part, 4 rows of stress and those of the state, the increment of the part, a row that stands
  /// behind the state, and the parameters with what stands behind them.
  std::size_t n_scratch() const override
  {
    return (9 + n_state_) * most_points_of_call + parameters_.size() + n_numbers_beyond;
  }

  void run(LawPoints& points) const override
  {
    const int n = points.n;
    Real *start = points.scratch.data(), *increment = start + (4 + n_state_) * most_points_of_call;
    const NativeArrays arrays = arrays_of(points, increment);
    const auto for_each_row = [&](auto&& f) {
      for (std::size_t k = 0; k < 4 + n_state_; ++k)
        f(start + k * most_points_of_call, k < 4 ? points.sigma[k].data() : points.state[k - 4]);
    };
    int done = 0, halvings = 0;  // parts done, of 2^halvings
    while (done < (1 << halvings)) {
      const Real part = 1.0 / (1 << halvings);
      for_each_row([n](Real* kept, const Real* row) { std::copy_n(row, n, kept); });
      for (int k = 0; k < 4; ++k)
        for (int p = 0; p < n; ++p) increment[k * most_points_of_call + p] = part * points.d_eps[k][p];
      const int answer = call(points, arrays, part, done);
      if (points.failed) return;
      if (answer == TERP_LAW_OK) {
        ++done;
        continue;
      }
      if (halvings == most_halvings) {
        points.cure = smaller_steps;
        return points.fail("the law asks for parts of the step smaller than 1/{} of it", 1 << most_halvings);
      }
      for_each_row([n](const Real* kept, Real* row) { std::copy_n(kept, n, row); });
      done *= 2, ++halvings;
    }
  }

 private:
  NativeArrays arrays_of(LawPoints& points, Real* increment) const
  {
    Real *behind = increment + 4 * most_points_of_call, *parameters = behind + most_points_of_call;
    std::ranges::copy(parameters_, parameters);
    std::fill_n(parameters + parameters_.size(), n_numbers_beyond, std::bit_cast<Real>(points.beyond.parameters));
    std::fill_n(behind, most_points_of_call, std::bit_cast<Real>(points.beyond.state));
    NativeArrays arrays{.increment = increment, .behind = behind, .parameters = parameters, .state = {}};
    arrays.state.fill(behind);
    std::ranges::copy(points.state, arrays.state.begin());
    return arrays;
  }

  int call(LawPoints& points, const NativeArrays& arrays, Real part, int done) const
  {
    terp_law_points given{};
    given.n = points.n;
    given.time = points.time + done * part * points.dt;
    given.dt = part * points.dt;
    given.parameters = arrays.parameters;
    for (int k = 0; k < 4; ++k) {
      given.stress[k] = points.sigma[k].data();
      given.strain_increment[k] = arrays.increment + k * most_points_of_call;
    }
    given.state = arrays.state.data();
    static constexpr LawPoints::Row<Real> no_spin{};
    given.spin = done == 0 ? points.d_spin.data() : no_spin.data();
    given.turned = points.turned;
    given.x = points.x[0].data(), given.y = points.x[1].data();
    given.cell_size = points.cell_size.data();
    points.at = LawPoints::unknown;
    const int answer = update_(&given);
    for (int p = 0; p < most_points_of_call && !points.failed; ++p) {
      if (std::bit_cast<std::uint64_t>(arrays.behind[p]) == points.beyond.state) continue;
      points.cure = "a larger n_state in the description that the library gives of itself";
      points.fail("the law writes beyond its state, of {} numbers", n_state_);
    }
    if (answer == TERP_LAW_OK || points.failed) return answer;
    points.at = std::clamp(given.point, 0, points.n - 1);
    if (answer != TERP_LAW_SMALLER_STEP)
      points.fail("the law says: {:.200}", given.message == nullptr ? "nothing, but that it failed" : given.message);
    return answer;
  }

  int (*update_)(terp_law_points*);
  std::size_t n_state_;
  std::vector<Real> parameters_;
};

[[noreturn]] void refuse(const std::string& what, const std::string& detail)
{
  throw InputError(Problem{"", what, detail, "library"});
}

const terp_law_description& description_of(void* symbol)
{
  const terp_law_description* law = reinterpret_cast<const terp_law_description* (*)()>(symbol)();
  if (law == nullptr) refuse("the library returns no description of its law", "Its function returned NULL.");
  if (law->version != TERP_LAW_VERSION)
    refuse("the library was built for another version of the interface",
        fmt::format(
            "Its description has version {}, this Terp has {}. Build it again with the terp_law.h of this Terp.",
            law->version, TERP_LAW_VERSION));
  if (law->update == nullptr || law->n_parameters < 0 || law->n_state < 0 ||
      (law->n_parameters > 0 && law->parameters == nullptr) || (law->n_state > 0 && law->state == nullptr))
    refuse("the description of the law is not complete",
        "It needs `update`, and tables of as many `parameters` and `state` as it says.");
  if (law->n_parameters > most_parameters || law->n_state > most_state)
    refuse(
        "the law has too many variables", fmt::format("It has {} parameters and {} state variables; at most {} and {}.",
                                              law->n_parameters, law->n_state, most_parameters, most_state));
  return *law;
}

std::string text_of(const char* text) { return text != nullptr ? text : ""; }

std::vector<LawVariables::Variable> variables_of(const terp_law_variable* table, int n)
{
  std::vector<LawVariables::Variable> list;
  for (const terp_law_variable& v : std::span(table, static_cast<std::size_t>(n)))
    list.push_back({text_of(v.name), text_of(v.unit), text_of(v.meaning), v.initial});
  return list;
}

LawVariables variables_of(void* symbol)
{
  const terp_law_description& law = description_of(symbol);
  return {variables_of(law.parameters, law.n_parameters), variables_of(law.state, law.n_state), law.thread_safe != 0};
}

/// What a library says of itself may point anywhere: a copy of this process asks first, once.
void ask_in_copy(void* symbol)
{
  constexpr double limit_s = 10.0;
  static const OneAtATime one;
  static std::set<void*> asked;
  one([&] {
    if (!asked.insert(symbol).second) return;
    const std::string fault = call_in_copy([&](void*) { variables_of(symbol); }, nullptr, 0, limit_s);
    if (fault.empty()) return;
    asked.erase(symbol);
    refuse("the library failed when it was asked to describe its law",
        "A copy of this program asked it, and " + fault + '.');
  });
}

}  // namespace

std::optional<LawVariables> describe_native(void* symbol, LibraryCase&)
{
  ask_in_copy(symbol);
  LawVariables said = variables_of(symbol);
  for (const LawVariables::Variable& variable : said.state)
    if (!std::isfinite(variable.initial))
      refuse(fmt::format("the state variable `{}` of the library begins with no number", variable.name),
          fmt::format("Its `initial` is {}.", variable.initial));
  return said;
}

std::unique_ptr<LawCalls> make_native(void* symbol, const LibraryCase& library, const std::string&, int)
{
  return std::make_unique<NativeCalls>(description_of(symbol), library);
}

}  // namespace terp
