// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document_command.h"

namespace esm {

/// Another rule base. Inputs follow their variables by id: new variables start at their default, words
/// whose term is gone become the default. Rule bases of one gesture merge, and vanish where the last is the
/// first.
class SetRuleBaseCommand : public TissueCommand {
public:
  SetRuleBaseCommand(Document& document, fuzzy::RuleBase ruleBase, const QString& text, int gesture);
  void apply(TissueModel& tissue) const override { tissue = m_new; }
  int id() const override;
  bool mergeWith(const QUndoCommand* next) override;

protected:
  void revert(TissueModel& tissue) const override { tissue = m_old; }
  void announce(bool undone) override;

private:
  TissueModel m_old, m_new;
  int m_gesture;
};

/// One input of the base tissue (target -1) or of a region. Values of one gesture merge.
class SetInputCommand : public TissueCommand {
public:
  SetInputCommand(Document& document, int target, int input, fuzzy::InputValue value, int gesture);
  void apply(TissueModel& tissue) const override { slot(tissue) = m_new; }
  int id() const override;
  bool mergeWith(const QUndoCommand* next) override;

protected:
  void revert(TissueModel& tissue) const override { slot(tissue) = m_old; }
  void announce(bool undone) override;

private:
  fuzzy::InputValue& slot(TissueModel& tissue) const;
  int m_target, m_input, m_gesture;
  fuzzy::InputValue m_old, m_new;
};

/// All inputs of the base tissue (target -1) or of a region.
class SetInputsCommand : public TissueCommand {
public:
  SetInputsCommand(Document& document, int target, std::vector<fuzzy::InputValue> newValues,
                   const QString& text, int gesture);
  void apply(TissueModel& tissue) const override { values(tissue) = m_new; }
  int id() const override;
  bool mergeWith(const QUndoCommand* next) override;

protected:
  void revert(TissueModel& tissue) const override { values(tissue) = m_old; }
  void announce(bool undone) override;

private:
  std::vector<fuzzy::InputValue>& values(TissueModel& tissue) const;
  int m_target, m_gesture;
  std::vector<fuzzy::InputValue> m_old, m_new;
};

/// Thickness, density and force law. Values of one gesture merge.
class SetTissueSettingsCommand : public TissueCommand {
public:
  SetTissueSettingsCommand(Document& document, const TissueSettings& settings, int gesture);
  void apply(TissueModel& tissue) const override { put(tissue, m_new); }
  int id() const override;
  bool mergeWith(const QUndoCommand* next) override;

protected:
  void revert(TissueModel& tissue) const override { put(tissue, m_old); }
  void announce(bool undone) override;

private:
  static void put(TissueModel& tissue, const TissueSettings& settings);
  TissueSettings m_old, m_new;
  int m_gesture;
};

} // namespace esm
