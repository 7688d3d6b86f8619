// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document_command.h"

namespace esm {

/// Everything of a project that comes with a mesh.
struct ModelPart {
  std::string name;
  TissueModel tissue;
  ImportRecipe source;
  std::shared_ptr<const SpringNet> net;
  Loads loads;
  bool parametersFromTissue = true;
  bool derived = true;         ///< the net's parameters are what the tissue gives
  std::uint64_t netNumber = 0; ///< Document::netNumber()
  int model = 0;               ///< the organ's number
};

/// An imported mesh replaces the model or has been added to it.
class SetModelCommand : public DocumentCommand {
public:
  SetModelCommand(Document& document, ModelPart model, const QString& text);
  void redo() override { put(m_new); }
  void undo() override { put(m_old); }

private:
  void put(const ModelPart& part);
  ModelPart m_old, m_new;
};

class RenameCommand : public DocumentCommand {
public:
  RenameCommand(Document& document, std::string name);
  void redo() override { put(m_new); }
  void undo() override { put(m_old); }

private:
  void put(const std::string& name);
  std::string m_old, m_new;
};

/// Holds nodes fast or frees them.
class SetFixedCommand : public DocumentCommand {
public:
  SetFixedCommand(Document& document, const std::vector<Index>& nodes, bool fixed);
  void redo() override { put(m_new); }
  void undo() override { put(m_old); }

private:
  void put(const std::vector<std::uint8_t>& flags);
  std::vector<std::uint8_t> m_old, m_new;
};

/// Values of one gesture merge.
class SetGravityCommand : public DocumentCommand {
public:
  SetGravityCommand(Document& document, const Eigen::Vector3d& gravity, int gesture);
  void redo() override { put(m_new); }
  void undo() override { put(m_old); }
  int id() const override;
  bool mergeWith(const QUndoCommand* next) override;

private:
  void put(const Eigen::Vector3d& gravity);
  Eigen::Vector3d m_old, m_new;
  int m_gesture;
};

class SetSolverCommand : public DocumentCommand {
public:
  SetSolverCommand(Document& document, std::string name);
  void redo() override { put(m_new); }
  void undo() override { put(m_old); }

private:
  void put(const std::string& name);
  std::string m_old, m_new;
};

/// Whether springs take their parameters from the tissue or keep those they came with.
class SetParametersFromTissueCommand : public DocumentCommand {
public:
  SetParametersFromTissueCommand(Document& document, bool on, std::shared_ptr<const SpringNet> net);
  void redo() override { put(m_on, m_new, m_on, m_newNumber); }
  void undo() override { put(!m_on, m_old, m_oldDerived, m_oldNumber); }

private:
  void put(bool on, const std::shared_ptr<const SpringNet>& net, bool derived, std::uint64_t number);
  bool m_on, m_oldDerived;
  std::uint64_t m_oldNumber, m_newNumber;
  std::shared_ptr<const SpringNet> m_old, m_new;
};

} // namespace esm
