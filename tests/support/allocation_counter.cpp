// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
// Replaces every form of the global operator new, so only a program that wants it counted links it. The forms
// that return null are among them: a sanitizer takes memory of its own operator new in our delete for a
// mistake.
#include "tests/support/allocation_counter.h"

#include <cstdlib>
#include <new>

namespace {

thread_local std::uint64_t count = 0;

void* countedOrNull(std::size_t size) noexcept
{
  ++count;
  return std::malloc(size);
}

void* countedOrNull(std::size_t size, std::align_val_t alignment) noexcept
{
  ++count;
  const auto step = static_cast<std::size_t>(alignment);
  return std::aligned_alloc(step, (size + step - 1) / step * step);
}

void* orThrow(void* memory)
{
  if (!memory) throw std::bad_alloc();
  return memory;
}

} // namespace

void* operator new(std::size_t size)
{
  return orThrow(countedOrNull(size));
}
void* operator new[](std::size_t size)
{
  return orThrow(countedOrNull(size));
}
void* operator new(std::size_t size, std::align_val_t alignment)
{
  return orThrow(countedOrNull(size, alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment)
{
  return orThrow(countedOrNull(size, alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  return countedOrNull(size);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept
{
  return countedOrNull(size);
}
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept
{
  return countedOrNull(size, alignment);
}
void* operator new[](std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept
{
  return countedOrNull(size, alignment);
}
void operator delete(void* memory) noexcept
{
  std::free(memory);
}
void operator delete[](void* memory) noexcept
{
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept
{
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept
{
  std::free(memory);
}
void operator delete[](void* memory, std::align_val_t) noexcept
{
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept
{
  std::free(memory);
}
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept
{
  std::free(memory);
}

namespace esm::test {

std::uint64_t allocationsOfThisThread() noexcept
{
  return count;
}

} // namespace esm::test
