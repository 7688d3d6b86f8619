// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/file_identity.h"
#include "core/base/result.h"
#include "core/project/project.h"
#include "core/tissue/tissue_derivation.h"
#include "fuzzyeditor/fuzzy_document.h"

#include <QElapsedTimer>
#include <QString>
#include <QUndoStack>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace esm {

class TissueCommand;
struct RecoveredWork;
struct RecoveredHistory;

/// The tissue's numbers beside rules, inputs and regions.
struct TissueSettings {
  double thickness = 0.002; ///< of the wall [m]
  double density = 1050.0;  ///< [kg/m^3]
  SpringLaw law = SpringLaw::Exponential;
  double lawParameter = 3.0; ///< [1]
  bool operator==(const TissueSettings&) const = default;
};
TissueSettings settingsOf(const TissueModel& tissue);

/// A model that comes in from a mesh file: what replaces the net or is added to it.
struct IncomingModel {
  QString name;
  ImportRecipe source;
  SpringNet net;
  /// What it brings, or leaves of the former model's; empty: the document's stays.
  std::optional<TissueModel> tissue;
};

/// The open project, its undo stack and its file. Everything that edits is a command (see *_commands.h);
/// panels call the functions below, never the project itself. Undoing everything gives back the project
/// byte by byte. GUI thread.
///
/// After an edit of the tissue the springs get their parameters anew (core/tissue). A tissue that cannot be
/// applied is refused before the command reaches the stack: problem() says why, nothing changes.
class Document : public FuzzyDocument {
  Q_OBJECT
public:
  explicit Document(QObject* parent = nullptr);
  ~Document() override;

  // === The whole
  const Project& project() const noexcept { return m_project; }
  std::shared_ptr<const SpringNet> net() const; ///< the project's net, shared with view and simulation
  QUndoStack* undoStack() noexcept { return &m_undo; }
  const QString& path() const noexcept { return m_path; } ///< empty: not saved as a project yet
  QString displayName() const;
  bool isModified() const { return !m_undo.isClean() || m_stepsRecovered > 0 || !ruleDraft().isEmpty(); }
  int stepsAfterSave() const; ///< done, undone or redone: what a crash would cost

  void start(Project project, const QString& path); ///< replaces everything; the undo stack is emptied
  /// The same with work that was not saved, its steps to undo and redo, and a rule that was being written.
  void startRecovered(const RecoveredWork& work, const QString& path);
  /// Steps before those on the undo stack, which an earlier process has counted (JournalState::undoIndex).
  int stepsBeforeUndo() const noexcept { return m_stepsBefore; }
  Status open(const QString& path);   ///< on error everything is as before
  Status saveAs(const QString& path); ///< atomic, into files only; the former one stays as .bak
  /// Whether a file stands there with other bytes than this project's file had when it was opened or saved here.
  bool isForeign(const QString& path) const;
  /// Whether somebody else has written the file since it was opened or saved: saving would lose that.
  bool fileChangedOnDisk() const;
  /// Whether the model was replaced by another organ since the file was opened or saved: saving would lose that.
  bool fileHoldsAnotherModel() const { return !m_path.isEmpty() && m_model != m_savedModel; }
  int modelNumber() const noexcept { return m_model; } ///< of the organ; undo brings numbers back
  void setView(const ViewSettings& view);              ///< saved with the project, no edit

  /// Nets of one number differ at most in held nodes and in what the tissue gives them; undo brings numbers
  /// back.
  std::uint64_t netNumber() const noexcept { return m_netNumber; }
  bool netIsDerived() const noexcept { return m_derived; } ///< its parameters are what applyTissue() gives

  // === Fuzzy panels
  const fuzzy::RuleBase& ruleBase() const override { return m_project.tissue.rules; }
  const std::vector<fuzzy::InputValue>& inputs() const override;
  QString inputTargetName() const override;
  Language ruleLanguage() const override { return m_language; }
  const fuzzy::RuleBase& savedRuleBase() const override { return m_savedRules; }
  void setRuleBase(fuzzy::RuleBase ruleBase, const QString& undoText, int gesture = 0) override;
  void setInput(int input, fuzzy::InputValue value, int gesture) override;
  void setInputs(std::vector<fuzzy::InputValue> values, const QString& undoText, int gesture = 0) override;

  int inputTarget() const noexcept { return m_target; } ///< region, or -1 for the base tissue
  void setInputTarget(int region);
  void setRuleLanguage(Language language);

  // === Tissue and regions
  /// The tissue compiled, as it holds now; null if it cannot be (problem() has said why).
  const TissueField* tissueField() const;
  /// What the last edit of the tissue derived anew, and its time [s].
  const DerivationReport& lastApply() const noexcept { return m_lastApply; }
  double lastApplyTime() const noexcept { return m_lastApplyTime; }
  /// The numbers that the last parametersChanged() is about; null: they may be others everywhere.
  std::shared_ptr<const ParameterPatch> lastPatch() const noexcept { return m_lastPatch; }
  // What a lock forbids (core/tissue/region_edit.h) is refused: problem() says so.
  void addRegion(Region region); ///< at the end: it covers the others
  void removeRegion(int index);
  void moveRegion(int from, int to);
  void setRegion(int index, Region region, const QString& undoText, int gesture = 0);
  void lockRegion(int index, bool locked);
  void showRegion(int index, bool visible);
  void detachTwin(int index); ///< the twin becomes a region of its own, right above
  void setTissueSettings(const TissueSettings& settings, int gesture = 0);
  void setParametersFromTissue(bool on);

  // === Model
  /// On success one undo step, the tissue that comes along included. Errors: those of applyTissue(); nothing
  /// has changed then.
  Status importModel(IncomingModel model, bool replace);
  /// Net, loads and recipe of a project that was imported again, in one undo step.
  void replaceNet(Project project, const QString& undoText);
  void rename(const QString& name);
  void setFixed(const std::vector<Index>& nodes, bool fixed);
  void setGravity(const Eigen::Vector3d& gravity, int gesture = 0);
  void setSolver(const std::string& name);

signals:
  void projectLeft(); ///< before another project comes: what is here is let go
  void projectSaved();
  void projectReset();      ///< another project: everything changed
  void netChanged();        ///< topology, fixed nodes, loads or solver: the simulation starts anew
  void modelReplaced();     ///< nodes are others than before: forget what was selected (after netChanged)
  void parametersChanged(); ///< same topology, other numbers: see lastPatch()
  void regionsChanged();
  void inputTargetChanged(int region);
  void tissueSettingsChanged();
  void titleChanged(); ///< name, path or modified
  void problem(const esm::Error& error);

private:
  friend class DocumentCommand;
  friend class TissueCommand;

  bool pushTissue(std::unique_ptr<TissueCommand> command);
  void refuse(const Error& error);
  bool mayEditInputs();
  void pushRegions(const Status& edited, TissueModel tissue, int chosenBefore, int chosen,
                   const QString& text, int gesture = 0);
  bool derivesSprings() const;
  Status prepare(const TissueModel& tissue);
  bool isPrepared() const { return m_preparedField.has_value(); }
  void derivePrepared();
  void putNet(std::shared_ptr<const SpringNet> net, bool derived);
  void begin(Project project, const QString& path, const RecoveredWork* work = nullptr);
  void takeHistory(const RecoveredHistory& history, bool knowsSaved);
  void countSteps(int index);
  void netWritten(bool derived);
  void keepTargetInRange();

  Project m_project;
  /// Copy of m_project.net, made on demand: edits of the tissue write to that one in place.
  mutable std::shared_ptr<const SpringNet> m_sharedNet;
  std::uint64_t m_netNumber = 0, m_netNumbers = 0; ///< of the net, and how many were given
  bool m_derived = false; ///< the net's parameters are what applyTissue() gives: undo need not store them
  std::optional<TissueDerivation> m_derivation; ///< follows edits; only while m_derived, and then on demand
  // What the next redo() takes, tried by prepare(); the first only where there is no derivation yet.
  std::optional<TissueDerivation> m_preparedDerivation;
  std::optional<TissueField> m_preparedField;
  std::shared_ptr<const ParameterPatch> m_lastPatch;
  mutable std::optional<TissueField> m_field; ///< compiled on demand while there is no derivation
  QElapsedTimer m_deriving;
  DerivationReport m_lastApply;
  double m_lastApplyTime = 0.0;
  fuzzy::RuleBase m_savedRules;
  QUndoStack m_undo;
  QString m_path;
  /// Of the organ, of that in the file, and how many were given; undo brings numbers back.
  int m_model = 0, m_savedModel = 0, m_models = 0;
  std::optional<FileIdentity> m_file; ///< at m_path, as it was opened or saved
  int m_stepsRecovered = 0;           ///< not saved by the process that was lost, where they cannot be undone
  int m_stepsBefore = 0;
  int m_steps = 0;                   ///< after the last save, as far as the undo stack can tell
  int m_lostSteps = 0, m_lostAt = 0; ///< when the saved state left the undo stack: its distance, the index
  int m_target = -1;
  Language m_language = Language::English;
};

} // namespace esm
