// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "core/project/journal_reader.h"

#include <QImage>
#include <QTimer>

#include <functional>

namespace esm {

/// Writes every step of a document to its journal (core/project/journal.h) and brings back what was left.
/// GUI thread; it never waits for a disk.
class Recovery : public QObject {
  Q_OBJECT
public:
  static constexpr int kFirstPicture = 200; ///< after the first step [ms]: the view has drawn it by then
  /// @param document not owned, outlives this.
  Recovery(Document* document, const std::filesystem::path& folder, QObject* parent = nullptr);
  ~Recovery() override;

  /// What the preview shows, for the list of what can be recovered; asked seldom.
  void setPictureSource(std::function<QImage()> source) { m_picture = std::move(source); }
  void letGo(); ///< the user does not want what is unsaved: nothing is to be recovered
  /// Puts the work into the document; its journal goes on. Errors: those of readJournal(), nothing has
  /// changed then.
  Result<RecoveredWork> recover(FoundJournal&& found);
  std::vector<FoundJournal> find() const { return findJournals(m_folder); }
  bool isKept() const noexcept { return m_journal.isKept(); }
  /// Whether all is in the hands of the system, after waiting at most so long.
  bool waitWritten(std::chrono::milliseconds limit);

signals:
  void failed(const esm::Error& error); ///< the folder cannot be written; once for each cause

private:
  JournalState state() const;
  void begin();
  void record();
  void takePicture();

  Document* m_document;
  std::filesystem::path m_folder;
  Journal m_journal;
  std::function<QImage()> m_picture;
  QTimer m_typing;           ///< a rule that is typed is written five times a second
  QTimer m_pause;            ///< until the next picture
  std::string m_cell;        ///< of the draft, when it was last written
  bool m_hasPicture = false; ///< the journal has one
  bool m_away = false;       ///< the document is between two projects
};

} // namespace esm
