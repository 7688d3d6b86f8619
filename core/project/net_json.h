// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/loads.h"
#include "core/net/spring_net.h"
#include "core/project/json_view.h"
#include "core/project/project.h"

namespace esm::json {

inline constexpr const char* kLawNames[] = {"linear", "cubic", "exponential", "table"};

// === Pieces that both file formats use
Json listOf(const double* values, Eigen::Index count);
Json listOf(const std::vector<Index>& values);
template <class Derived>
Json listOf(const Eigen::PlainObjectBase<Derived>& values) ///< column by column
{
  Json::array_t list(values.data(), values.data() + values.size());
  return list;
}
/// One number if all are equal bit for bit, else the list.
Json uniformOrList(const Eigen::ArrayXd& values);
Json lawsOf(const SpringNet& net); ///< one word or a list of words
/// Without gravity and the object around them: {"forces": [...], "motions": [...]}.
Json forcesOf(const Loads& loads);
Json motionsOf(const Loads& loads);
std::vector<NodalForce> readForces(const View& list, Index nodes);
std::vector<PrescribedMotion> readMotions(const View& list, Index nodes);
Json anchorsOf(const AnchorSet& set);
void readAnchors(const View& object, SpringNet& net);

// === The blocks "geometry" and "net" of a project
Json geometryOf(const SpringNet& net);
Json netOf(const SpringNet& net);
/// Both blocks together; checkNet() has still to look at the result.
SpringNet readNet(const View& geometry, const View& net);

Json loadsOf(const Loads& loads);
Loads readLoads(const View& object, Index nodes);

// === The plain net format, see net_format.h
inline constexpr const char* kPlainNetFormat = "esm-net-1";
Result<Project> readPlainNet(const Json& tree, const std::string& origin);

} // namespace esm::json
