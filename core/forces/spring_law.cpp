// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/spring_law.h"

namespace esm {

const SpringLawKernel& springLawKernel(SpringLaw law) noexcept
{
  switch (law) {
  case SpringLaw::Linear:
    return linearLaw();
  case SpringLaw::Cubic:
    return cubicLaw();
  case SpringLaw::Exponential:
    return exponentialLaw();
  case SpringLaw::Table:
    return tableLaw();
  }
  return linearLaw();
}

/// Every law is f = k L g(e/L) with its own g, so that at constant e df/dL = (f - e f')/L; and e falls as L grows.
SpringSlopes springSlopes(const SpringNet& net, const SpringBatch& batch, std::size_t i, double e) noexcept
{
  const double k = batch.stiffness[i], rest = batch.restLength[i];
  if (!(k > 0.0) || (batch.tensionOnly && e <= 0.0)) return {};
  const SpringResponse response = springLawKernel(batch.law).respond(batch, i, e);
  SpringSlopes slopes;
  slopes.byStiffness = response.tension / k;
  slopes.byRestLength = -response.tangent;
  if (batch.law != SpringLaw::Linear) slopes.byRestLength += (response.tension - e * response.tangent) / rest;
  const Index s = batch.spring[i]; // its own law: the batch's is linear where the parameter is 0
  slopes.byParameter =
    springLawKernel(net.law[static_cast<std::size_t>(s)]).parameterSlope(k, rest, net.lawParameter[s], e);
  return slopes;
}

} // namespace esm
