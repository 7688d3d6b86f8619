// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document.h"

#include "app/document/append_net.h"
#include "app/document/model_commands.h"
#include "app/document/recovered_steps.h"
#include "app/document/region_commands.h"
#include "app/document/tissue_commands.h"
#include "core/base/assert.h"
#include "core/base/file_io.h"
#include "core/net/net_builder.h"
#include "core/project/project_io.h"
#include "core/tissue/region_edit.h"

#include <QFileInfo>

#include <algorithm>

namespace esm {

TissueSettings settingsOf(const TissueModel& tissue)
{
  return {tissue.thickness, tissue.density, tissue.law, tissue.lawParameter};
}

Document::Document(QObject* parent) : FuzzyDocument(parent)
{
  m_project.tissue = defaultTissue();
  resizeNet(m_project.net, 0, 0);
  connect(&m_undo, &QUndoStack::cleanChanged, this, &Document::titleChanged);
  connect(&m_undo, &QUndoStack::indexChanged, this,
          &Document::countSteps); // first: others ask for the number
  connect(this, &Document::ruleDraftChanged, this, &Document::titleChanged);
}

Document::~Document()
{
  m_undo.disconnect(); // its destructor clears it, and those who listen may be half gone
}

std::shared_ptr<const SpringNet> Document::net() const
{
  if (!m_sharedNet) m_sharedNet = std::make_shared<const SpringNet>(m_project.net);
  return m_sharedNet;
}

QString Document::displayName() const
{
  if (!m_project.name.empty()) return QString::fromStdString(m_project.name);
  if (!m_path.isEmpty()) return QFileInfo(m_path).completeBaseName();
  return tr("Untitled");
}

void Document::start(Project project, const QString& path)
{
  begin(std::move(project), path); // until an edit, the file's own numbers hold
}

void Document::startRecovered(const RecoveredWork& work, const QString& path)
{
  begin(work.project, path, &work);
  if (!path.isEmpty()) m_file = identityOf(path.toStdString()); // who recovers has compared it
}

void Document::begin(Project project, const QString& path, const RecoveredWork* work)
{
  emit projectLeft();
  m_project = std::move(project);
  netWritten(work != nullptr && work->netDerived);
  m_netNumber = ++m_netNumbers;
  m_path = path;
  m_file.reset();
  m_model = m_savedModel = ++m_models;
  m_target = -1;
  m_undo.clear();
  m_savedRules = m_project.tissue.rules;
  m_stepsRecovered = m_stepsBefore = 0;
  if (work != nullptr) {
    m_model = work->model, m_savedModel = work->fileModel; // its journal goes on with its numbers
    m_models = std::max({m_models, m_model, m_savedModel});
    for (const RecoveredState& state : work->history.states) m_models = std::max(m_models, state.model);
    const bool knowsSaved = work->history.saved && !work->fileChanged;
    if (!knowsSaved) m_stepsRecovered = work->steps;
    takeHistory(work->history, knowsSaved);
  }
  replaceDraft(work != nullptr ? work->draft : RuleDraft()); // what was typed about the former rules is gone
  emit ruleBaseChanged(); // first: who hears of the new project asks what its rules say, not the former ones
  emit ruleBaseSaved();
  emit inputsChanged();
  emit projectReset();
  emit titleChanged();
}

/// Puts the steps of a process that was lost on the stack. The document is as they have left it.
void Document::takeHistory(const RecoveredHistory& history, bool knowsSaved)
{
  if (history.states.empty()) return;
  auto all = std::make_shared<RecoveredStates>();
  all->states = history.states;
  const auto present = static_cast<std::size_t>(history.present);
  for (const RecoveredState& state : all->states)
    if (!all->netNumbers.contains(state.copy))
      all->netNumbers[state.copy] = state.copy == all->states[present].copy ? m_netNumber : ++m_netNumbers;
  for (std::size_t to = 1; to < all->states.size(); ++to)
    m_undo.push(new RecoveredStepCommand(*this, all, to));
  m_stepsBefore = history.first;
  m_undo.setIndex(knowsSaved ? *history.saved : history.present);
  m_undo.setClean();
  m_undo.setIndex(history.present);
  if (knowsSaved) m_savedRules = all->states[static_cast<std::size_t>(*history.saved)].project.tissue.rules;
  all->isQuiet = false;
}

static std::filesystem::path folderOf(const QString& file)
{
  return QFileInfo(file).absolutePath().toStdString();
}

Status Document::open(const QString& path)
{
  const auto file = identityOf(path.toStdString()); // before: who writes while it is read is noticed
  auto loaded = loadProject(path.toStdString());
  if (!loaded) return loaded.error();
  const QString ending = QFileInfo(path).suffix().toLower();
  const bool isProject = ending == "esm" || ending == "esmb"; // a plain net is read, never written over
  loaded->source = withAbsoluteNames(std::move(loaded->source), folderOf(path));
  start(std::move(loaded).value(), isProject ? path : QString());
  m_file = file;
  return {};
}

Status Document::saveAs(const QString& path)
{
  // Whoever writes into a device or a pipe has no file afterwards. A shell may want that, a window does not.
  if (const std::string kind = specialFileKind(path.toStdString()); !kind.empty())
    return Error{ErrorCode::FileUnwritable,
                 path.toStdString() + ": cannot be written, it is " + kind + "; save it under another name"};
  // Mesh files are named as seen from where the project is saved; here they are absolute, for it may move.
  emit ruleTextWanted();
  const ImportRecipe source = m_project.source;
  m_project.source = withRelativeNames(source, folderOf(path));
  const Status saved = esm::saveProject(m_project, path.toStdString());
  m_project.source = source;
  if (!saved) return saved.error();
  m_path = path;
  m_file = identityOf(path.toStdString());
  m_savedModel = m_model;
  m_stepsRecovered = 0;
  m_undo.setClean();
  countSteps(m_undo.index());
  m_savedRules = m_project.tissue.rules;
  emit ruleBaseSaved();
  emit projectSaved();
  emit titleChanged();
  return {};
}

bool Document::isForeign(const QString& path) const
{
  return isOtherFile(path.toStdString(), m_file);
}

bool Document::fileChangedOnDisk() const
{
  return !m_path.isEmpty() && isForeign(m_path);
}

int Document::stepsAfterSave() const
{
  return m_stepsRecovered + m_steps;
}

/// The distance to the saved state on the undo stack; where that has left it, by a step after an undo, what
/// it was then and what followed.
void Document::countSteps(int index)
{
  if (const int clean = m_undo.cleanIndex(); clean >= 0) {
    m_steps = std::abs(index - clean);
    m_lostAt = 0;
  } else {
    if (m_lostAt == 0) m_lostSteps = m_steps, m_lostAt = index;
    m_steps = m_lostSteps + 1 + std::abs(index - m_lostAt);
  }
}

void Document::setView(const ViewSettings& view)
{
  m_project.view = view;
}

// === Fuzzy panels

const std::vector<fuzzy::InputValue>& Document::inputs() const
{
  const TissueModel& tissue = m_project.tissue;
  return m_target < 0 ? tissue.inputs : tissue.regions[static_cast<std::size_t>(m_target)].inputs;
}

QString Document::inputTargetName() const
{
  if (m_target < 0) return tr("Base tissue");
  return QString::fromStdString(m_project.tissue.regions[static_cast<std::size_t>(m_target)].name);
}

void Document::setRuleBase(fuzzy::RuleBase ruleBase, const QString& undoText, int gesture)
{
  if (ruleBase == m_project.tissue.rules) return;
  pushTissue(std::make_unique<SetRuleBaseCommand>(*this, std::move(ruleBase), undoText, gesture));
}

void Document::setInput(int input, fuzzy::InputValue value, int gesture)
{
  if (input < 0 || static_cast<std::size_t>(input) >= inputs().size()) return;
  if (inputs()[static_cast<std::size_t>(input)] == value || !mayEditInputs()) return;
  pushTissue(std::make_unique<SetInputCommand>(*this, m_target, input, std::move(value), gesture));
}

void Document::setInputs(std::vector<fuzzy::InputValue> values, const QString& undoText, int gesture)
{
  if (values.size() != inputs().size() || values == inputs() || !mayEditInputs()) return;
  pushTissue(std::make_unique<SetInputsCommand>(*this, m_target, std::move(values), undoText, gesture));
}

/// The words of a locked region are locked too.
bool Document::mayEditInputs()
{
  if (m_target < 0) return true;
  const Status status = mayEditRegion(m_project.tissue, static_cast<std::size_t>(m_target));
  if (!status) refuse(status.error());
  return status.hasValue();
}

void Document::setInputTarget(int region)
{
  const int last = static_cast<int>(m_project.tissue.regions.size()) - 1;
  region = std::clamp(region, -1, last);
  const bool moved = region != m_target;
  m_target = region;
  if (moved) emit inputTargetChanged(region);
  emit inputsChanged();
}

void Document::setRuleLanguage(Language language)
{
  if (language == m_language) return;
  m_language = language;
  emit ruleLanguageChanged();
  emit inputsChanged(); // the target's name is in the window's language
}

// === Tissue and regions

/// Of what region_edit.h has made of a copy of the tissue.
void Document::pushRegions(const Status& edited, TissueModel tissue, int chosenBefore, int chosen,
                           const QString& text, int gesture)
{
  if (!edited) return refuse(edited.error());
  if (tissue.regions == m_project.tissue.regions) return;
  pushTissue(std::make_unique<EditRegionsCommand>(*this, std::move(tissue.regions), chosenBefore, chosen,
                                                  text, gesture));
}

void Document::addRegion(Region region)
{
  TissueModel tissue = m_project.tissue;
  region.inputs.resize(tissue.rules.inputs.size());
  const std::size_t place = tissue.regions.size();
  const Status edited = esm::insertRegion(tissue, place, std::move(region));
  pushRegions(edited, std::move(tissue), m_target, static_cast<int>(place), tr("add region"));
}

void Document::removeRegion(int index)
{
  TissueModel tissue = m_project.tissue;
  const Status edited = esm::removeRegion(tissue, static_cast<std::size_t>(index));
  pushRegions(edited, std::move(tissue), index, index - 1, tr("remove region"));
}

void Document::moveRegion(int from, int to)
{
  TissueModel tissue = m_project.tissue;
  const Status edited = esm::moveRegion(tissue, static_cast<std::size_t>(from), static_cast<std::size_t>(to));
  pushRegions(edited, std::move(tissue), from, to, tr("reorder regions"));
}

void Document::setRegion(int index, Region region, const QString& undoText, int gesture)
{
  TissueModel tissue = m_project.tissue;
  const Status edited = esm::replaceRegion(tissue, static_cast<std::size_t>(index), std::move(region));
  pushRegions(edited, std::move(tissue), index, index, undoText, gesture);
}

void Document::lockRegion(int index, bool locked)
{
  TissueModel tissue = m_project.tissue;
  const Status edited = esm::lockRegion(tissue, static_cast<std::size_t>(index), locked);
  pushRegions(edited, std::move(tissue), index, index, locked ? tr("lock region") : tr("unlock region"));
}

void Document::showRegion(int index, bool visible)
{
  TissueModel tissue = m_project.tissue;
  const Status edited = esm::showRegion(tissue, static_cast<std::size_t>(index), visible);
  pushRegions(edited, std::move(tissue), index, index, visible ? tr("show region") : tr("hide region"));
}

void Document::detachTwin(int index)
{
  TissueModel tissue = m_project.tissue;
  const Status edited = esm::detachTwin(tissue, static_cast<std::size_t>(index));
  pushRegions(edited, std::move(tissue), index, index, tr("make the twin a region of its own"));
}

void Document::setTissueSettings(const TissueSettings& settings, int gesture)
{
  if (settings == settingsOf(m_project.tissue)) return;
  pushTissue(std::make_unique<SetTissueSettingsCommand>(*this, settings, gesture));
}

void Document::setParametersFromTissue(bool on)
{
  if (on == m_project.parametersFromTissue) return;
  SpringNet net = m_project.net;
  if (on && net.nodeCount() > 0) {
    if (auto applied = applyTissue(m_project.tissue, net); !applied) {
      emit problem(applied.error());
      emit tissueSettingsChanged(); // the switch goes back
      return;
    }
  }
  m_undo.push(
    new SetParametersFromTissueCommand(*this, on, std::make_shared<const SpringNet>(std::move(net))));
}

void Document::keepTargetInRange()
{
  const int last = static_cast<int>(m_project.tissue.regions.size()) - 1;
  if (m_target > last) setInputTarget(last);
}

// === Model

Status Document::importModel(IncomingModel model, bool replace)
{
  ModelPart part;
  part.derived = true;
  part.model = replace && m_project.net.nodeCount() > 0 ? ++m_models : m_model;
  part.parametersFromTissue = true;
  part.loads.gravity = m_project.loads.gravity;
  part.tissue = model.tissue ? std::move(*model.tissue) : m_project.tissue;
  SpringNet net;
  if (replace) {
    part.name = model.name.toStdString();
    part.source = model.source;
    net = std::move(model.net);
  } else {
    part.name = m_project.name;
    part.source = m_project.source;
    part.loads = m_project.loads; // indices of the former nodes stay
    net = m_project.net;
    appendNet(net, model.net, part.tissue.thickness);
  }
  if (auto applied = applyTissue(part.tissue, net); !applied) return applied.error();
  part.net = std::make_shared<const SpringNet>(std::move(net));
  m_undo.push(new SetModelCommand(*this, std::move(part),
                                  replace ? tr("import %1").arg(model.name) : tr("add %1").arg(model.name)));
  return {};
}

void Document::replaceNet(Project project, const QString& undoText)
{
  ModelPart part;
  part.model = m_model; // the same organ, as its files hold it now
  part.name = m_project.name;
  part.tissue = m_project.tissue;
  part.source = std::move(project.source);
  part.net = std::make_shared<const SpringNet>(std::move(project.net));
  part.loads = std::move(project.loads);
  part.parametersFromTissue = project.parametersFromTissue;
  m_undo.push(new SetModelCommand(*this, std::move(part), undoText));
}

void Document::rename(const QString& name)
{
  if (name.toStdString() != m_project.name) m_undo.push(new RenameCommand(*this, name.toStdString()));
}

void Document::setFixed(const std::vector<Index>& nodes, bool fixed)
{
  if (!nodes.empty()) m_undo.push(new SetFixedCommand(*this, nodes, fixed));
}

void Document::setGravity(const Eigen::Vector3d& gravity, int gesture)
{
  if (gravity != m_project.loads.gravity) m_undo.push(new SetGravityCommand(*this, gravity, gesture));
}

void Document::setSolver(const std::string& name)
{
  if (name != m_project.simulation.solver.solver) m_undo.push(new SetSolverCommand(*this, name));
}

} // namespace esm
