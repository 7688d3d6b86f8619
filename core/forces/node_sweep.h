// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace esm {

/// What a method does with the nodes before a pass over the springs: the pass calls it for each range of
/// nodes right before that range's own springs, so that these find in the caches what it wrote. Refers to a
/// callable sweep(first, count) that must outlive the pass, must not throw, and whose result at a node must
/// depend on no other node's. Empty: nothing to do.
class NodeSweep {
public:
  NodeSweep() = default;
  template <class Sweep>
  NodeSweep(const Sweep& sweep) noexcept // NOLINT(google-explicit-constructor): lambdas are passed as such
    : m_sweep(&sweep), m_call([](const void* of, std::size_t first, std::size_t count) noexcept {
        (*static_cast<const Sweep*>(of))(first, count);
      })
  {}
  explicit operator bool() const noexcept { return m_call != nullptr; }
  void operator()(std::size_t first, std::size_t count) const noexcept { m_call(m_sweep, first, count); }

private:
  using Call = void (*)(const void*, std::size_t, std::size_t) noexcept;
  const void* m_sweep = nullptr;
  Call m_call = nullptr;
};

} // namespace esm
