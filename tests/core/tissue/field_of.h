// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/tissue/tissue_model.h"

#include <gtest/gtest.h>

#include <utility>

namespace esm::test {

inline TissueField fieldOf(const TissueModel& model)
{
  auto field = TissueField::create(model);
  if (!field) ADD_FAILURE() << field.error().detail;
  return std::move(*field);
}

} // namespace esm::test
