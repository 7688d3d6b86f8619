// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/terms/term_fields.h"

#include "fuzzyeditor/number_spin_box.h"
#include "fuzzyeditor/rules/rule_display.h"
#include "fuzzyeditor/terms/term_edits.h"
#include "fuzzyeditor/terms/term_plot.h"

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {

namespace {

constexpr fuzzy::Form kForms[] = {fuzzy::Form::Triangle, fuzzy::Form::Trapezoid, fuzzy::Form::LeftShoulder,
                                  fuzzy::Form::RightShoulder, fuzzy::Form::Gaussian};

/// Decimals that tell apart 1/10,000 of the range, at least three.
int decimalsFor(double least, double greatest, bool logarithmic)
{
  const double finest = logarithmic ? least / 100.0 : (greatest - least) / 1e4;
  return std::clamp(static_cast<int>(std::ceil(-std::log10(finest))), 3, 9);
}

} // namespace

TermFields::TermFields(TermEdits* edits, QWidget* parent)
  : QWidget(parent),
    m_edits(edits),
    m_term(new QComboBox),
    m_form(new QComboBox),
    m_add(new QToolButton),
    m_remove(new QToolButton),
    m_english(new QLineEdit),
    m_german(new QLineEdit),
    m_englishLabel(new QLabel),
    m_germanLabel(new QLabel)
{
  m_term->setObjectName("termChoice");
  m_form->setObjectName("termForm");
  m_add->setObjectName("termAdd");
  m_remove->setObjectName("termRemove");
  m_english->setObjectName("termEnglish");
  m_german->setObjectName("termGerman");
  m_add->setText(QStringLiteral("+"));
  m_remove->setText(QChar(0x2212));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  const auto row = [layout](std::initializer_list<std::pair<QWidget*, int>> widgets) {
    auto* line = new QHBoxLayout;
    line->setSpacing(4);
    for (const auto& [widget, stretch] : widgets) line->addWidget(widget, stretch);
    layout->addLayout(line);
  };
  for (QComboBox* box : {m_term, m_form}) {
    box->setMinimumContentsLength(6);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  }
  for (QLineEdit* name : {m_english, m_german}) name->setMinimumWidth(60);
  row({{m_term, 3}, {m_form, 4}, {m_add, 0}, {m_remove, 0}}); // "Schulter nach rechts" is the longest
  row({{m_englishLabel, 0}, {m_english, 1}, {m_germanLabel, 0}, {m_german, 1}});
  auto* grid = new QGridLayout;
  grid->setSpacing(4);
  for (int i = 0; i < 4; ++i) {
    Field& field = m_fields[static_cast<std::size_t>(i)];
    field.label = new QLabel;
    field.box = new NumberSpinBox;
    field.box->setObjectName(QStringLiteral("termPlace%1").arg(i));
    field.box->setMinimumWidth(70);
    field.label->setBuddy(field.box);
    for (QWidget* part : std::initializer_list<QWidget*>{field.label, field.box}) {
      QSizePolicy policy = part->sizePolicy(); // the plot keeps its height whatever term is chosen
      policy.setRetainSizeWhenHidden(true);
      part->setSizePolicy(policy);
    }
    grid->addWidget(field.label, i / 2, 2 * (i % 2));
    grid->addWidget(field.box, i / 2, 2 * (i % 2) + 1);
    grid->setColumnStretch(2 * (i % 2) + 1, 1);
    connect(field.box, &NumberSpinBox::aboutToStep, this, [&field] { field.stepped = true; });
    connect(field.box, &QDoubleSpinBox::valueChanged, this,
            [this, &field](double value) { takeValue(field, value, std::exchange(field.stepped, false)); });
  }
  layout->addLayout(grid);
  layout->addStretch();

  connect(m_term, &QComboBox::currentIndexChanged, m_edits, &TermEdits::chooseTerm);
  connect(m_form, &QComboBox::activated, this,
          [this](int form) { m_edits->setForm(m_edits->term(), kForms[form]); });
  connect(m_add, &QToolButton::clicked, m_edits, &TermEdits::addTerm);
  connect(m_remove, &QToolButton::clicked, this, [this] { m_edits->removeTerm(m_edits->term()); });
  for (QLineEdit* name : {m_english, m_german})
    connect(name, &QLineEdit::editingFinished, this, &TermFields::takeNames);
  connect(edits, &TermEdits::changed, this, &TermFields::refresh);
  retranslate();
}

void TermFields::changeEvent(QEvent* event)
{
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

void TermFields::retranslate()
{
  m_term->setAccessibleName(tr("Word to edit"));
  m_form->setAccessibleName(tr("Form of the word's curve"));
  m_form->setToolTip(tr("Form of the word's curve"));
  m_add->setAccessibleName(tr("Add a word"));
  m_add->setToolTip(tr("Add a word where there is most room"));
  m_remove->setAccessibleName(tr("Remove the word"));
  m_remove->setToolTip(tr("Remove the word, if no rule speaks of it"));
  m_englishLabel->setText(tr("English"));
  m_germanLabel->setText(tr("German"));
  m_english->setAccessibleName(tr("English name of the word"));
  m_german->setAccessibleName(tr("German name of the word"));
  const QString forms[] = {tr("triangle"), tr("trapezoid"), tr("shoulder to the left"),
                           tr("shoulder to the right"), tr("bell (Gauss)")};
  const QSignalBlocker quiet(m_form);
  m_form->clear();
  for (const QString& form : forms) m_form->addItem(form);
  refresh();
}

void TermFields::refresh()
{
  const bool any = m_edits->chosenTerm() != nullptr;
  for (QWidget* widget : std::initializer_list<QWidget*>{m_term, m_form, m_remove, m_english, m_german})
    widget->setEnabled(any);
  m_add->setEnabled(m_edits->variable() != nullptr);
  showTerms();
  showNames();
  showPlaces();
}

void TermFields::showTerms()
{
  const QSignalBlocker quietTerm(m_term), quietForm(m_form);
  QStringList names, shown;
  if (const fuzzy::Variable* v = m_edits->variable())
    for (const fuzzy::Term& term : v->terms) names << toQt(term.name.in(m_edits->document()->ruleLanguage()));
  for (int i = 0; i < m_term->count(); ++i) shown << m_term->itemText(i);
  if (names != shown) {
    m_term->clear();
    m_term->addItems(names);
  }
  m_term->setCurrentIndex(m_edits->term());
  if (const fuzzy::Term* term = m_edits->chosenTerm())
    m_form->setCurrentIndex(static_cast<int>(
      std::find(std::begin(kForms), std::end(kForms), fuzzy::formOf(*term)) - std::begin(kForms)));
}

void TermFields::showNames()
{
  const fuzzy::Term* term = m_edits->chosenTerm();
  const auto show = [](QLineEdit* edit, const QString& text) {
    if (edit->text() != text) edit->setText(text);
  };
  show(m_english, term ? toQt(term->name.english) : QString());
  show(m_german, term ? toQt(term->name.german) : QString());
}

void TermFields::takeNames()
{
  if (!m_edits->chosenTerm()) return;
  const fuzzy::Names names{toUtf8(m_english->text().simplified()), toUtf8(m_german->text().simplified())};
  m_edits->rename(m_edits->term(), names);
}

// === Numbers

bool TermFields::isDeviation(const Field& field) const
{
  return field.handle == fuzzy::Handle::RightFlank;
}

/// In the display unit; a deviation on a logarithmic axis is a number of decades.
double TermFields::shownValue(const Field& field) const
{
  const fuzzy::Variable& v = *m_edits->variable();
  const double factor = RuleDisplay::displayUnit(v.unit).factor;
  const fuzzy::Term& term = *m_edits->chosenTerm();
  if (isDeviation(field)) return v.logarithmic ? term.parameters[1] : term.parameters[1] / factor;
  const double place = fuzzy::placeOf(term, field.handle);
  return (v.logarithmic ? std::pow(10.0, place) : place) / factor;
}

void TermFields::takeValue(const Field& field, double shown, bool stepped)
{
  const fuzzy::Variable* v = m_edits->variable();
  const fuzzy::Term* term = m_edits->chosenTerm();
  if (!v || !term) return;
  const int chosen = m_edits->term();
  fuzzy::Handle handle = field.handle;
  const double factor = RuleDisplay::displayUnit(v->unit).factor;
  double place = v->logarithmic ? std::log10(shown * factor) : shown * factor;
  if (isDeviation(field)) { // by the flank that has more room
    const fuzzy::Axis axis = fuzzy::axisOf(*v);
    const double mean = term->parameters[0], deviation = v->logarithmic ? shown : shown * factor;
    const bool right = axis.high - mean > mean - axis.low;
    handle = right ? fuzzy::Handle::RightFlank : fuzzy::Handle::LeftFlank;
    place = right ? mean + deviation : mean - deviation;
  }
  if (stepped)
    m_edits->step(chosen, handle, place);
  else
    m_edits->place(chosen, handle, place);
  showPlaces(); // the limit, where the number was beyond it
}

void TermFields::showPlaces()
{
  const fuzzy::Variable* v = m_edits->variable();
  const fuzzy::Term* term = m_edits->chosenTerm();
  std::vector<fuzzy::Handle> handles = v && term ? fuzzy::handlesOf(*term) : std::vector<fuzzy::Handle>();
  handles.erase(std::remove(handles.begin(), handles.end(), fuzzy::Handle::LeftFlank), handles.end());
  for (std::size_t i = 0; i < m_fields.size(); ++i) {
    Field& field = m_fields[i];
    const bool used = i < handles.size();
    field.label->setVisible(used);
    field.box->setVisible(used);
    if (!used) {
      field.box->setNamesForAccess(tr("Place of the word")); // hidden, but in the tree
      continue;
    }
    field.handle = handles[i];
    const bool deviation = isDeviation(field);
    const DisplayUnit unit = RuleDisplay::displayUnit(v->unit);
    const QString name = deviation ? tr("deviation") : TermPlot::handleName(*term, field.handle);
    const QSignalBlocker quiet(field.box);
    field.label->setText(name);
    field.box->setNamesForAccess(
      tr("%1: %2").arg(toQt(term->name.in(m_edits->document()->ruleLanguage())), name));
    field.box->setDecimals(decimalsFor(v->minimum / unit.factor, v->maximum / unit.factor, v->logarithmic));
    const double value = shownValue(field);
    const double least = deviation ? 0.0 : v->minimum / unit.factor;
    field.box->setRange(std::min(value, least), std::max(value, v->maximum / unit.factor));
    field.box->setSuffix(deviation && v->logarithmic ? tr(" decades")
                         : unit.symbol.isEmpty()     ? QString()
                                                     : QChar(0x00a0) + unit.symbol);
    field.box->setStepType(v->logarithmic && !deviation ? QAbstractSpinBox::AdaptiveDecimalStepType
                                                        : QAbstractSpinBox::DefaultStepType);
    field.box->setSingleStep((v->maximum - v->minimum) / unit.factor / 100.0);
    if (deviation && v->logarithmic) field.box->setSingleStep(0.01);
    field.box->setValue(value);
  }
}

} // namespace esm
