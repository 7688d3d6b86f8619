// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QString>
#include <QStringList>

namespace esm {

/// What happened, in the window's language: one sentence for the kind of fault.
QString errorLead(ErrorCode code);

/// File, place, what is wrong there and the way out, in the window's language as far as it is known
/// (error_sentences.h); the rest stays in the core's English.
QString errorDetail(const Error& error);
QString errorDetail(const QString& detail);

/// The text with its %1, %2 ... filled in, whatever these hold themselves.
QString filled(const QString& text, const QStringList& parts);

/// The lead sentence and below it the detail.
QString errorText(const Error& error);

} // namespace esm
