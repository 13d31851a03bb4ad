// What is measured while a run goes on: a follower starts, looks on, saves itself and sums up. The followers stand in
// `run/measure`; neither State nor the loop nor the checkpoint knows one of them by name.
#pragma once

#include "run/report/run_table.hpp"

#include <memory>
#include <span>
#include <vector>

namespace terp {

struct Model;
struct State;
struct Summary;
struct LedgerContext;
struct TotalsRequest;
struct Workspace;
class ArrayWriter;
class ArrayReader;

/// Each member but the constructor may be left out.
class Follower {
 public:
  virtual ~Follower() = default;

  /// Looks at the soil as it is at t = 0, and forgets what was before: called at seeding, and again when the soil has
  /// settled.
  virtual void start(const Model&, const State&) {}
  /// After each step, when its forces and works are known, before points go to other cells. Must be cheap.
  virtual void step(const Model&, const Workspace&) {}
  /// At each ledger row, before the walk over the points: what the walk shall find besides.
  virtual void request(TotalsRequest&) {}
  /// At each ledger row, in the order of the list. values: its columns of the ledger, NaN so far.
  virtual void row(const LedgerContext&, std::span<Real> values);
  /// At each ledger row: the new rows of its own table.
  virtual std::vector<TableRow> rows(const Model&, const State&) { return {}; }
  /// Somebody else has set values of the points.
  virtual void points_were_set(const Model&, const State&) {}
  /// A stage counts displacement and strain from now on; the state still has those of before.
  virtual void count_displacement_anew(const Model&, const State&) {}
  /// In a stage that ends with the verdict, as often as its soil is looked at for rest (RestMarks): whether what this
  /// follower asks is known, and nothing more comes. is_first: what was seen at looks before counts no more.
  virtual bool is_answered(const Model&, const State&, bool /*is_first*/) { return false; }
  /// In such a stage: whether time alone still decides it, so that soil at rest is no end.
  virtual bool waits(const State&) const { return false; }
  /// At each frame.
  virtual void frame(const Model&, const State&) {}
  /// What the summary says of it.
  virtual void summarise(const Model&, const State&, Summary&) const {}
  /// Into a checkpoint, under names of its own.
  virtual void save(ArrayWriter&) const {}
  /// From a checkpoint; points, clock and works of the state are there. Throws FileError if an array does not fit.
  virtual void load(const Model&, const State&, const ArrayReader&) {}
  /// After load(), in a run that begins with the end of another one. `before` is the model of that one, the state that
  /// of this run at t = 0, as if it had begun there.
  virtual void begin_from(const Model& /*before*/, const Model&, const State& /*first*/) {}
};

/// A kind of follower and what it reports.
struct FollowerType {
  std::string_view name;                            ///< also the folder of its arrays in a checkpoint
  std::vector<QuantityInfo> columns = {};           ///< of the ledger
  std::vector<QuantityInfo> summary = {};           ///< numbers that it puts into Summary::numbers
  std::shared_ptr<const RunTable> table = nullptr;  ///< of its own
  std::unique_ptr<Follower> (*make)() = nullptr;
};

template <class F>
std::unique_ptr<Follower> make_follower()
{
  return std::make_unique<F>();
}

using FollowerTypes = std::vector<const FollowerType*>;

struct ActiveFollower {
  const FollowerType* type;
  std::unique_ptr<Follower> follower;
};

/// Makes the followers of the model and starts them on the state.
void start_followers(const Model& model, State& state);

/// One step of a run: that of the soil, with what the followers look at.
void make_step(const Model& model, State& state, Workspace& work);

/// The tables of a run with these followers.
std::vector<std::shared_ptr<const RunTable>> tables_with(const FollowerTypes& followers);

}  // namespace terp
