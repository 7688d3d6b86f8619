// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/preset_bar.h"

#include "core/tissue/tissue_units.h"
#include "fuzzyeditor/rules/rule_display.h"

#include <QAction>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>

#include <algorithm>

namespace esm {
namespace {

/// A number of a preset as it is shown; damping is a ratio, which no parameter of tissue is.
QString shown(double value, double TissueParameters::*parameter, Language language)
{
  if (parameter) return toQt(shownValue(value, parameter, language));
  const QLocale locale(language == Language::German ? QLocale::German : QLocale::English);
  return locale.toString(value, 'f', 2);
}

QString withCapital(QString text)
{
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

} // namespace

PresetBar::PresetBar(FuzzyDocument* document, QWidget* parent)
  : QWidget(parent),
    m_document(document),
    m_choose(new QToolButton),
    m_info(new QToolButton),
    m_reset(new QToolButton),
    m_menu(new QMenu(this)),
    m_current(new QLabel),
    m_details(new QLabel)
{
  m_choose->setObjectName("presetChoose");
  m_info->setObjectName("presetInfo");
  m_reset->setObjectName("inputsReset");
  m_menu->setObjectName("presetMenu");
  m_current->setObjectName("presetCurrent");
  m_details->setObjectName("presetDetails");
  m_choose->setPopupMode(QToolButton::InstantPopup);
  m_choose->setMenu(m_menu);
  m_menu->setToolTipsVisible(true);
  m_info->setCheckable(true);
  for (QToolButton* button : {m_choose, m_info, m_reset}) {
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    button->setFocusPolicy(Qt::TabFocus);
  }
  m_current->setTextFormat(Qt::PlainText);
  m_current->setWordWrap(true);
  m_details->setTextFormat(Qt::RichText);
  m_details->setWordWrap(true);
  m_details->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  m_details->hide();
  for (const TissuePreset& preset : tissuePresets()) {
    QAction* action = m_menu->addAction(QString());
    action->setObjectName(QStringLiteral("actPreset_") + preset.id);
    connect(action, &QAction::triggered, this, [this, &preset] { apply(preset); });
    m_actions.push_back(action);
  }

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(4);
  grid->setVerticalSpacing(4);
  grid->addWidget(m_choose, 0, 0);
  grid->addWidget(m_info, 0, 1);
  grid->addWidget(m_reset, 0, 2);
  grid->setColumnStretch(3, 1);
  grid->addWidget(m_current, 1, 0, 1, 4);
  grid->addWidget(m_details, 2, 0, 1, 4);

  connect(m_info, &QToolButton::toggled, this, &PresetBar::showCurrent);
  connect(m_reset, &QToolButton::clicked, this, &PresetBar::resetInputs);
  connect(document, &FuzzyDocument::ruleBaseChanged, this, &PresetBar::followRuleBase);
  connect(document, &FuzzyDocument::inputsChanged, this, &PresetBar::showCurrent);
  retranslate();
}

void PresetBar::followRuleBase()
{
  m_stale = true;
  showCurrent();
}

/// What each preset says about which input: the values that differ from a word nobody has.
void PresetBar::readPresets()
{
  if (!std::exchange(m_stale, false)) return;
  const fuzzy::RuleBase& rules = m_document->ruleBase();
  const std::vector<fuzzy::InputValue> untouched(rules.inputs.size(), fuzzy::Word{"\x01", {}});
  m_values.clear();
  for (std::size_t p = 0; p < tissuePresets().size(); ++p) {
    std::optional<Values>& values = m_values.emplace_back();
    const auto inputs = withPreset(tissuePresets()[p], rules, untouched);
    if (inputs) {
      values.emplace();
      for (std::size_t i = 0; i < inputs->size(); ++i)
        if ((*inputs)[i] != untouched[i]) values->emplace_back(i, (*inputs)[i]);
    }
    m_actions[p]->setEnabled(values.has_value());
  }
}

const TissuePreset* PresetBar::current() const
{
  const std::vector<fuzzy::InputValue>& inputs = m_document->inputs();
  for (std::size_t p = 0; p < m_values.size(); ++p)
    if (m_values[p] && std::all_of(m_values[p]->begin(), m_values[p]->end(), [&](const auto& value) {
          return value.first < inputs.size() && inputs[value.first] == value.second;
        }))
      return &tissuePresets()[p];
  return nullptr;
}

void PresetBar::apply(const TissuePreset& preset)
{
  auto inputs = withPreset(preset, m_document->ruleBase(), m_document->inputs());
  if (!inputs) return; // its action is off
  m_document->setInputs(std::move(inputs).value(),
                        tr("Preset: %1").arg(toQt(preset.name.in(m_document->ruleLanguage()))));
}

void PresetBar::resetInputs()
{
  std::vector<fuzzy::InputValue> inputs;
  for (const fuzzy::Variable& input : m_document->ruleBase().inputs) inputs.emplace_back(input.defaultValue);
  m_document->setInputs(std::move(inputs), tr("Reset all inputs"));
}

QString PresetBar::measurements(const TissuePreset& preset, Language language)
{
  struct Row {
    QString name;
    const Measurement* measurement;
    double TissueParameters::*parameter;
  };
  using P = TissueParameters;
  const auto nameOf = [&](double P::*parameter) { return withCapital(toQt(shownName(parameter, language))); };
  QString text = QStringLiteral("<b>%1</b><table cellspacing='4'>")
                   .arg(withCapital(toQt(preset.name.in(language))).toHtmlEscaped());
  for (const Row& row : {Row{nameOf(&P::youngsModulus), &preset.youngsModulus, &P::youngsModulus},
                         Row{nameOf(&P::density), &preset.density, &P::density},
                         Row{tr("Damping ratio"), &preset.damping, nullptr},
                         Row{nameOf(&P::ruptureStrain), &preset.ruptureStrain, &P::ruptureStrain}}) {
    const Measurement& m = *row.measurement;
    QString value = shown(m.typical, row.parameter, language);
    if (m.low < m.high)
      value = tr("%1 (%2 to %3)")
                .arg(value, shown(m.low, row.parameter, language), shown(m.high, row.parameter, language));
    QStringList origin; // an estimate has no method, but may have a basis
    if (!m.isEstimate) origin << toQt(m.method.in(language));
    if (*m.source != '\0') origin << QString::fromUtf8(m.source);
    if (m.isEstimate) value = QStringLiteral("<i>%1</i>").arg(tr("%1, estimate").arg(value));
    text += QStringLiteral("<tr><td>%1</td><td>%2<br><small>%3</small></td></tr>")
              .arg(row.name.toHtmlEscaped(), value, origin.join(": ").toHtmlEscaped());
  }
  text += QStringLiteral("</table>");
  if (!preset.remark.in(language).empty())
    text += QStringLiteral("<small>%1</small>")
              .arg(withCapital(toQt(preset.remark.in(language))).toHtmlEscaped() + '.');
  return text;
}

void PresetBar::showCurrent()
{
  if (!isVisible()) return;
  readPresets();
  const Language language = m_document->ruleLanguage();
  const TissuePreset* preset = current();
  m_current->setText(preset ? tr("The inputs are those of: %1").arg(toQt(preset->name.in(language)))
                            : tr("The inputs are those of no preset."));
  m_info->setEnabled(preset != nullptr);
  m_details->setVisible(preset && m_info->isChecked());
  if (preset && m_info->isChecked()) m_details->setText(measurements(*preset, language));
  const fuzzy::RuleBase& rules = m_document->ruleBase();
  bool isDefault = m_document->inputs().size() == rules.inputs.size();
  for (std::size_t i = 0; isDefault && i < rules.inputs.size(); ++i)
    isDefault = m_document->inputs()[i] == fuzzy::InputValue(rules.inputs[i].defaultValue);
  m_reset->setEnabled(!isDefault);
}

void PresetBar::retranslate()
{
  const Language language = m_document->ruleLanguage();
  const auto name = [](QToolButton* button, const QString& text, const QString& tip) {
    button->setText(text);
    button->setToolTip(tip);
    button->setAccessibleName(tip);
  };
  name(m_choose, tr("Preset"), tr("Choose a tissue to start from"));
  name(m_info, tr("Sources"), tr("Show what is measured of this tissue, how and by whom"));
  name(m_reset, tr("Reset"), tr("Reset all inputs to their defaults"));
  m_menu->setAccessibleName(tr("Tissues to start from"));
  m_details->setAccessibleName(tr("What is measured of this tissue"));
  for (std::size_t p = 0; p < m_actions.size(); ++p) {
    m_actions[p]->setText(withCapital(toQt(tissuePresets()[p].name.in(language))));
    m_actions[p]->setToolTip(measurements(tissuePresets()[p], language));
  }
  showCurrent();
}

void PresetBar::showEvent(QShowEvent* event)
{
  QWidget::showEvent(event);
  showCurrent();
}

} // namespace esm
