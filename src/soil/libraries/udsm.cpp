// UDSM, the user-defined soil model of Plaxis: the subroutine USER_MOD with a number of the task, six components xx yy
// zz xy yz zx, engineering shear, tension positive. yz and zx are zero. One call for each point: task 2, stresses. A
// point has task 1, initial state variables, before that in the first call for its soil, which a row of its own
// remembers. How many state variables there are, task 4, is asked when the library is loaded.
//
// Terp keeps the water: IsUndr and Bulk_W are 0. The matrix D is not used.

#include "math/errors.hpp"
#include "os/own_copy.hpp"
#include "soil/libraries/fenced_arrays.hpp"

#include <fmt/format.h>

namespace terp {
namespace {

using UserMod = void (*)(int* task, int* model, int* is_undrained, int* step, int* iteration, int* element, int* point,
    double* x, double* y, double* z, double* time0, double* dtime, double* props, double* sig0, double* swp0,
    double* stvar0, double* deps, double* d, double* bulk_w, double* sig, double* swp, double* stvar, int* ipl,
    int* n_stat, int* non_symmetric, int* stress_dependent, int* time_dependent, int* tangent, int* project_folder,
    int* length_of_folder, int* abort);

enum Task { initial_state = 1, stresses = 2, number_of_state = 4 };
constexpr int most_state_of_udsm = 100;

/// The arguments of a call, of the size that Plaxis gives them.
struct UdsmArguments {
  double sig0[20] = {}, sig[most_tens] = {}, deps[12] = {}, d[36] = {};
  double x = 0.0, y = 0.0, z = 0.0, time = 0.0, dtime = 0.0, swp0 = 0.0, swp = 0.0, bulk_w = 0.0;
  int model = 1, undrained = 0, step = 1, iteration = 1, element = 1, point = 1, ipl = 0, n_stat = 0;
  int non_symmetric = 0, stress_dependent = 0, time_dependent = 0, tangent = 0, folder[1] = {}, length = 0, abort = 0;

  void call(UserMod law, int task, double* props, double* stvar0, double* stvar)
  {
    law(&task, &model, &undrained, &step, &iteration, &element, &point, &x, &y, &z, &time, &dtime, props, sig0, &swp0,
        stvar0, deps, d, &bulk_w, sig, &swp, stvar, &ipl, &n_stat, &non_symmetric, &stress_dependent, &time_dependent,
        &tangent, folder, &length, &abort);
  }
};

class UdsmCalls final : public FortranCalls {
 public:
  UdsmCalls(void* symbol, const LibraryCase& library, const std::string& material)
      : FortranCalls(library, material, most_tens),
        law_(reinterpret_cast<UserMod>(symbol)),
        model_(static_cast<int>(library.model_number))
  {
  }

  /// State at the start and at the end of the step, each with its fences, and parameters.
  std::size_t n_scratch() const override { return n_first() + FencedArrays::n_numbers(n_state_, 0); }

  void run(LawPoints& points) const override
  {
    const FencedArrays arrays(points.scratch.data(), n_state_, parameters_.size(), points.beyond);
    const FencedArrays after(points.scratch.data() + n_first(), n_state_, 0, points.beyond);
    for (points.at = 0; points.at < points.n; ++points.at) {
      call(points, arrays, after, points.at);
      if (points.failed) return;
    }
  }

 private:
  std::size_t n_first() const { return FencedArrays::n_numbers(n_state_, parameters_.size()); }

  void call(LawPoints& points, const FencedArrays& arrays, const FencedArrays& after, int p) const
  {
    UdsmArguments a;
    double* const state = arrays.state();
    take(points, a.sig0, state);
    std::ranges::copy(parameters_, arrays.parameters());
    a.model = model_, a.step = static_cast<int>(points.step) + 1;
    a.element = points.cell[p] + 1, a.point = static_cast<int>(points.id[p]) + 1;
    a.x = points.x[0][p], a.y = points.x[1][p], a.time = points.time, a.dtime = points.dt;
    a.n_stat = static_cast<int>(n_state_);
    Real& was_called = points.state[n_state_][p];
    if (!(was_called > 0.0)) {
      std::copy_n(state, n_state_, after.state());
      a.call(law_, initial_state, arrays.parameters(), state, after.state());
    }
    for (int k = 0; k < n_tens; ++k) a.deps[k] = (k < 3 ? 1.0 : 2.0) * points.d_eps[k][p];
    std::copy_n(a.sig0, most_tens, a.sig);
    std::copy_n(state, n_state_, after.state());
    if (a.abort == 0) a.call(law_, stresses, arrays.parameters(), state, after.state());
    arrays.check(points);
    if (!points.failed) after.check(points);
    if (!points.failed && a.abort != 0) points.fail("the law asks to end the calculation (iAbort = {})", a.abort);
    if (points.failed || !is_plane({a.sig, most_tens}, stress_unit_, points)) return;
    give_back(a.sig, after.state(), points);
    was_called = 1.0;
  }

  UserMod law_;
  int model_;
};

[[noreturn]] void refuse_udsm(const char* key, const std::string& what, const std::string& detail)
{
  throw InputError(Problem{key, what, detail, "library"});
}

/// Task 4, in a copy of this process: nobody knows what a library does.
int ask_number_of_state(void* symbol, const LibraryCase& library)
{
  constexpr double limit_s = 10.0;
  int n = -1;
  const std::string fault = call_in_copy(
      [&](void* result) {
        UdsmArguments a;
        a.model = static_cast<int>(library.model_number);
        std::vector<double> state(most_state_of_udsm + 1), props(n_numbers_beyond);
        for (std::size_t k = 0; k < library.parameters.size() && k < props.size(); ++k)
          props[k] = library.parameters[k].value;
        std::vector<double> after = state;
        a.call(reinterpret_cast<UserMod>(symbol), number_of_state, props.data(), state.data(), after.data());
        *static_cast<int*>(result) = a.abort != 0 ? -1 : a.n_stat;
      },
      &n, sizeof n, limit_s);
  if (!fault.empty())
    refuse_udsm("library", "the library failed when it was asked for the number of its state variables",
        "A copy of this program asked it (IDTask = 4), and " + fault + '.');
  if (n < 0 || n > most_state_of_udsm)
    refuse_udsm("model_number", fmt::format("the library has no model {}", library.model_number),
        fmt::format("Asked for its number of state variables (IDTask = 4) it says {}.", n));
  return n;
}

}  // namespace

std::optional<LawVariables> describe_udsm(void* symbol, LibraryCase& library)
{
  const int n = ask_number_of_state(symbol, library);
  if (library.state.empty())
    for (int k = 1; k <= n; ++k) library.state.push_back({fmt::format("state_{}", k), 0.0});
  if (std::ssize(library.state) != n)
    refuse_udsm("state", fmt::format("the law has {} state variables, the case gives {}", n, library.state.size()),
        "Name all of them, or remove `state`: the law says how many it has.");
  return std::nullopt;
}

std::unique_ptr<LawCalls> make_udsm(void* symbol, const LibraryCase& library, const std::string& material, int)
{
  return std::make_unique<UdsmCalls>(symbol, library, material);
}

}  // namespace terp
