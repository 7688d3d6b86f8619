// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace esm::test {

inline std::string dxf(const std::string& entities, const std::string& blocks = "")
{
  return "0\nSECTION\n2\nBLOCKS\n" + blocks + "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + entities +
         "0\nENDSEC\n0\nEOF\n";
}
inline std::string dxfVertex(const char* x, const char* y, const char* z, const char* more = "")
{
  return std::string("0\nVERTEX\n8\n0\n10\n") + x + "\n20\n" + y + "\n30\n" + z + "\n" + more;
}
inline const std::string kFourVertices = dxfVertex("0", "0", "0") + dxfVertex("1", "0", "0") +
                                         dxfVertex("1", "1", "0") + dxfVertex("0", "1", "0") + "0\nSEQEND\n";

} // namespace esm::test
