// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/terms/term_edits.h"

#include "core/fuzzy/words.h"
#include "fuzzyeditor/rules/rule_display.h"

#include <algorithm>

namespace esm {

namespace {

const fuzzy::Variable* variableOf(const fuzzy::RuleBase& rules, bool output, int index)
{
  const std::vector<fuzzy::Variable>& list = output ? rules.outputs : rules.inputs;
  const auto place = static_cast<std::size_t>(index);
  return index >= 0 && place < list.size() ? &list[place] : nullptr;
}

bool isSameName(const std::string& a, const std::string& b)
{
  return fuzzy::foldCase(a) == fuzzy::foldCase(b);
}

} // namespace

TermEdits::TermEdits(FuzzyDocument* document, QObject* parent) : QObject(parent), m_document(document)
{
  connect(document, &FuzzyDocument::ruleBaseChanged, this, &TermEdits::refresh);
  connect(document, &FuzzyDocument::ruleBaseSaved, this, &TermEdits::changed);
  connect(document, &FuzzyDocument::ruleLanguageChanged, this, &TermEdits::changed);
}

void TermEdits::refresh()
{
  const fuzzy::Variable* v = variable();
  const int count = v ? static_cast<int>(v->terms.size()) : 0;
  m_term = std::clamp(m_term, count > 0 ? 0 : -1, count - 1);
  emit refused(QString());
  emit changed();
}

void TermEdits::setVariable(bool output, int index)
{
  if (m_dragging) cancelDrag();
  m_output = output;
  m_index = index;
  m_term = 0;
  m_keys.end();
  refresh();
}

const fuzzy::Variable* TermEdits::variable() const
{
  return variableOf(m_document->ruleBase(), m_output, m_index);
}

const fuzzy::Variable* TermEdits::savedVariable() const
{
  const fuzzy::Variable* v = variable();
  if (!v) return nullptr;
  const fuzzy::RuleBase& saved = m_document->savedRuleBase();
  return m_output ? saved.findOutput(v->id) : saved.findInput(v->id);
}

const fuzzy::Term* TermEdits::chosenTerm() const
{
  const fuzzy::Variable* v = variable();
  const auto index = static_cast<std::size_t>(m_term);
  return v && m_term >= 0 && index < v->terms.size() ? &v->terms[index] : nullptr;
}

void TermEdits::chooseTerm(int term)
{
  const fuzzy::Variable* v = variable();
  if (!v || term < 0 || term >= static_cast<int>(v->terms.size()) || term == m_term) return;
  m_term = term;
  emit refused(QString());
  emit changed();
}

// === Partition

bool TermEdits::keepsPartition() const
{
  const fuzzy::Variable* v = m_dragging ? &m_start : variable();
  return v && !m_free.contains(toQt(v->id)) && fuzzy::isPartition(*v);
}

bool TermEdits::canKeepPartition() const
{
  const fuzzy::Variable* v = variable();
  return v && !v->terms.empty() && fuzzy::fittedPartition(*v).has_value();
}

void TermEdits::setKeepsPartition(bool keep)
{
  const fuzzy::Variable* v = variable();
  if (!v || keep == keepsPartition()) return;
  m_free.removeAll(toQt(v->id));
  if (!keep) m_free << toQt(v->id);
  if (keep && !fuzzy::isPartition(*v))
    if (auto fitted = fuzzy::fittedPartition(*v)) {
      put(std::move(*fitted), tr("Let memberships sum to 1"));
      return;
    }
  emit changed();
}

// === Handles

fuzzy::Limits TermEdits::limits(int term, fuzzy::Handle handle) const
{
  const fuzzy::Variable* v = m_dragging ? &m_start : variable();
  return v ? fuzzy::limitsOf(*v, term, handle, keepsPartition()) : fuzzy::Limits{};
}

void TermEdits::beginDrag()
{
  const fuzzy::Variable* v = variable();
  if (!v) return;
  m_start = *v;
  m_gesture = nextGesture();
  m_keys.end();
  m_dragging = true;
}

void TermEdits::drag(int term, fuzzy::Handle handle, double place)
{
  if (m_dragging) move(m_start, term, handle, place, m_gesture);
}

void TermEdits::cancelDrag()
{
  if (!m_dragging) return;
  put(m_start.terms, tr("Change “%1”").arg(nameOf(m_term)), m_gesture);
  m_dragging = false;
}

void TermEdits::step(int term, fuzzy::Handle handle, double place)
{
  const fuzzy::Variable* v = variable();
  if (!v) return;
  const bool same =
    term == m_steppedTerm && handle == m_steppedHandle && m_start.terms.size() == v->terms.size();
  if (!same) m_keys.end();
  if (!m_keys.goesOn()) {
    m_start = *v;
    m_steppedTerm = term;
    m_steppedHandle = handle;
  }
  move(m_start, term, handle, place, m_keys.press());
}

void TermEdits::place(int term, fuzzy::Handle handle, double place)
{
  m_keys.end();
  if (const fuzzy::Variable* v = variable()) move(*v, term, handle, place, 0);
}

void TermEdits::move(const fuzzy::Variable& from, int term, fuzzy::Handle handle, double place, int gesture)
{
  put(fuzzy::moveHandle(from, term, handle, place, keepsPartition()), tr("Change “%1”").arg(nameOf(term)),
      gesture);
}

bool TermEdits::put(std::vector<fuzzy::Term> terms, const QString& undoText, int gesture)
{
  fuzzy::RuleBase rules = m_document->ruleBase();
  (m_output ? rules.outputs : rules.inputs)[static_cast<std::size_t>(m_index)].terms = std::move(terms);
  if (Status fits = fuzzy::checkRuleBase(rules); !fits) {
    emit refused(toQt(fits.error().detail));
    return false;
  }
  m_document->setRuleBase(std::move(rules), undoText, gesture);
  return true;
}

// === Terms

QString TermEdits::nameOf(int term) const
{
  const fuzzy::Variable* v = variable();
  const auto index = static_cast<std::size_t>(term);
  if (!v || term < 0 || index >= v->terms.size()) return {};
  return toQt(v->terms[index].name.in(m_document->ruleLanguage()));
}

void TermEdits::rename(int term, const fuzzy::Names& names)
{
  const fuzzy::Variable* v = variable();
  const auto index = static_cast<std::size_t>(term);
  if (!v || index >= v->terms.size() || v->terms[index].name == names) return;
  for (const std::string* name : {&names.english, &names.german})
    if (fuzzy::foldedWords(*name).empty()) {
      emit refused(tr("A word needs a name in both languages."));
      return;
    }
  for (std::size_t i = 0; i < v->terms.size(); ++i)
    if (const fuzzy::Names& other = v->terms[i].name;
        i != index && (isSameName(other.english, names.english) || isSameName(other.german, names.german))) {
      emit refused(tr("“%1” is the name of another word of this variable.")
                     .arg(toQt(isSameName(other.english, names.english) ? names.english : names.german)));
      return;
    }
  std::vector<fuzzy::Term> terms = v->terms;
  terms[index].name = names;
  put(std::move(terms), tr("Rename “%1”").arg(nameOf(term)));
}

void TermEdits::setForm(int term, fuzzy::Form form)
{
  const fuzzy::Variable* v = variable();
  const auto index = static_cast<std::size_t>(term);
  if (!v || index >= v->terms.size() || fuzzy::formOf(v->terms[index]) == form) return;
  fuzzy::Variable changed = *v;
  changed.terms[index] = fuzzy::withForm(v->terms[index], form, fuzzy::axisOf(*v));
  if (keepsPartition())
    if (auto fitted = fuzzy::fittedPartition(changed)) changed.terms = std::move(*fitted);
  put(std::move(changed.terms), tr("Change the form of “%1”").arg(nameOf(term)));
}

/// A word with an id of its own. Its name is data, in both languages whatever the window's is.
fuzzy::Term TermEdits::newWord(const std::vector<fuzzy::Term>& beside) const
{
  for (std::size_t number = beside.size() + 1;; ++number) {
    const std::string text = std::to_string(number);
    fuzzy::Term word{"word" + text, {"word " + text, "Wort " + text}, fuzzy::Shape::Triangle, {}};
    if (std::none_of(beside.begin(), beside.end(), [&](const fuzzy::Term& other) {
          return isSameName(other.id, word.id) || isSameName(other.name.english, word.name.english) ||
                 isSameName(other.name.german, word.name.german);
        }))
      return word;
  }
}

void TermEdits::addTerm()
{
  const fuzzy::Variable* v = variable();
  if (!v) return;
  const fuzzy::Term word = newWord(v->terms);
  std::vector<fuzzy::Term> terms = fuzzy::withNewTerm(*v, keepsPartition());
  terms.back().id = word.id;
  terms.back().name = word.name;
  const int added = static_cast<int>(terms.size()) - 1;
  if (put(std::move(terms), tr("Add a word"))) chooseTerm(added);
}

QString TermEdits::rulesOf(const std::vector<int>& rules) const
{
  QStringList numbers;
  for (const int rule : rules) numbers << QString::number(rule + 1);
  return numbers.join(QStringLiteral(", "));
}

void TermEdits::removeTerm(int term)
{
  const fuzzy::Variable* v = variable();
  const auto index = static_cast<std::size_t>(term);
  if (!v || term < 0 || index >= v->terms.size()) return;
  const std::vector<int> rules = fuzzy::rulesWith(m_document->ruleBase(), v->id, v->terms[index].id);
  if (!rules.empty()) {
    emit refused(tr("“%1” stays: rules speak of it (%2). Change or delete them first.")
                   .arg(nameOf(term), rulesOf(rules)));
    return;
  }
  put(fuzzy::withoutTerm(*v, term, keepsPartition()), tr("Remove “%1”").arg(nameOf(term)));
}

void TermEdits::spreadEvenly(int count)
{
  const fuzzy::Variable* v = variable();
  if (!v || count < 1) return;
  fuzzy::Variable changed = *v;
  while (static_cast<int>(changed.terms.size()) > count) { // words go from the far end, if no rule needs them
    const std::vector<int> order = fuzzy::orderOfCores(changed);
    const auto unused = std::find_if(order.rbegin(), order.rend(), [&](int term) {
      return fuzzy::rulesWith(m_document->ruleBase(), v->id, changed.terms[static_cast<std::size_t>(term)].id)
        .empty();
    });
    if (unused == order.rend()) {
      emit refused(tr("Rules speak of %1 words of this variable, so that fewer cannot be spread. Change or "
                      "delete rules first.")
                     .arg(changed.terms.size()));
      return;
    }
    changed.terms.erase(changed.terms.begin() + *unused);
  }
  const double end = fuzzy::axisOf(*v).high;
  while (static_cast<int>(changed.terms.size()) < count) {
    changed.terms.push_back(newWord(changed.terms));
    changed.terms.back().parameters = {end, end, end}; // behind all others
  }
  changed.terms = fuzzy::spreadEvenly(changed, m_output ? fuzzy::Outside::Flank : fuzzy::Outside::Shoulder);
  put(std::move(changed.terms), tr("Spread words evenly"));
}

} // namespace esm
