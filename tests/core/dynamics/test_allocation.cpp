// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Counts every allocation of the program: replaces the global operator new, so this is a program of its own.
#include "tests/support/nets.h"
#include "tests/support/physics.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<long> allocations{0};
}

void* operator new(std::size_t size)
{
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, std::align_val_t alignment)
{
  ++allocations;
  const auto border = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(border, (size + border - 1) / border * border)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept
{
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept
{
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept
{
  std::free(memory);
}

namespace esm::testing {

// After the first frame (buffers and the step bound are made then) explicit frames do not allocate, checks of
// the accuracy included.
TEST(Allocation, ExplicitFramesDoNotAllocate)
{
  for (const char* solver : {"verlet", "rk4"}) {
    SpringNet net = randomNet(3, 20, SpringLaw::Exponential);
    net.fixed[0] = 1;
    Loads loads;
    loads.gravity = {0, 0, -9.81};
    SolverSettings settings;
    settings.solver = solver;
    Simulation simulation = simulate(net, loads, settings);
    const ToolSpring tool{4, {1, 1, 1}, {0, 0, 0}, 20.0, 0.1};
    simulation.setTools({&tool, 1});
    simulation.advance(1.0 / 60.0);
    const long before = allocations;
    for (int frame = 0; frame < 30; ++frame) {
      simulation.setTools({&tool, 1});
      simulation.advance(1.0 / 60.0);
    }
    EXPECT_EQ(allocations - before, 0) << solver;
  }
}

} // namespace esm::testing
