// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/recovery.h"

#include <QBuffer>

namespace esm {

namespace {

constexpr int kTypingPause = 200;    // [ms] a rule that is typed changes with every key
constexpr int kPicturePause = 30000; // [ms]
constexpr QSize kPictureSize(320, 200);

} // namespace

Recovery::Recovery(Document* document, const std::filesystem::path& folder, QObject* parent)
  : QObject(parent), m_document(document), m_folder(folder), m_journal(folder, [this](const Error& error) {
      // From whichever thread; this object joins it before it goes.
      QMetaObject::invokeMethod(
        this, [this, error] { emit failed(error); }, Qt::QueuedConnection);
    })
{
  m_typing.setSingleShot(true);
  m_typing.setInterval(kTypingPause);
  m_pause.setSingleShot(true);
  connect(&m_typing, &QTimer::timeout, this, &Recovery::record);
  connect(&m_pause, &QTimer::timeout, this, &Recovery::takePicture);
  connect(document, &Document::projectLeft, this, [this] {
    letGo();
    m_away = true;
  });
  connect(document, &Document::projectReset, this, [this] {
    m_away = false;
    begin();
  });
  connect(document, &Document::projectSaved, this, [this] {
    begin();
    record(); // a rule that is being written is in no file
  });
  connect(document, &Document::ruleDraftChanged, this, [this] {
    if (m_away) return;
    if (m_document->ruleDraft().cell != m_cell) return record();
    if (!m_typing.isActive()) m_typing.start();
  });
  connect(document->undoStack(), &QUndoStack::indexChanged, this, [this] {
    if (!m_away) record();
  });
  begin();
}

Recovery::~Recovery() = default;

JournalState Recovery::state() const
{
  JournalState now;
  now.project = &m_document->project();
  now.netNumber = m_document->netNumber();
  now.netDerived = m_document->netIsDerived();
  now.model = m_document->modelNumber();
  now.net = [this] { return m_document->net(); };
  now.steps = m_document->stepsAfterSave();
  now.draft = m_document->ruleDraft();
  const QUndoStack& undo = *m_document->undoStack();
  now.undoIndex = m_document->stepsBeforeUndo() + undo.index();
  now.undoCount = m_document->stepsBeforeUndo() + undo.count();
  now.undoText = undo.undoText().toStdString();
  now.redoText = undo.redoText().toStdString();
  return now;
}

void Recovery::begin()
{
  m_typing.stop();
  m_pause.stop();
  m_hasPicture = false;
  m_journal.start(state(), m_document->path().toStdString());
}

void Recovery::record()
{
  m_typing.stop();
  m_journal.record(state());
  m_cell = m_document->ruleDraft().cell;
  if (m_journal.isKept() && !m_pause.isActive()) m_pause.start(m_hasPicture ? kPicturePause : kFirstPicture);
}

void Recovery::letGo()
{
  m_typing.stop();
  m_pause.stop();
  m_journal.leave();
}

Result<RecoveredWork> Recovery::recover(FoundJournal&& found)
{
  Result<RecoveredWork> work = readJournal(found);
  if (!work) return work;
  const QString path = work->fileChanged ? QString() : QString::fromStdString(work->path);
  m_document->startRecovered(*work, path);
  if (const Status adopted = m_journal.adopt(std::move(found), *work, state()); !adopted)
    emit failed(adopted.error());
  return work;
}

bool Recovery::waitWritten(std::chrono::milliseconds limit)
{
  if (m_typing.isActive()) record();
  return m_journal.waitWritten(limit);
}

void Recovery::takePicture()
{
  if (!m_picture || !m_journal.isKept()) return;
  const QImage picture = m_picture();
  if (picture.isNull()) return;
  QByteArray bytes;
  QBuffer buffer(&bytes);
  picture.scaled(kPictureSize, Qt::KeepAspectRatio, Qt::SmoothTransformation).save(&buffer, "PNG");
  m_journal.setPicture(bytes.toStdString());
  m_hasPicture = true;
}

} // namespace esm
