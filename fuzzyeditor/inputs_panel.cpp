// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/inputs_panel.h"

#include "core/base/text_number.h"
#include "core/tissue/tissue_units.h"
#include "fuzzyeditor/badge_label.h"
#include "fuzzyeditor/fuzzy_evaluation.h"
#include "fuzzyeditor/input_row.h"
#include "fuzzyeditor/preset_bar.h"
#include "fuzzyeditor/rules/rule_display.h"

#include <QEvent>
#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

namespace esm {
namespace {

/// What rows are built from; as long as it is the same, they stay (and with them focus and a drag).
std::vector<std::string> shapeOf(const fuzzy::RuleBase& rules)
{
  std::vector<std::string> shape;
  for (const auto* list : {&rules.inputs, &rules.outputs})
    for (const fuzzy::Variable& v : *list)
      shape.push_back(v.id + '|' + v.unit + '|' + formatDouble(v.minimum) + '|' + formatDouble(v.maximum) +
                      (v.logarithmic ? "|log" : ""));
  shape.push_back(std::to_string(rules.inputs.size()));
  return shape;
}

void styleValue(QLabel* label)
{
  QFont bold = label->font();
  bold.setWeight(QFont::DemiBold);
  label->setFont(bold);
  label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
}

} // namespace

InputsPanel::InputsPanel(FuzzyEvaluation* evaluation, QWidget* parent)
  : QWidget(parent),
    m_evaluation(evaluation),
    m_target(new QLabel),
    m_presets(new PresetBar(evaluation->document())),
    m_outputsTitle(new QLabel),
    m_inputsLayout(new QVBoxLayout),
    m_outputsLayout(new QGridLayout),
    m_deflectionName(new QLabel),
    m_deflection(new QLabel)
{
  setObjectName("inputsPanel");
  m_target->setObjectName("inputsTarget");
  m_outputsTitle->setObjectName("outputsTitle");
  m_target->setTextFormat(Qt::PlainText);
  m_target->setWordWrap(true); // a long name shall not push the fields out of sight
  m_target->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  QFont heading = font();
  heading.setBold(true);
  heading.setPointSizeF(heading.pointSizeF() * 1.1);
  m_target->setFont(heading);
  heading.setPointSizeF(font().pointSizeF());
  m_outputsTitle->setFont(heading);

  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->setSpacing(8);
  layout->addWidget(m_target);
  layout->addWidget(m_presets);
  layout->addLayout(m_inputsLayout);
  auto* line = new QFrame;
  line->setFrameShape(QFrame::HLine);
  line->setFrameShadow(QFrame::Sunken);
  layout->addWidget(line);
  layout->addWidget(m_outputsTitle);
  m_outputsLayout->setHorizontalSpacing(12);
  m_outputsLayout->setColumnStretch(0, 1);
  m_deflection->setObjectName("valueDeflection");
  styleValue(m_deflection);
  layout->addLayout(m_outputsLayout);
  layout->addStretch(1);

  auto* scroll = new QScrollArea;
  scroll->setObjectName("inputsScroll");
  scroll->setWidget(content);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  outer->addWidget(scroll);

  FuzzyDocument* document = evaluation->document();
  connect(document, &FuzzyDocument::ruleBaseChanged, this, &InputsPanel::followRuleBase);
  connect(document, &FuzzyDocument::inputsChanged, this, &InputsPanel::showInputs);
  connect(document, &FuzzyDocument::ruleLanguageChanged, this, &InputsPanel::retranslate);
  connect(evaluation, &FuzzyEvaluation::changed, this, &InputsPanel::showOutputs);
  followRuleBase();
}

void InputsPanel::followRuleBase()
{
  if (std::vector<std::string> shape = shapeOf(m_evaluation->document()->ruleBase()); shape != m_shape) {
    m_shape = std::move(shape);
    rebuildRows();
  }
  retranslate(); // names and terms may have changed
}

void InputsPanel::rebuildRows()
{
  const fuzzy::RuleBase& rules = m_evaluation->document()->ruleBase();
  for (InputRow* row : m_inputs) delete row;
  m_inputs.clear();
  for (const OutputRow& row : m_outputs) {
    delete row.name;
    delete row.value;
    delete row.defaultMark;
  }
  m_outputs.clear();
  for (int i = 0; i < static_cast<int>(rules.inputs.size()); ++i) {
    auto* row = new InputRow(m_evaluation->document(), i, this);
    connect(row, &InputRow::focused, this, &InputsPanel::inputFocused);
    m_inputsLayout->addWidget(row);
    m_inputs.push_back(row);
  }
  for (int i = 0; i < static_cast<int>(rules.outputs.size()); ++i) {
    const QString id = toQt(rules.outputs[static_cast<std::size_t>(i)].id);
    OutputRow row{new QLabel, new QLabel, new BadgeLabel};
    row.value->setObjectName("value_" + id);
    row.defaultMark->setObjectName("default_" + id);
    row.defaultMark->setWordWrap(false);
    styleValue(row.value);
    m_outputsLayout->addWidget(row.name, 2 * i, 0);
    m_outputsLayout->addWidget(row.value, 2 * i, 1);
    m_outputsLayout->addWidget(row.defaultMark, 2 * i + 1, 0, 1, 2);
    m_outputs.push_back(row);
  }
  const int below = 2 * static_cast<int>(rules.outputs.size());
  m_outputsLayout->addWidget(m_deflectionName, below, 0);
  m_outputsLayout->addWidget(m_deflection, below, 1);
}

void InputsPanel::showInputs()
{
  m_target->setText(tr("Tissue: %1").arg(m_evaluation->document()->inputTargetName()));
  if (m_evaluation->document()->inputs().size() != m_inputs.size()) return;
  for (InputRow* row : m_inputs) row->showValue();
}

void InputsPanel::showOutputs()
{
  if (!isVisible()) return;
  const FuzzyDocument* document = m_evaluation->document();
  const fuzzy::RuleBase& rules = document->ruleBase();
  const std::vector<fuzzy::OutputValue>& values = m_evaluation->inference().outputs;
  for (std::size_t i = 0; i < m_outputs.size() && i < rules.outputs.size(); ++i) {
    const fuzzy::Variable& variable = rules.outputs[i];
    const OutputRow& row = m_outputs[i];
    const QString name = RuleDisplay::title(variable, document->ruleLanguage());
    const QString value =
      i < values.size() ? RuleDisplay::quantity(values[i].value, variable, locale()) : QStringLiteral("–");
    row.name->setText(name);
    row.value->setText(value);
    row.value->setAccessibleName(name + ' ' + value);
    row.defaultMark->setText(tr("No rule fires: this is the default."));
    row.defaultMark->setVisible(i < values.size() && !values[i].fromRules);
  }
  showDeflection();
}

/// Where the rules speak of what it takes, stiffness and how well the volume is kept.
void InputsPanel::showDeflection()
{
  const fuzzy::RuleBase& rules = m_evaluation->document()->ruleBase();
  const std::vector<fuzzy::OutputValue>& values = m_evaluation->inference().outputs;
  TissueParameters tissue;
  for (const TissueOutput& output : kTissueOutputs)
    for (std::size_t i = 0; i < rules.outputs.size() && i < values.size(); ++i)
      if (rules.outputs[i].id == output.id) tissue.*output.value = values[i].value;
  const bool known = tissue.youngsModulus > 0.0 && tissue.volumeRatio > 0.0;
  m_deflectionName->setVisible(known);
  m_deflection->setVisible(known);
  if (!known) return;
  m_deflectionName->setText(tr("Deflection under 1 N"));
  m_deflection->setText(
    toQt(shownDeflection(deflectionUnder1N(tissue), m_evaluation->document()->ruleLanguage())));
  m_deflection->setAccessibleName(m_deflectionName->text() + ' ' + m_deflection->text());
  for (QLabel* label : {m_deflectionName, m_deflection})
    label->setToolTip(
      tr("How far a flat round probe of 10 mm goes into thick tissue that is held in place."));
}

void InputsPanel::retranslate()
{
  m_outputsTitle->setText(tr("Result"));
  m_presets->retranslate();
  for (InputRow* row : m_inputs) row->retranslate();
  showInputs();
  showOutputs();
}

void InputsPanel::changeEvent(QEvent* event)
{
  QWidget::changeEvent(event);
  // The program's numbers change with its language; widgets keep the locale that they were born with.
  if (event->type() == QEvent::LanguageChange) setLocale(QLocale());
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange) retranslate();
}

void InputsPanel::showEvent(QShowEvent* event)
{
  QWidget::showEvent(event);
  showOutputs();
}

} // namespace esm
