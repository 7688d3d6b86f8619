// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/trace_ring.h"

namespace esm {

void TraceRing::push(const TraceSample& sample) noexcept
{
  const std::uint64_t tick = m_count.load(std::memory_order_relaxed);
  Slot& slot = m_slots[tick % kCapacity];
  slot.number.store(2 * tick + 1, std::memory_order_release);
  std::size_t w = 0;
  slot.word[w++].store(sample.time, std::memory_order_release);
  for (const Eigen::Vector3d* part : {&sample.position, &sample.velocity, &sample.force})
    for (int i = 0; i < 3; ++i) slot.word[w++].store((*part)[i], std::memory_order_release);
  slot.word[w++].store(sample.work, std::memory_order_release);
  slot.word[w++].store(sample.lateness, std::memory_order_release);
  slot.number.store(2 * tick + 2, std::memory_order_release);
  m_count.store(tick + 1, std::memory_order_release);
}

bool TraceRing::read(std::uint64_t tick, TraceSample& sample) const noexcept
{
  const Slot& slot = m_slots[tick % kCapacity];
  if (slot.number.load(std::memory_order_acquire) != 2 * tick + 2) return false;
  std::size_t w = 0;
  sample.time = slot.word[w++].load(std::memory_order_acquire);
  for (Eigen::Vector3d* part : {&sample.position, &sample.velocity, &sample.force})
    for (int i = 0; i < 3; ++i) (*part)[i] = slot.word[w++].load(std::memory_order_acquire);
  sample.work = slot.word[w++].load(std::memory_order_acquire);
  sample.lateness = slot.word[w++].load(std::memory_order_acquire);
  return slot.number.load(std::memory_order_relaxed) == 2 * tick + 2;
}

void TraceRing::takeNew(std::vector<TraceSample>& samples)
{
  const std::uint64_t count = m_count.load(std::memory_order_acquire);
  if (count > m_next + kCapacity) m_next = count - kCapacity;
  for (TraceSample sample; m_next < count; ++m_next)
    if (read(m_next, sample)) samples.push_back(sample);
}

} // namespace esm
