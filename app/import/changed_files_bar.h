// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/jobs/job.h"
#include "core/project/reimport.h"

#include <QFileSystemWatcher>
#include <QFrame>
#include <QTimer>

class QLabel;
class QPushButton;

namespace esm {

/// A line above the preview that says that a mesh file of the model is not what it was when it came in, and
/// offers to take it anew, in one step of undo, or to leave it. Hidden as long as there is nothing to say.
///
/// Files and their folders are watched, since programs replace files rather than write into them; whether a
/// file is another one is a matter of its fingerprint, found off the GUI thread.
class ChangedFilesBar : public QFrame {
  Q_OBJECT
public:
  /// @param document outlives the bar.
  explicit ChangedFilesBar(Document* document, QWidget* parent = nullptr);

  /// Looks at the files anew, for example when the window gets the focus.
  void check();

signals:
  void updated(const QString& summary); ///< of what came in
  void failed(const esm::Error& error);

protected:
  void changeEvent(QEvent* event) override;

private:
  void watch();
  void show(const QStringList& changed);
  void update();
  void ignore();
  void take(Result<Reimported> made);
  void retranslate();

  Document* m_document;
  QFileSystemWatcher m_watcher;
  QTimer m_settle; ///< a file that is being written changes many times
  JobRunner* m_checks;
  JobRunner* m_updates;
  QStringList m_changed; ///< empty: the bar is hidden
  QLabel* m_text;
  QPushButton *m_update, *m_ignore;
};

} // namespace esm
