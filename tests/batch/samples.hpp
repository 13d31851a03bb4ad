// A study of a column that collapses within a second or stands, small and coarse.
#pragma once

#include "io/files/files.hpp"
#include "batch/engine.hpp"
#include "support/paths.hpp"

namespace terp::test {

/// 2 m high, 4 m wide, cells of 1 m, 2 x 2 points: 32 points.
inline const std::string column_case = R"([time]
end = 0.8
courant = 0.5
[mesh]
size = [10.0, 3.0]
cell = 1.0
[[body]]
material = "clay"
box = [[0.0, 0.0], [4.0, 2.0]]
points_per_cell = [2, 2]
[material.clay]
model = "tresca_softening"
density = 1900.0
shear_modulus = 1.0e6
poisson_ratio = 0.45
su_peak = 6.0e3
sensitivity = 2.0
eta = 5.0
[forces]
gravity = [0.0, -9.81]
[boundary]
left = "roller"
bottom = "fixed"
[output]
ledger = { every = 0.1 }
)";

inline const std::string column_study = R"(case = "column.toml"
seed = 3
[[random]]
key = "material.clay.su_peak"
distribution = "lognormal"
mean = "8 kPa"
cov = 0.4
[estimator]
kind = "monte_carlo"
[stop]
number = 12
[events]
volume = 1.0
displacement = 0.3
)";

inline const std::string field_study = R"(case = "column.toml"
seed = 3
[[field]]
key = "material.clay.su_peak"
cov = 0.3
theta = [8.0, 4.0]
[estimator]
kind = "monte_carlo"
[stop]
number = 6
[events]
volume = 1.0
displacement = 0.3
)";

inline std::string write_study(
    const std::string& folder, const std::string& study, const std::string& column = column_case)
{
  write_file_atomically(folder + "/column.toml", column);
  write_file_atomically(folder + "/demo.toml", study);
  return folder + "/demo.toml";
}

/// `text` with the first `from` replaced; throws where it does not stand there.
inline std::string changed(std::string text, const std::string& from, const std::string& to)
{
  return text.replace(text.find(from), from.size(), to);
}

inline StudySettings settings_of(const std::string& text) { return read_study_text(text, "demo.toml"); }

/// The study with that text in a folder, which must stay as long as files of it are read.
inline Study study_in(const std::string& folder, const std::string& study, const std::string& column = column_case)
{
  return prepare_study(read_study(write_study(folder, study, column)));
}

inline Study study_of(const std::string& study, const std::string& column = column_case)
{
  const ScratchFolder folder;
  return study_in(folder.path(), study, column);
}

/// A study in a folder, which has one more for each store.
struct StudyWithStores {
  ScratchFolder folder;
  Study study;
  explicit StudyWithStores(const std::string& text, const std::string& column = column_case)
      : study(study_in(folder.path(), text, column))
  {
  }

  std::string of(const std::string& store) const
  {
    const std::string path = folder.path() + '/' + store;
    make_folder(path);
    return path;
  }
  /// Solves what is missing there, and reads all that is there then.
  Realisations run(const std::string& store, const EngineOptions& options = {}) const
  {
    Realisations rows = read_store(study, of(store)).rows;
    run_realisations(study, of(store), options, never_stop, rows);
    return read_store(study, of(store)).rows;
  }
};

/// Realisations of a study that nobody solved, with its inputs and with results that are all `outcome(number)`.
template <class Outcome>
Realisations rows_without_runs(const Study& study, Outcome&& outcome)
{
  Realisations rows;
  for (Index k = 0; k < study.n_realisations; ++k) {
    Realisation r{.number = k, .inputs = draw_realisation(study, k).inputs};
    r.outcomes.assign(study_outcomes().size(), outcome(static_cast<Real>(k)));
    rows.emplace(k, r);
  }
  return rows;
}

/// A change of a good study, and a part of the message on it.
struct Mistake {
  std::string from, to, expected = {};
};

/// Without the folder of the study; "" where it is taken.
inline std::string message_on(const std::string& good, const Mistake& mistake)
{
  const ScratchFolder folder;
  const std::string study = changed(good, mistake.from, mistake.to);
  std::string message = refusal<CaseError>([&] { study_in(folder.path(), study); });
  for (std::size_t at; (at = message.find(folder.path() + '/')) != std::string::npos;)
    message.erase(at, folder.path().size() + 1);
  return message;
}

inline void expect_messages(const std::string& good, const std::vector<Mistake>& mistakes)
{
  for (const Mistake& mistake : mistakes) {
    EXPECT_FALSE(mistake.expected.empty()) << mistake.to;
    EXPECT_THAT(message_on(good, mistake), HasSubstr(mistake.expected)) << mistake.to;
  }
}

}  // namespace terp::test
