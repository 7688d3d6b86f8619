// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/fem/fem_case.h"

#include "core/base/file_io.h"
#include "core/base/text_number.h"
#include "meshimport/mesh_importer.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

namespace esm::bench {

namespace {

std::vector<std::string_view> splitAt(std::string_view text, std::string_view separators)
{
  std::vector<std::string_view> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(separators), text.size());
    if (end > 0) parts.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

/// The numbers behind the last word of a comment line.
std::vector<double> numbersAtEnd(std::string_view line)
{
  std::vector<double> numbers;
  for (const std::string_view word : splitAt(line, " "))
    if (const std::optional<double> number = parseDouble(word))
      numbers.push_back(*number);
    else
      numbers.clear();
  return numbers;
}

std::string_view femWordAfter(std::string_view line, std::string_view key)
{
  const std::size_t at = line.find(key);
  if (at == std::string_view::npos) return {};
  const auto words = splitAt(line.substr(at + key.size()), " ,;");
  return words.empty() ? std::string_view{} : words.front();
}

Result<FemCase> readFemCase(const std::filesystem::path& path, Index nodes)
{
  const Result<std::string> text = readFile(path);
  if (!text) return text.error();
  FemCase load;
  std::vector<std::vector<double>> rows;
  for (const std::string_view line : splitAt(*text, "\n")) {
    if (line.front() == '#') {
      if (load.kind.empty()) load.kind = femWordAfter(line, "kind ");
      if (load.name.empty()) load.name = femWordAfter(line, "case ");
      if (line.find("shares") != std::string_view::npos) load.shares = numbersAtEnd(line);
      continue;
    }
    std::vector<double> row;
    for (const std::string_view word : splitAt(line, ","))
      if (const std::optional<double> number = parseDouble(word)) row.push_back(*number);
    if (row.size() != 4 + 3 * load.shares.size() || row[0] < 0.0 || row[0] >= nodes)
      return Error{ErrorCode::BadFormat, path.string() + ": the line \"" + std::string(line.substr(0, 40)) +
                                           "\" is not a node, a force and a displacement at each share"};
    rows.push_back(std::move(row));
  }
  if (rows.empty() || load.shares.empty())
    return Error{ErrorCode::BadFormat, path.string() + ": no displacements"};
  const auto count = static_cast<Eigen::Index>(rows.size());
  load.force.resize(3, count);
  load.moved.assign(load.shares.size(), Eigen::Matrix3Xd(3, count));
  for (Eigen::Index i = 0; i < count; ++i) {
    const std::vector<double>& row = rows[static_cast<std::size_t>(i)];
    load.node.push_back(static_cast<Index>(row[0]));
    load.force.col(i) = 1e-6 * Eigen::Vector3d(row[1], row[2], row[3]);
    for (std::size_t k = 0; k < load.shares.size(); ++k)
      load.moved[k].col(i) = 1e-6 * Eigen::Vector3d(row[4 + 3 * k], row[5 + 3 * k], row[6 + 3 * k]);
  }
  return load;
}

} // namespace

bool FemBody::isHeld(const Eigen::Vector3d& place) const
{
  return std::any_of(held.begin(), held.end(),
                     [&](Index node) { return std::abs(mesh.position(2, node) - place[2]) < 1e-9; });
}

Result<FemBody> readFemBody(const std::filesystem::path& folder, const std::string& name)
{
  FemBody body;
  const std::filesystem::path surface = folder / (name + ".obj");
  const Result<std::string> text = readFile(surface);
  if (!text) return text.error();
  for (const double node : numbersAtEnd(text->substr(0, text->find('\n'))))
    body.held.push_back(static_cast<Index>(node));
  ImportOptions asItIs;
  asItIs.weld = false;
  Result<ImportedMesh> imported = importMesh(surface, asItIs);
  if (!imported) return imported.error();
  body.mesh = std::move(imported->mesh);
  body.mesh.position *= 1e-3;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".csv" && entry.path().stem().string().rfind(name + "_", 0) == 0)
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const std::filesystem::path& file : files) {
    Result<FemCase> load = readFemCase(file, body.mesh.vertexCount());
    if (!load) return load.error();
    body.cases.push_back(std::move(*load));
  }
  return body;
}

} // namespace esm::bench
