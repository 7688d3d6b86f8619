// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/recovery/session.h"

#include "core/base/hash.h"
#include "core/net/net_builder.h"
#include "core/project/journal_reader.h"
#include "core/project/project_io.h"
#include "tests/app/sheet.h"

#include <cstdio>
#include <cstdlib>

namespace esm::test {

void Session::open()
{
  Project project = sheetProject(12);
  project.net.stiffness *= 1.5; // numbers of the file's own, which undo brings back
  if (!saveProject(project, m_file) || !m_document->open(QString::fromStdString(m_file.string())))
    std::abort();
}

void Session::import(int step, bool replace)
{
  IncomingModel model;
  model.name = QStringLiteral("model %1").arg(step);
  model.source.files = {{m_file.parent_path() / "mesh.obj", 0}};
  model.net = buildNet(sheetMesh(5 + step % 9)).value();
  if (!m_document->importModel(std::move(model), replace)) std::abort();
}

void Session::step(int step)
{
  const double part = (step % 17) / 17.0;
  fuzzy::RuleBase rules = m_document->ruleBase();
  Region region;
  switch (step % 16) { // one command each: what lies within a command is not to be kept apart
  case 1:
  case 2:
  case 3: // values of one drag
    m_document->setInput(0, 0.2 * (step % 16) + 0.1 * part, 1 + step / 16);
    break;
  case 4:
    region.name = "region " + std::to_string(step);
    region.ellipsoid.centre = Eigen::Vector3d(0.1 * part, 0.02, 0.0);
    region.ellipsoid.semiAxes.setConstant(0.02 + 0.01 * part);
    region.inputs = m_document->project().tissue.inputs;
    region.inputs[0] = 0.9 - 0.3 * part;
    m_document->addRegion(region);
    break;
  case 5:
    rules.rules[static_cast<std::size_t>(step) % rules.rules.size()].weight = 0.2 + 0.7 * part;
    m_document->setRuleBase(std::move(rules), QStringLiteral("weight"));
    break;
  case 6:
    m_document->setFixed({0, step % m_document->project().net.nodeCount()}, step % 32 == 6);
    break;
  case 7:
  case 11:
  case 12:
    m_document->undoStack()->undo();
    break;
  case 8:
    import(step, step % 32 == 8);
    break;
  case 9:
    m_document->setDraftCell(step % 5, 1, "hardnes IS vrey " + std::to_string(step));
    break;
  case 10:
    m_document->setGravity({0.0, part, -9.81});
    break;
  case 13:
    m_document->undoStack()->redo();
    break;
  case 14:
    m_document->setTissueSettings({0.001 + 0.002 * part, 1000.0 + step, SpringLaw::Linear, 0.0});
    break;
  case 15:
    if (step % 32 == 15) m_document->setDraftCell(-1, 0, {});
    break;
  default:
    m_save();
  }
}

std::string fingerprint(Project project, const RuleDraft& draft)
{
  project.view = ViewSettings();
  const std::string bytes = toCbor(project) + '\n' + draft.text + '\n' + std::to_string(draft.row) + ' ' +
                            std::to_string(draft.column) + ' ' + draft.cell;
  return std::to_string(fingerprintOf(bytes));
}

std::string foundFingerprint(const std::filesystem::path& recovery, const std::filesystem::path& file)
{
  Result<Project> saved = loadProject(file); // whatever else is there: the file is never lost
  if (!saved) return {};
  const std::vector<FoundJournal> found = findJournals(recovery);
  if (found.size() > 1) return "more than one journal";
  if (found.empty()) {
    saved->source = withAbsoluteNames(std::move(saved->source), file.parent_path());
    return fingerprint(std::move(*saved), {});
  }
  if (found[0].fault) return found[0].fault->detail;
  Result<RecoveredWork> work = readJournal(found[0]);
  return work ? fingerprint(std::move(work->project), work->draft) : work.error().detail;
}

} // namespace esm::test
