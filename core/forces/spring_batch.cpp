// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/spring_law.h"

#include <cmath>

namespace esm {

namespace {

template <class Value>
void putInto(const std::vector<std::size_t>& order, std::vector<Value>& values)
{
  std::vector<Value> ordered;
  ordered.reserve(values.size() + 3); // to be padded
  for (const std::size_t place : order) ordered.push_back(values[place]);
  values.swap(ordered);
}

} // namespace

void SpringBatch::append(const SpringNet& net, Index s)
{
  a.push_back(net.ends(0, s));
  b.push_back(net.ends(1, s));
  restLength.push_back(net.restLength[s]);
  stiffness.push_back(net.stiffness[s]);
  viscosity.push_back(net.viscosity[s]);
  parameter.push_back(net.lawParameter[s]);
  spring.push_back(s);
}

void SpringBatch::finish(std::size_t nodeCount)
{
  count = a.size();
  const std::vector<std::size_t> order = conflictFreeOrder(nodeCount, a, b);
  for (std::vector<Index>* values : {&a, &b, &spring}) putInto(order, *values);
  for (std::vector<double>* values : {&restLength, &stiffness, &viscosity, &parameter})
    putInto(order, *values);
  while (a.size() % 4 != 0) {
    a.push_back(a.front());
    b.push_back(a.front());
    restLength.push_back(1.0);
    stiffness.push_back(0.0);
    viscosity.push_back(0.0);
    parameter.push_back(law == SpringLaw::Table ? 0.0 : 1.0);
  }
  factor = stiffness;
  growth.assign(a.size(), 0.0);
  rootViscosity.resize(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    rootViscosity[i] = std::sqrt(viscosity[i]);
    const double scale = parameter[i] / restLength[i];
    if (law == SpringLaw::Cubic) growth[i] = scale / restLength[i];
    if (law != SpringLaw::Exponential) continue;
    factor[i] = stiffness[i] / scale;
    growth[i] = scale;
  }
}

} // namespace esm
