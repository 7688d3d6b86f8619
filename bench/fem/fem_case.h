// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/net/net_builder.h"

#include <filesystem>
#include <string>
#include <vector>

namespace esm::bench {

/// What finite elements say of a body under a load that grows.
struct FemCase {
  std::string name, kind;              ///< "tr01", "poke"
  std::vector<Index> node;             ///< the net's free nodes
  Eigen::Matrix3Xd force;              ///< on these, at the full load [N]
  std::vector<double> shares;          ///< of the load, rising
  std::vector<Eigen::Matrix3Xd> moved; ///< of the nodes, per share [m]
  bool isTraining() const { return name.rfind("tr", 0) == 0; }
};

struct FemBody {
  Mesh mesh; ///< the surface [m]
  std::vector<Index> held;
  std::vector<FemCase> cases; ///< by name
  /// Whether a place lies in a plane z of held nodes.
  bool isHeld(const Eigen::Vector3d& place) const;
};

/// Reads FOLDER/NAME.obj and FOLDER/NAME_*.csv. Errors: FileUnreadable, BadFormat, naming the file.
Result<FemBody> readFemBody(const std::filesystem::path& folder, const std::string& name);

} // namespace esm::bench
