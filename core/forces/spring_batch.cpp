// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/spring_ends.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>

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

bool areEqual(const std::vector<double>& values) noexcept
{
  return std::adjacent_find(values.begin(), values.end(), std::not_equal_to<>()) == values.end();
}

} // namespace

TableLines::TableLines(const ForceTable& table)
  : strain(table.strain.begin(), table.strain.end() - 1), force(table.force.begin(), table.force.end() - 1)
{
  double sum = 0.0;
  for (std::size_t j = 0; j < count(); ++j) {
    const double length = table.strain[j + 1] - table.strain[j];
    slope.push_back((table.force[j + 1] - table.force[j]) / length);
    integral.push_back(sum);
    sum += 0.5 * (table.force[j] + table.force[j + 1]) * length;
  }
}

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
  const std::vector<std::size_t> order = conflictFreeOrder(nodeCount, {a, b});
  for (std::vector<Index>* values : {&a, &b, &spring}) putInto(order, *values);
  for (std::vector<double>* values : {&restLength, &stiffness, &viscosity, &parameter})
    putInto(order, *values);
  finishAsGiven();
}

void SpringBatch::finishAsGiven()
{
  count = a.size();
  findAlike();
  findTable();
  while (a.size() % 4 != 0) {
    a.push_back(a.front());
    b.push_back(a.front());
    restLength.push_back(alike ? 0.0 : 1.0); // no energy although it has the others' stiffness
    stiffness.push_back(0.0);
    viscosity.push_back(0.0);
    parameter.push_back(law == SpringLaw::Table ? 0.0 : 1.0);
  }
  rootViscosity.resize(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) rootViscosity[i] = std::sqrt(viscosity[i]);
  fillRecord();
}

void SpringBatch::set(std::size_t place, double newStiffness, double newViscosity, double newParameter)
{
  stiffness[place] = newStiffness;
  viscosity[place] = newViscosity;
  parameter[place] = newParameter;
  rootViscosity[place] = std::sqrt(newViscosity);
  if (!alike) putRecord(place);
}

std::size_t SpringBatch::changed()
{
  const bool wasAlike = alike;
  const std::size_t looked = findAlike();
  if (!alike && !wasAlike) return looked;
  for (std::size_t i = count; i < a.size(); ++i) restLength[i] = alike ? 0.0 : 1.0;
  fillRecord();
  return looked + count;
}

/// @return springs looked at
std::size_t SpringBatch::findAlike()
{
  shared.clear();
  alike = false;
  if (!canBeAlike(law) || count == 0) return 0;
  const auto isUnlike = [this](std::size_t i) {
    return stiffness[i] != stiffness[0] || viscosity[i] != viscosity[0];
  };
  if (m_unlike > 0 && isUnlike(m_unlike)) return 1;
  m_unlike = 0;
  std::size_t i = 1;
  while (i < count && !isUnlike(i)) ++i;
  if (i < count) {
    m_unlike = i;
    return i;
  }
  alike = true;
  for (const double value : {stiffness.front(), viscosity.front(), std::sqrt(viscosity.front())})
    shared.push_back(Lanes{value, value, value, value});
  return count;
}

void SpringBatch::findTable()
{
  const bool isOne = law == SpringLaw::Table && count > 0 && areEqual(parameter);
  table = isOne ? &(*tables)[static_cast<std::size_t>(parameter.front())] : nullptr;
}

void SpringBatch::fillRecord()
{
  const std::size_t rows = recordRows();
  record.assign(a.size() / 4 * rows, Lanes{0, 0, 0, 0});
  for (std::size_t i = 0; i < a.size(); ++i) putRecord(i);
  ends.clear();
  for (std::size_t group = 0; damped && group < a.size() / 4; ++group) ends.push_back(record[group * rows]);
}

void SpringBatch::putRecord(std::size_t i) noexcept
{
  Lanes* const group = record.data() + i / 4 * recordRows();
  const std::size_t lane = i % 4;
  const auto putEnd = [&](Index node, std::size_t place) {
    const std::uint32_t offset = detail::placeOf(node);
    std::memcpy(reinterpret_cast<char*>(group) + place * sizeof(offset), &offset, sizeof(offset));
  };
  putEnd(a[i], lane);
  putEnd(b[i], 4 + lane);
  std::size_t row = 1;
  const auto put = [&](double value) { group[row++][lane] = value; };
  put(restLength[i]);
  const double perStrain =
    parameter[i] / restLength[i]; // unused, and infinite, in a linear spring of length 0
  switch (law) {
  case SpringLaw::Linear:
    if (!alike) put(stiffness[i]);
    break;
  case SpringLaw::Cubic:
    if (!alike) put(stiffness[i]);
    put(i < count ? perStrain / restLength[i] : 0.0);
    break;
  case SpringLaw::Exponential:
    put(stiffness[i] / perStrain);
    put(perStrain);
    break;
  case SpringLaw::Table:
    put(stiffness[i] * restLength[i]);
    put(1.0 / restLength[i]);
    break;
  }
  if (damped && !alike) put(viscosity[i]);
}

} // namespace esm
