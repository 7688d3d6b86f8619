// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sample_files.h"

#include "core/net/net_builder.h"
#include "core/project/project_io.h"
#include "meshimport/mesh_importer.h"

#include <QCoreApplication>
#include <QDir>

#include <algorithm>

namespace esm {

namespace {

QString samplesFolder()
{
  QStringList candidates;
  if (const QString set = qEnvironmentVariable("ESM_RESOURCES"); !set.isEmpty()) candidates << set;
  const QString program = QCoreApplication::applicationDirPath();
  candidates << program + QStringLiteral("/../share/esm");
  QString above = program;
  for (int level = 0; level < 4; ++level, above += QStringLiteral("/.."))
    candidates << above + QStringLiteral("/resources");
  for (const QString& folder : candidates)
    if (QDir(folder + QStringLiteral("/samples")).exists())
      return QDir::cleanPath(folder + QStringLiteral("/samples"));
  return {};
}

constexpr std::pair<const char*, const char*> kTitles[] = {
  {"fallopian_tube", QT_TRANSLATE_NOOP("esm::Sample", "Fallopian tube")},
  {"gallbladder", QT_TRANSLATE_NOOP("esm::Sample", "Gallbladder")},
  {"uterus", QT_TRANSLATE_NOOP("esm::Sample", "Uterus")},
};

} // namespace

QString sampleTitle(const QString& file)
{
  QString name = QFileInfo(file).completeBaseName();
  for (const auto& [known, title] : kTitles)
    if (name == QLatin1String(known)) return QCoreApplication::translate("esm::Sample", title);
  return name.replace(QLatin1Char('_'), QLatin1Char(' '));
}

QStringList sampleFiles()
{
  const QString folder = samplesFolder();
  if (folder.isEmpty()) return {};
  QStringList files, names;
  for (const char* ending : {"*.esm", "*.obj", "*.stl", "*.ply"})
    for (const QFileInfo& file :
         QDir(folder).entryInfoList({QLatin1String(ending)}, QDir::Files, QDir::Name)) {
      if (names.contains(file.completeBaseName())) continue; // it has a project
      names << file.completeBaseName();
      files << file.absoluteFilePath();
    }
  const auto isFirst = [](const QString& file) { return file.contains(QLatin1String("fallopian_tube")); };
  std::stable_partition(files.begin(), files.end(), isFirst);
  return files;
}

bool isProjectFile(const QString& path)
{
  return QStringList{QStringLiteral("esm"), QStringLiteral("esmb"), QStringLiteral("json"),
                     QStringLiteral("xsp")}
    .contains(QFileInfo(path).suffix().toLower());
}

Result<Project> projectFromFile(const QString& path)
{
  if (isProjectFile(path)) {
    Result<Project> project = loadProject(path.toStdString());
    if (project)
      project->source =
        withAbsoluteNames(std::move(project->source), QFileInfo(path).absolutePath().toStdString());
    return project;
  }
  auto imported = importMesh(path.toStdString());
  if (!imported) return imported.error();
  toScene(imported->mesh, LengthUnit::Millimetre, UpAxis::Z);
  auto net = buildNet(imported->mesh);
  if (!net) return net.error();

  Project project;
  const QFileInfo file(path);
  project.name = file.completeBaseName().replace(QLatin1Char('_'), QLatin1Char(' ')).toStdString();
  project.source.files = {{file.absoluteFilePath().toStdString(), 0}};
  project.source.unit = LengthUnit::Millimetre;
  project.net = std::move(net).value();
  project.tissue = defaultTissue();
  if (auto applied = applyTissue(project.tissue, project.net); !applied) return applied.error();
  return project;
}

} // namespace esm
