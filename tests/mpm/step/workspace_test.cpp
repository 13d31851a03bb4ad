#include "mpm/step/passes.hpp"
#include "mpm/step/workspace.hpp"
#include "mpm/step/count_allocations.hpp"
#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<bool> counting{false};
std::atomic<int> n_allocations{0};

void* allocate_or_null(std::size_t n)
{
  if (counting.load(std::memory_order_relaxed)) n_allocations.fetch_add(1);
  return std::malloc(n > 0 ? n : 1);
}

void* allocate(std::size_t n)
{
  if (void* p = allocate_or_null(n)) return p;
  throw std::bad_alloc();
}

void* allocate_aligned(std::size_t n, std::align_val_t alignment)
{
  if (counting.load(std::memory_order_relaxed)) n_allocations.fetch_add(1);
  const auto a = static_cast<std::size_t>(alignment);
  if (void* p = std::aligned_alloc(a, (n + a - 1) / a * a)) return p;
  throw std::bad_alloc();
}

/// Not inlined: GCC takes free() for the wrong partner of operator new where it sees through one of the two only.
[[gnu::noinline]] void release(void* p) noexcept { std::free(p); }

}  // namespace

// Every allocation of this test program passes here; they are counted while `counting` is set.
void* operator new(std::size_t n) { return allocate(n); }
void* operator new[](std::size_t n) { return allocate(n); }
void* operator new(std::size_t n, const std::nothrow_t&) noexcept { return allocate_or_null(n); }
void* operator new[](std::size_t n, const std::nothrow_t&) noexcept { return allocate_or_null(n); }
void* operator new(std::size_t n, std::align_val_t a) { return allocate_aligned(n, a); }
void* operator new[](std::size_t n, std::align_val_t a) { return allocate_aligned(n, a); }
void operator delete(void* p) noexcept { release(p); }
void operator delete[](void* p) noexcept { release(p); }
void operator delete(void* p, std::size_t) noexcept { release(p); }
void operator delete[](void* p, std::size_t) noexcept { release(p); }
void operator delete(void* p, const std::nothrow_t&) noexcept { release(p); }
void operator delete[](void* p, const std::nothrow_t&) noexcept { release(p); }
void operator delete(void* p, std::align_val_t) noexcept { release(p); }
void operator delete[](void* p, std::align_val_t) noexcept { release(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { release(p); }
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept { release(p); }

int terp::test::allocations_during(Simulation& s, std::int64_t n_steps)
{
  n_allocations = 0;
  counting = true;
  make_steps(s, n_steps);
  counting = false;
  return n_allocations;
}

namespace {

/// The coarse column, already on the move.
Case moving_column(const char* scheme)
{
  Case c = column(scheme, 0.25);
  c.bodies[0].velocity = {3.0, 0.0};
  return c;
}

TEST(Workspace, TheCounterCounts)
{
  n_allocations = 0;
  counting = true;
  std::vector<Real> some(100);
  counting = false;
  EXPECT_EQ(n_allocations, 1);
  EXPECT_EQ(some.size(), 100u);
}

TEST(Workspace, AMovingColumnAsksForNoMemoryAfterTheFirstStep)
{
  for (const char* scheme : {"standard_mpm", "mpm_mixed", "mpm_gp"})
    for (const int threads : {1, 2}) {
      Simulation s(moving_column(scheme), threads);
      test::make_steps(s);
      const auto cells = s.state.points.occupied().size();
      const std::int64_t bytes = s.state.points.reserved_bytes();
      EXPECT_EQ(allocations_during(s, 400), 0) << scheme << " on " << threads;
      EXPECT_EQ(s.state.points.reserved_bytes(), bytes) << scheme;  // the slabs do not come from operator new
      EXPECT_GT(s.state.points.occupied().size(), cells + 10);      // points did enter new cells
    }
}

TEST(Workspace, FitsItsArraysToTheOccupiedCellsAndListsTheirNodesInOrder)
{
  Case c = free_box("mpm_gp", {0.25, 0.25}, {0.75, 0.5});  // cells 17 and 18 of a mesh of 16 x 8
  Simulation s(c);
  EXPECT_EQ(s.work.corners.size(), 2u);
  EXPECT_GE(s.work.gauss.size(), 2u);
  EXPECT_EQ(s.work.pressure.size(), 2u);
  EXPECT_THAT(s.work.active_nodes, ElementsAre(18, 19, 20, 35, 36, 37));
  EXPECT_EQ(s.work.node.size(), s.model.mesh->nodes.size());
}

TEST(Workspace, KeepsTheTimeOfEachPass)
{
  Case c = column("mpm_gp");
  c.materials[0].softening.length = 1.0;
  c.bodies[0].velocity = {2.0, 0.0};  // it softens at once
  c.method.relaxation_time = 1e-9;
  Simulation s(c);
  test::make_steps(s, 20);
  for (int pass = 0; pass < n_passes; ++pass) EXPECT_GT(s.work.seconds[pass], 0.0) << pass_names[pass];
}

}  // namespace
