// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/error_text.h"

#include <QCoreApplication>

namespace esm {

namespace {

const char* leadOf(ErrorCode code)
{
  switch (code) {
  case ErrorCode::FileUnreadable:
    return QT_TRANSLATE_NOOP("esm::ErrorText", "The file cannot be read.");
  case ErrorCode::FileUnwritable:
    return QT_TRANSLATE_NOOP("esm::ErrorText", "The file cannot be written.");
  case ErrorCode::BadFormat:
    return QT_TRANSLATE_NOOP("esm::ErrorText", "The file is damaged or of another format.");
  case ErrorCode::Unsupported:
    return QT_TRANSLATE_NOOP("esm::ErrorText", "This format or feature is not supported.");
  case ErrorCode::NewerVersion:
    return QT_TRANSLATE_NOOP("esm::ErrorText", "The file was written by a newer version of this program.");
  case ErrorCode::InvalidValue:
    return QT_TRANSLATE_NOOP("esm::ErrorText", "A value is outside what is possible.");
  case ErrorCode::EmptyResult:
    return QT_TRANSLATE_NOOP("esm::ErrorText", "There is nothing of use in the file.");
  case ErrorCode::Numerics:
    return QT_TRANSLATE_NOOP("esm::ErrorText", "The computation could not be carried out.");
  case ErrorCode::NoDevice:
    return QT_TRANSLATE_NOOP("esm::ErrorText", "The device is not available.");
  case ErrorCode::OutOfMemory:
    return QT_TRANSLATE_NOOP("esm::ErrorText", "There is not enough memory.");
  case ErrorCode::Cancelled:
    return QT_TRANSLATE_NOOP("esm::ErrorText", "The task was cancelled.");
  case ErrorCode::Internal:
    break;
  }
  return QT_TRANSLATE_NOOP("esm::ErrorText", "An internal error occurred.");
}

} // namespace

QString errorLead(ErrorCode code)
{
  return QCoreApplication::translate("esm::ErrorText", leadOf(code));
}

QString errorText(const Error& error)
{
  return errorLead(error.code) + QStringLiteral("\n\n") + QString::fromStdString(error.detail);
}

} // namespace esm
