// Entries that stand for soil are gathered without holes; the library sees its own unit of stress, and strains and
// times as its soil has them. Numbers go back only if the whole call is sound: after a fault the points keep the stress
// from before. Of several faults that of the least cell and number stays, so that the order of threads does not decide.
// A law that ends the program, or copies it, does so within a call, which is marked as long as it lasts.

#include "soil/libraries/library_material.hpp"

#include "os/own_copy.hpp"
#include "soil/laws/elastic_constants.hpp"

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <limits>

namespace terp {
namespace {

struct Room {
  LawPoints points;
  std::vector<Real> numbers;  ///< of the rows of the state
  std::vector<Index> entries;
  PointsBefore before;

  void fit(std::size_t n_state, std::size_t n_scratch)
  {
    numbers.resize(n_state * most_points_of_call);
    points.scratch.resize(n_scratch);
    points.state.resize(n_state);
    for (std::size_t k = 0; k < n_state; ++k) points.state[k] = numbers.data() + k * most_points_of_call;
    points.failed = false;
    points.cure = nullptr;
    points.at = LawPoints::unknown;
    points.why[0] = '\0';
  }
};

Room& room_of_thread()
{
  thread_local Room room;
  return room;
}

/// sigma : (d_eps - C^-1 (sigma - before)) [J/m^3]: what the elastic soil of these moduli does not store.
Real plastic_work(const std::array<Real, 4>& sigma, const std::array<Real, 4>& before, const std::array<Real, 4>& d_eps,
    const Moduli& moduli)
{
  std::array<Real, 4> change;
  for (int k = 0; k < 4; ++k) change[k] = sigma[k] - before[k];
  const Real mean = (change[0] + change[1] + change[2]) / 3.0;
  Real work = 0.0;
  for (int k = 0; k < 4; ++k) {
    const Real elastic = k < 3 ? (change[k] - mean) / (2.0 * moduli.shear) + mean / (3.0 * moduli.bulk)
                               : change[k] / (2.0 * moduli.shear);
    work += (k < 3 ? 1.0 : 2.0) * sigma[k] * (d_eps[k] - elastic);
  }
  return work;
}

constexpr int stopped_itself = 3;  // exit status of a run that stops itself

/// Of the thread: the law that it is in.
struct CallUnderWay {
  const char* material = nullptr;  ///< name; null: in none
  int n_forks = 0;                 ///< at its begin
};
thread_local CallUnderWay under_way;

/// At exit(), as STOP of Fortran calls it: the run would seem to have ended well. Of a copy its parent says it.
void refuse_end()
{
  if (under_way.material == nullptr || fork_count() != under_way.n_forks) return;
  std::fflush(nullptr);
  if (!is_copy())
    std::fprintf(stderr,
        "error: the law of material `%s` ended the program (STOP, XIT or exit)\n"
        "  left     what was written before, and the checkpoints, if any (docs/user_laws.md#when-the-law-fails)\n",
        under_way.material);
  std::_Exit(stopped_itself);
}

}  // namespace

std::shared_ptr<const OneAtATime> turns_of(const std::string& path)
{
  static const OneAtATime one;
  static std::vector<std::pair<std::string, std::shared_ptr<const OneAtATime>>> of_files;
  std::shared_ptr<const OneAtATime> found;
  one([&] {
    const auto known = std::ranges::find_if(of_files, [&](const auto& file) {
      std::error_code ignored;
      return file.first == path || std::filesystem::equivalent(file.first, path, ignored);
    });
    found = known != of_files.end() ? known->second
                                    : of_files.emplace_back(path, std::make_shared<const OneAtATime>()).second;
  });
  return found;
}

LibraryMaterial::LibraryMaterial(
    std::shared_ptr<const MaterialType> type, const LibraryInUse& in_use, std::span<const Real> values)
    : type_(std::move(type)),
      in_use_(in_use),
      moduli_{bulk_from_poisson(values[0], values[1]), values[0]},
      stiffening_(values[0] / in_use.shear_modulus)
{
  static const int registered = std::atexit(refuse_end);
  static_cast<void>(registered);
}

/// The strength: no other field of a library is derived.
Real LibraryMaterial::derived(int, const LawRows& rows) const
{
  return *rows.state(in_use_.strength_row) * in_use_.stress_unit;
}

Real LibraryMaterial::softened_strain() const { return std::numeric_limits<Real>::infinity(); }

std::string LibraryMaterial::fault() const { return has_fault_ ? fault_ : std::string(); }

void LibraryMaterial::update(const StressArrays<2>& arrays) const
{
  std::fill_n(arrays.plastic_work, arrays.n, 0.0);
  Room& room = room_of_thread();
  for (Index first = 0; first < arrays.n; first += most_points_of_call) {
    room.fit(in_use_.n_state, in_use_.calls->n_scratch());
    room.points.beyond = beyond_;
    take_points(arrays, first, room.points, room.entries);
    if (room.points.n == 0) continue;
    room.before.sigma = room.points.sigma;
    room.before.state = room.numbers;
    call(room.points);
    if (!room.points.failed) check(room.points);
    if (room.points.failed)
      keep_fault(room.points, room.before);
    else
      give_back(room.points, room.entries, arrays);
  }
}

void LibraryMaterial::take_points(
    const StressArrays<2>& arrays, Index first, LawPoints& points, std::vector<Index>& entries) const
{
  static const std::array<Index, 1> nowhere{0};
  static const std::array<Real, 1> no_size{0.0};
  static const Surroundings<2> none{.cells = nowhere, .cell_sizes = no_size};
  const Surroundings<2>& around = arrays.around != nullptr ? *arrays.around : none;
  const auto n_cells = static_cast<Index>(around.cells.size());
  const Index end = std::min(std::min(arrays.n, arrays.n_points), first + most_points_of_call);
  const Real stretch = std::sqrt(stiffening_);
  points.time = around.time, points.step = around.step, points.turned = around.turned;
  points.dt = arrays.dt * stretch;
  points.of_gauss_points = around.id == nullptr;
  points.n = 0;
  entries.clear();
  for (Index i = first; i < end; ++i) {
    if (around.cells[i % n_cells] < 0) continue;
    const int p = points.n++;
    entries.push_back(i);
    for (int k = 0; k < 4; ++k) points.sigma[k][p] = arrays.sigma[k][i] / in_use_.stress_unit;
    for (int k = 0; k < 4; ++k) points.d_eps[k][p] = stiffening_ * arrays.d_eps[k][i];
    for (std::size_t k = 0; k < in_use_.n_state; ++k) points.state[k][p] = arrays.law.state(k)[i];
    points.cell[p] = around.cells[i % n_cells];
    points.cell_size[p] = around.cell_sizes[i % n_cells];
    points.id[p] = around.id != nullptr ? static_cast<std::int64_t>(around.id[i]) : i / n_cells;
    points.d_spin[p] = around.d_spin != nullptr ? around.d_spin[i] : 0.0;
    for (int d = 0; d < 2; ++d) points.x[d][p] = around.x[d] != nullptr ? around.x[d][i] : 0.0;
  }
}

void LibraryMaterial::call(LawPoints& points) const
{
  const auto run = [&] {
    std::fenv_t environment;
    std::fegetenv(&environment);
    under_way = {in_use_.material.c_str(), fork_count()};
    try {
      in_use_.calls->run(points);
    } catch (const std::exception& error) {
      points.fail("the law threw an exception: {:.100}", error.what());
    } catch (...) {
      points.fail("the law threw an exception");
    }
    if (fork_count() != under_way.n_forks) std::_Exit(stopped_itself);  // a copy that the law made: no second Terp
    under_way = {};
    std::fesetenv(&environment);
  };
  if (in_use_.turns != nullptr && !is_copy())  // another thread may have had its turn when the copy was made
    (*in_use_.turns)(run);
  else
    run();
}

void LibraryMaterial::check(LawPoints& points) const
{
  const auto look = [&](const Real* row, const char* what) {
    for (int p = 0; p < points.n && !points.failed; ++p) {
      if (std::isfinite(row[p])) continue;
      points.at = p;
      points.fail("the law returned {} that is not a number", what);
    }
  };
  for (const auto& row : points.sigma) look(row.data(), "a stress");
  for (const Real* row : points.state) look(row, "a state variable");
}

void LibraryMaterial::give_back(
    const LawPoints& points, const std::vector<Index>& entries, const StressArrays<2>& arrays) const
{
  for (int p = 0; p < points.n; ++p) {
    const Index i = entries[p];
    std::array<Real, 4> sigma, before, d_eps;
    for (int k = 0; k < 4; ++k) {
      sigma[k] = points.sigma[k][p] * in_use_.stress_unit;
      before[k] = arrays.sigma[k][i];
      d_eps[k] = arrays.d_eps[k][i];
      arrays.sigma[k][i] = sigma[k];
    }
    arrays.plastic_work[i] = plastic_work(sigma, before, d_eps, moduli_);
    for (std::size_t k = 0; k < in_use_.n_state; ++k) arrays.law.state(k)[i] = points.state[k][p];
  }
}

std::string LibraryMaterial::describe_place(const LawPoints& points) const
{
  const char* const what = points.of_gauss_points ? "Gauss point" : "material point";
  const bool is_known = points.is_at_a_point() || points.n == 1;
  const int p = points.is_at_a_point() ? points.at : 0;
  return fmt::format("{}{} {} of cell {} at x = {:.4g} m, y = {:.4g} m",
      is_known ? "" : fmt::format("one of {} {}s that it had at once, the first: ", points.n, what), what, points.id[p],
      points.cell[p], points.x[0][p], points.x[1][p]);
}

std::string LibraryMaterial::describe_input(const LawPoints& points, const PointsBefore& before) const
{
  if (!points.is_at_a_point()) return {};
  const int p = points.at;
  return fmt::format(
      "  before   stress xx yy zz xy = {} Pa; strain increment {}; dt = {:.3g} s\n"
      "           state {}\n",
      list_of(4, [&](std::size_t k) { return before.sigma[k][p] * in_use_.stress_unit; }),
      list_of(4, [&](std::size_t k) { return points.d_eps[k][p]; }), points.dt,
      list_of(in_use_.n_state, [&](std::size_t k) { return before.state[k * most_points_of_call + p]; }));
}

void LibraryMaterial::keep_fault(const LawPoints& points, const PointsBefore& before) const
{
  const auto advice =
      points.cure != nullptr ? points.cure : "the law with these numbers by itself; then mend the library";
  std::string text = fmt::format(
      "{}\n\n"
      "  where    material `{}`, {}\n"
      "  library  {}\n"
      "{}"
      "  try      {}",
      points.why.data(), in_use_.material, describe_place(points), in_use_.title, describe_input(points, before),
      advice);
  faults_([&] {
    const int p = points.is_at_a_point() ? points.at : 0;
    const std::pair number(points.cell[p], points.id[p]);
    if (has_fault_ && number >= place_of_fault_) return;
    place_of_fault_ = number;
    fault_ = std::move(text);
    has_fault_ = true;
  });
}

}  // namespace terp
