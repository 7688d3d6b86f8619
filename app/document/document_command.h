// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

#include <QUndoCommand>

namespace esm {

/// The names of undo steps, of the translation context "esm::Commands"; `text` through QT_TRANSLATE_NOOP.
QString translatedCommand(const char* text);

/// The base of all edits, and the only way to write to the project. Owned by the undo stack, which the
/// document outlives.
class DocumentCommand : public QUndoCommand {
protected:
  DocumentCommand(Document& document, const QString& text) : QUndoCommand(text), m_document(&document) {}

  Document& document() { return *m_document; }
  Project& project() { return m_document->m_project; }
  void netReplaced(bool derived); ///< call after writing to project().net
  void putNet(const std::shared_ptr<const SpringNet>& net, bool derived) { m_document->putNet(net, derived); }
  bool netIsDerived() const { return m_document->m_derived; }
  std::uint64_t newNetNumber() { return ++m_document->m_netNumbers; }
  void setNetNumber(std::uint64_t number) { m_document->m_netNumber = number; }
  int modelNumber() const { return m_document->m_model; }
  void setModelNumber(int number) { m_document->m_model = number; }
  void setTarget(int region) { m_document->setInputTarget(region); }
  void keepTargetInRange() { m_document->keepTargetInRange(); }
  void derive();                                  ///< gives the springs what the project's tissue says now
  void announceTissue(const TissueModel& former); ///< says what differs from it now

private:
  Document* m_document;
};

/// An edit of the tissue: change the model, give the springs their parameters anew, announce.
/// Parameters that did not come from this tissue (an older program's file) are kept for undo.
class TissueCommand : public DocumentCommand {
public:
  void redo() final;
  void undo() final;
  /// The edit itself, also tried on a copy before the command is pushed.
  virtual void apply(TissueModel& tissue) const = 0;

protected:
  using DocumentCommand::DocumentCommand;
  void becomeVoid(); ///< call from mergeWith() when nothing is left to undo: the step leaves the stack
  virtual void revert(TissueModel& tissue) const = 0;
  virtual void announce(bool undone) = 0;
  /// Nothing but the tissue is needed to undo this.
  bool isUndoneByTissue() const { return m_before == nullptr; }

private:
  std::shared_ptr<const SpringNet> m_before; ///< null: deriving gives the same
};

} // namespace esm
