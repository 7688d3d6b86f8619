// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "meshimport/worker/model_folder.h"

#include <Inventor/SoInput.h>

#include <cstddef>
#include <vector>

class SoNode;

namespace esm {

/// The files that a scene of Coin's is made of while it is read.
struct CoinParts {
  explicit CoinParts(const std::filesystem::path& model);

  /// The file to read for a name in the part that is being read; empty if it may not be, which is remembered.
  std::filesystem::path enter(std::string_view name);

  ModelFolder folder;
  std::vector<std::filesystem::path> open; ///< the model first, then each inside the one before
  std::size_t count = 0;
};

/// Through it File, Inline and EXTERNPROTO nodes open what they name. Coin itself would take anything, and
/// look into the working directory first.
class PartInput : public SoInput {
public:
  explicit PartInput(CoinParts& parts) : m_parts(parts) {}
  SbBool pushFile(const char* name) override;

protected:
  SbBool popFile() override;

private:
  CoinParts& m_parts;
};

/// Makes WWWInline nodes read their parts too. @pre SoDB::init(); `parts` lives as long as scenes are read
void readInlinesFrom(CoinParts& parts);

/// Inline nodes may name several places, of which the first that is there counts; Coin looks for the first
/// name alone.
void readOtherPlaces(CoinParts& parts, SoNode* scene);

} // namespace esm
