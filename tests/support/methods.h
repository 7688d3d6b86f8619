// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/methods/integrator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <string>
#include <vector>

namespace esm::test {

/// The methods of the table that have one of these roles, and the names given besides. A new method so joins
/// the tests of its role by its line in the table.
inline std::vector<std::string> methodsOf(std::initializer_list<MethodRole> roles,
                                          std::initializer_list<const char*> besides = {})
{
  std::vector<std::string> names(besides.begin(), besides.end());
  for (const IntegratorEntry& entry : integratorTable())
    if (std::ranges::find(roles, entry.role) != roles.end()) names.emplace_back(entry.name);
  return names;
}

/// Those that take explicit steps of one length for all of the net.
inline std::vector<std::string> explicitMethods(std::initializer_list<const char*> besides = {})
{
  return methodsOf({MethodRole::Explicit, MethodRole::ExplicitByName}, besides);
}

/// Those that keep any tolerance, on any net.
inline std::vector<std::string> accurateMethods(std::initializer_list<const char*> besides = {})
{
  return methodsOf({MethodRole::Explicit, MethodRole::ExplicitByName, MethodRole::Implicit}, besides);
}

/// All but these.
inline std::vector<std::string> methodsBut(std::initializer_list<const char*> others)
{
  std::vector<std::string> names;
  for (const IntegratorEntry& entry : integratorTable())
    if (std::ranges::find(others, entry.name) == others.end()) names.emplace_back(entry.name);
  return names;
}

/// As the name of a test, which knows no hyphens.
inline std::string testName(std::string method)
{
  std::ranges::replace(method, '-', '_');
  return method;
}

} // namespace esm::test
