// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/few_springs.h"

#include "core/forces/force_model.h"

#include <algorithm>

namespace esm {

FewSprings::FewSprings(const SpringNet& net, std::span<const Index> springs)
{
  SharedTables tables;
  for (const Index s : springs) {
    const auto place = static_cast<std::size_t>(s);
    const SpringLaw law = effectiveLaw(net.law[place], net.lawParameter[s]);
    const bool damped = net.viscosity[s] > 0.0, tensionOnly = net.tensionOnly[place] != 0;
    auto batch = std::find_if(m_batches.begin(), m_batches.end(), [&](const SpringBatch& known) {
      return known.law == law && known.damped == damped && known.tensionOnly == tensionOnly;
    });
    if (batch == m_batches.end()) {
      batch = m_batches.emplace(batch);
      batch->law = law;
      batch->damped = damped;
      batch->tensionOnly = tensionOnly;
      if (law == SpringLaw::Table && !tables)
        tables = std::make_shared<std::vector<TableLines>>(net.tables.begin(), net.tables.end());
      if (law == SpringLaw::Table) batch->tables = tables;
    }
    batch->append(net, s);
  }
  for (SpringBatch& batch : m_batches) batch.finishAsGiven();
}

double FewSprings::energy(const Lanes* x) const noexcept
{
  double energy = 0.0;
  for (const SpringBatch& batch : m_batches) energy += springLawKernel(batch.law).energy(batch, x);
  return energy;
}

void FewSprings::tensions(const Lanes* x, const Lanes* v, double* tension) const noexcept
{
  for (const SpringBatch& batch : m_batches) springLawKernel(batch.law).tensions(batch, x, v, tension);
}

} // namespace esm
