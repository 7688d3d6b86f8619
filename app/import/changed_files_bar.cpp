// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/import/changed_files_bar.h"

#include "core/base/file_io.h"
#include "meshimport/net_import.h"

#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include <algorithm>

namespace esm {

namespace {

/// A recipe whose files are known well enough to tell whether they have changed.
bool isKnown(const ImportRecipe& recipe)
{
  return !recipe.files.empty() && std::all_of(recipe.files.begin(), recipe.files.end(),
                                              [](const SourceFile& file) { return file.fingerprint != 0; });
}

/// The files that can change: to watch a device or a pipe, or the folder of devices, tells nothing and may
/// never end.
std::vector<SourceFile> regularFiles(const ImportRecipe& recipe)
{
  if (!isKnown(recipe)) return {};
  std::vector<SourceFile> files = recipe.files;
  std::erase_if(files, [](const SourceFile& file) { return !specialFileKind(file.name).empty(); });
  return files;
}

} // namespace

ChangedFilesBar::ChangedFilesBar(Document* document, QWidget* parent)
  : QFrame(parent),
    m_document(document),
    m_watcher(this),
    m_checks(new JobRunner(this)),
    m_updates(new JobRunner(this)),
    m_text(new QLabel(this)),
    m_update(new QPushButton(this)),
    m_ignore(new QPushButton(this))
{
  setObjectName(QStringLiteral("changedFilesBar"));
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::ToolTipBase);
  m_text->setForegroundRole(QPalette::ToolTipText);
  m_text->setObjectName(QStringLiteral("changedFilesText"));
  m_text->setWordWrap(true);
  m_update->setObjectName(QStringLiteral("changedFilesUpdate"));
  m_ignore->setObjectName(QStringLiteral("changedFilesIgnore"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 4, 8, 4);
  layout->addWidget(m_text, 1);
  layout->addWidget(m_update);
  layout->addWidget(m_ignore);
  QFrame::hide();

  m_settle.setSingleShot(true);
  m_settle.setInterval(400); // [ms]
  connect(&m_settle, &QTimer::timeout, this, &ChangedFilesBar::check);
  const auto touched = [this] { m_settle.start(); };
  connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, touched);
  connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, touched);
  connect(m_document, &Document::projectReset, this, &ChangedFilesBar::watch);
  connect(m_document, &Document::modelReplaced, this, &ChangedFilesBar::watch);
  connect(m_update, &QPushButton::clicked, this, &ChangedFilesBar::update);
  connect(m_ignore, &QPushButton::clicked, this, &ChangedFilesBar::ignore);
  retranslate();
  watch();
}

/// The model is another one.
void ChangedFilesBar::watch()
{
  m_updates->cancel();
  QStringList old = m_watcher.files() + m_watcher.directories();
  if (!old.isEmpty()) m_watcher.removePaths(old);
  QStringList paths;
  for (const SourceFile& file : regularFiles(m_document->project().source)) {
    const QFileInfo info(QString::fromStdString(file.name));
    if (info.exists()) paths << info.absoluteFilePath();
    if (info.absoluteDir().exists()) paths << info.absolutePath();
  }
  paths.removeDuplicates();
  if (!paths.isEmpty()) m_watcher.addPaths(paths);
  show({});
  check();
}

void ChangedFilesBar::check()
{
  if (m_updates->busy()) return;
  ImportRecipe recipe = m_document->project().source;
  recipe.files = regularFiles(recipe);
  if (recipe.files.empty()) return show({});
  for (const SourceFile& file : recipe.files) { // a file that was replaced is watched no more
    const QString path = QString::fromStdString(file.name);
    if (!m_watcher.files().contains(path) && QFileInfo::exists(path)) m_watcher.addPath(path);
  }
  m_checks->start([recipe](WorkControl*) { return changedFiles(recipe, {}); },
                  [this](Result<std::vector<std::string>> changed) {
                    QStringList names;
                    if (changed) // else a file is gone, or half-written: the next look will tell
                      for (const std::string& name : *changed)
                        names << QFileInfo(QString::fromStdString(name)).fileName();
                    show(names);
                  });
}

void ChangedFilesBar::show(const QStringList& changed)
{
  m_changed = changed;
  setVisible(!changed.isEmpty());
  retranslate();
}

/// What the user does not want now is asked again when the file changes once more.
void ChangedFilesBar::ignore()
{
  m_updates->cancel();
  show({});
}

void ChangedFilesBar::update()
{
  const Project project = m_document->project();
  m_updates->start(
    [project](WorkControl* control) -> Result<Reimported> {
      Result<ImportedNet> made = importNet(project.source, {}, project.tissue.thickness, control);
      if (!made) return made.error();
      Result<Reimported> result = reimport(project, std::move(made->net), std::move(made->recipe));
      if (result) result->notes.insert(result->notes.begin(), made->notes.begin(), made->notes.end());
      return result;
    },
    [this](Result<Reimported> made) { take(std::move(made)); });
  retranslate();
}

void ChangedFilesBar::take(Result<Reimported> made)
{
  retranslate();
  if (!made) {
    emit failed(made.error());
    return;
  }
  QString summary =
    tr("Updated: %1 nodes as before, %2 new, %3 gone").arg(made->unchanged).arg(made->added).arg(made->gone);
  for (const std::string& note : made->notes) summary += QStringLiteral("; ") + QString::fromStdString(note);
  m_document->replaceNet(std::move(made->project), tr("update the model"));
  emit updated(summary);
}

void ChangedFilesBar::changeEvent(QEvent* event)
{
  QFrame::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

void ChangedFilesBar::retranslate()
{
  const bool busy = m_updates->busy();
  m_text->setText(busy ? tr("The model is being updated …")
                       : tr("%n file(s) of the model changed since the import: %1", nullptr,
                            static_cast<int>(m_changed.size()))
                           .arg(m_changed.join(QStringLiteral(", "))));
  m_update->setText(tr("Update"));
  m_update->setToolTip(tr("Import again with the same choices; what can be is carried over"));
  m_update->setEnabled(!busy);
  m_ignore->setText(busy ? tr("Cancel") : tr("Ignore"));
  setAccessibleName(tr("Changed files"));
  m_text->setAccessibleName(tr("Changed files"));
  m_update->setAccessibleName(m_update->text());
  m_ignore->setAccessibleName(m_ignore->text());
}

} // namespace esm
