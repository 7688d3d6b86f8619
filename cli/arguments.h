// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "meshimport/mesh_importer.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// Arguments with numbers. The parser library reads numbers by the locale (under de_DE "0.25" fails), so it
/// gets them as text and core/base/text_number.h reads them. A bad one is a usage fault, exit 2.
namespace esm::cli {

enum class NumberRange { Any, NotNegative, Positive };

/// The text as a finite number; throws the parser's ValidationError.
double numberArgument(const std::string& option, const std::string& text,
                      NumberRange range = NumberRange::Any);

/// The text as an integer from `least` to `most`; throws as above.
int integerArgument(const std::string& option, const std::string& text, int least, int most);

/// "x,y,z,...": as many numbers as `least` to `most`.
std::vector<double> numbersArgument(const std::string& option, const std::string& text, std::size_t least,
                                    std::size_t most);

CLI::Option* addNumber(CLI::App& command, const std::string& name, std::optional<double>& value,
                       const std::string& help, NumberRange range = NumberRange::Any);
CLI::Option* addInteger(CLI::App& command, const std::string& name, std::optional<int>& value,
                        const std::string& help, int least, int most);

/// The folder in which a file lies.
std::filesystem::path folderOf(const std::filesystem::path& file);

CLI::Option* addJsonFlag(CLI::App& command, bool& json);

} // namespace esm::cli
