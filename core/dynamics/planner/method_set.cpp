// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/planner/method_set.h"

#include <algorithm>

namespace esm {

MethodSet::MethodSet()
{
  for (const IntegratorEntry& entry : integratorTable()) {
    m_methods.push_back({entry.make(), false});
    m_traits.push_back({entry.role, static_cast<double>(m_methods.back().integrator->order()),
                        entry.typicalError, entry.offset, entry.typicalErrorOfWaves,
                        find(entry.sharperTwin)});
    if (entry.role == MethodRole::Implicit) m_implicit = m_methods.size() - 1;
  }
  m_plain = find("leapfrog").value();
  m_descent = find("descent").value();
  m_blocks = find("block-descent").value();
}

std::optional<Method> MethodSet::find(std::string_view name) noexcept
{
  const std::span<const IntegratorEntry> table = integratorTable();
  const auto found = std::ranges::find(table, name, &IntegratorEntry::name);
  return found == table.end() ? std::nullopt : std::optional(static_cast<Method>(found - table.begin()));
}

void MethodSet::tune(const FastestMode& mode)
{
  m_mode = mode;
  for (const Entry& entry : m_methods) entry.integrator->tune(*m_system, mode);
}

void MethodSet::layOut(Method method)
{
  Entry& entry = m_methods[method];
  if (entry.isLaidOut) return;
  entry.integrator->prepare(*m_system);
  entry.isLaidOut = true;
}

void MethodSet::dropLayouts() noexcept
{
  for (Entry& entry : m_methods) entry.isLaidOut = false;
}

void MethodSet::restart() noexcept
{
  for (const Entry& entry : m_methods)
    if (entry.isLaidOut) entry.integrator->restart();
}

void MethodSet::restart(Method method) noexcept
{
  if (m_methods[method].isLaidOut) at(method).restart();
}

void MethodSet::toolsMoved() noexcept
{
  for (const Entry& entry : m_methods)
    if (entry.isLaidOut) entry.integrator->toolsMoved();
}

void MethodSet::constraintsChanged()
{
  for (const Entry& entry : m_methods)
    if (entry.isLaidOut) entry.integrator->constraintsChanged(*m_system);
}

} // namespace esm
