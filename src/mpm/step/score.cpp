// Chooses the kernels of a run. Part of the kernels: each copy has tables of its own (os/kernel_table.hpp).

#include "mpm/step/score.hpp"

#include "math/errors.hpp"
#include "mpm/step/core_kernels.hpp"
#include "mpm/step/score_places.hpp"
#include "mpm/step/step_model.hpp"
#include "mpm/step/workspace.hpp"

namespace terp {

#define TERP_FEATURE(slot, Name) extern const FeatureKernels feature_kernels_##slot;
#include "mpm/features/features.def"
#undef TERP_FEATURE

namespace {

constexpr const FeatureKernels* features[] = {
#define TERP_FEATURE(slot, Name) &feature_kernels_##slot,
#include "mpm/features/features.def"
#undef TERP_FEATURE
};

ScoreKey key_of(const StepModel& model, const Workspace& work)
{
  ScoreKey key{model.scheme->kernels(model.method.shares).data()};
  for (std::size_t k = 0; k < std::size(features); ++k)
    if (features[k]->present(model, work)) key.features |= std::uint64_t{1} << k;
  return key;
}

/// Over what a walk goes that has a kernel over this.
Over walk_over(Over over) { return over == Over::once || over == Over::nodes ? over : Over::group; }

class Assembly {
 public:
  explicit Assembly(Score& score) : score_(score)
  {
    score_.n_kernels = score_.n_segments = score_.n_walks = score_.n_strips = 0;
  }

  /// Kernels of one place and name are one, and run once.
  void add(const PlaceInfo& at, const Kernel& kernel)
  {
    Score& s = score_;
    for (int k = s.n_kernels; k-- > 0 && s.kernels[k]->place == kernel.place;)
      if (s.kernels[k]->name == kernel.name) return;
    TERP_ASSERT(s.n_kernels < Score::most);
    const int over_walk = static_cast<int>(walk_over(at.over));
    const bool new_walk = s.n_walks == 0 || waits_ || static_cast<int>(s.walks[s.n_walks - 1].over) != over_walk ||
                          s.walks[s.n_walks - 1].pass != at.pass;
    if (new_walk) s.walks[s.n_walks++] = {walk_over(at.over), at.pass, s.n_segments, s.n_segments};
    waits_ = false;
    if (new_walk || s.segments[s.n_segments - 1].over != at.over) {
      s.segments[s.n_segments++] = {at.over, s.n_kernels, s.n_kernels};
      ++s.walks[s.n_walks - 1].end;
    }
    s.kernels[s.n_kernels++] = &kernel;
    ++s.segments[s.n_segments - 1].end;
  }
  void add_strip(const Kernel& kernel)
  {
    TERP_ASSERT(score_.n_kernels < Score::most);
    score_.kernels[score_.n_kernels++] = &kernel;
    ++score_.n_strips;
  }
  void wait() { waits_ = true; }

 private:
  Score& score_;
  bool waits_ = false;
};

void choose(ScoreOf of, const ScoreKey& key, std::span<const Kernel> scheme, unsigned home, Score& score)
{
  score.key = key;
  score.home = home;
  Assembly assembly(score);
  const auto add = [&](bool strips) {
    for (const PlaceInfo& at : score_places) {
      if ((at.homes & home) == 0 || (at.in & of) == 0 || (at.over == Over::strip) != strips) continue;
      if (at.over == Over::wait) assembly.wait();
      const auto add_all = [&](std::span<const Kernel> kernels) {
        for (const Kernel& kernel : kernels)
          if (&score_places[static_cast<int>(kernel.place)] == &at && (kernel.homes & home) != 0)
            strips ? assembly.add_strip(kernel) : assembly.add(at, kernel);
      };
      add_all(core_kernels());
      add_all(scheme);
      for (std::size_t k = 0; k < std::size(features); ++k)
        if ((key.features >> k & 1) != 0) add_all(features[k]->kernels);
    }
  };
  add(false);
  add(true);
}

}  // namespace

const Score& score_now(ScoreOf of, const StepModel& model, Workspace& work)
{
  Score& score = of == in_step ? work.scores.step : of == in_forces ? work.scores.forces : work.scores.strain;
  const ScoreKey key = key_of(model, work);
  if (score.n_kernels == 0 || score.key != key)
    choose(of, key, model.scheme->kernels(model.method.shares), model.scheme->home(model.method.shares), score);
  return score;
}

const Score& score_compiled(const StepModel& model, Workspace& work) { return score_now(in_step, model, work); }

}  // namespace terp
