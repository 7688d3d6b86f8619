// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The part of Document that keeps the springs' parameters at what the tissue says.
#include "app/document/document.h"
#include "app/document/tissue_commands.h"

namespace esm {

const TissueField* Document::tissueField() const
{
  if (m_derivation) return &m_derivation->field();
  if (!m_field)
    if (auto field = TissueField::create(m_project.tissue)) m_field.emplace(std::move(field).value());
  return m_field ? &*m_field : nullptr;
}

/// Tries the edit first, so that the stack never holds a step that cannot be done.
bool Document::pushTissue(std::unique_ptr<TissueCommand> command)
{
  TissueModel tissue = m_project.tissue;
  command->apply(tissue);
  if (auto prepared = prepare(tissue); !prepared) {
    refuse(prepared.error());
    return false;
  }
  m_undo.push(command.release()); // runs redo()
  return true;
}

void Document::refuse(const Error& error)
{
  emit problem(error);
  emit inputsChanged(); // widgets go back to what holds
  emit regionsChanged();
  emit tissueSettingsChanged();
}

/// Does what can fail of deriving the springs from `tissue`; the project stays as it is.
Status Document::prepare(const TissueModel& tissue)
{
  m_deriving.start();
  m_preparedDerivation.reset();
  m_preparedField.reset();
  m_lastPatch.reset();
  auto field = TissueField::create(tissue);
  if (!field) return field.error();
  if (!m_derivation && derivesSprings()) {
    auto derivation = TissueDerivation::prepare(tissue, m_project.net);
    if (!derivation) return derivation.error();
    m_preparedDerivation.emplace(std::move(derivation).value());
  }
  m_preparedField.emplace(std::move(field).value());
  return {};
}

bool Document::derivesSprings() const
{
  return m_project.parametersFromTissue && m_project.net.nodeCount() > 0;
}

/// Gives the springs what prepare() made ready for the project's present tissue.
void Document::derivePrepared()
{
  if (m_preparedDerivation) m_derivation = std::move(m_preparedDerivation); // the first one writes everything
  if (m_derivation) {
    auto patch = std::make_shared<ParameterPatch>();
    m_lastApply = m_derivation->update(std::move(*m_preparedField), m_project.net, patch.get());
    m_lastPatch = std::move(patch);
    m_sharedNet.reset();
    m_field.reset();
    m_derived = true;
  } else {
    m_field = std::move(m_preparedField);
  }
  m_preparedDerivation.reset();
  m_preparedField.reset();
  m_lastApplyTime = 1e-9 * static_cast<double>(m_deriving.nsecsElapsed());
}

void Document::putNet(std::shared_ptr<const SpringNet> net, bool derived)
{
  m_project.net = *net;
  netWritten(derived);
  m_sharedNet = std::move(net);
}

/// Somebody else than the derivation has written to the net.
void Document::netWritten(bool derived)
{
  m_sharedNet.reset();
  m_lastPatch.reset();
  m_derivation.reset();
  m_field.reset();
  m_derived = derived;
}

} // namespace esm
