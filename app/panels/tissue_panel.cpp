// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/tissue_panel.h"

#include "app/panels/describe.h"
#include "core/tissue/tissue_model.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>

namespace esm {

TissuePanel::TissuePanel(Document* document, QWidget* parent)
  : QWidget(parent), m_document(document), m_form(new QFormLayout(this))
{
  m_form->setContentsMargins(6, 6, 6, 6);
  m_form->setVerticalSpacing(4);
  m_thickness = addNumber(QStringLiteral("tissueThickness"), 0.01, 100.0, 0.1, 2);
  m_density = addNumber(QStringLiteral("tissueDensity"), 1.0, 20000.0, 10.0, 0);
  m_law = new QComboBox(this);
  m_law->setObjectName(QStringLiteral("tissueLaw"));
  m_law->addItems({QString(), QString(), QString()});
  m_form->addRow(new QLabel(this), m_law);
  m_lawParameter = addNumber(QStringLiteral("tissueLawParameter"), 0.0, 50.0, 0.5, 1);
  m_gravity = addNumber(QStringLiteral("gravityZ"), -50.0, 50.0, 0.5, 2);
  m_fromTissue = new QCheckBox(this);
  m_fromTissue->setObjectName(QStringLiteral("parametersFromTissue"));
  m_form->addRow(m_fromTissue);

  connect(m_thickness, &GestureSpinBox::edited, this, [this](double value, int gesture) {
    edit(&TissueSettings::thickness, value / kMillimetresPerMetre, gesture);
  });
  connect(m_density, &GestureSpinBox::edited, this,
          [this](double value, int gesture) { edit(&TissueSettings::density, value, gesture); });
  connect(m_lawParameter, &GestureSpinBox::edited, this,
          [this](double value, int gesture) { edit(&TissueSettings::lawParameter, value, gesture); });
  connect(m_law, &QComboBox::currentIndexChanged, this, [this](int row) {
    if (m_refreshing || row < 0) return;
    TissueSettings settings = settingsOf(m_document->project().tissue);
    settings.law = static_cast<SpringLaw>(row); // the box lists the laws in the order of the enum
    m_document->setTissueSettings(settings);
  });
  connect(m_gravity, &GestureSpinBox::edited, this, [this](double value, int gesture) {
    Eigen::Vector3d gravity = m_document->project().loads.gravity;
    gravity.z() = value;
    m_document->setGravity(gravity, gesture);
  });
  connect(m_fromTissue, &QCheckBox::clicked, m_document, &Document::setParametersFromTissue);

  connect(document, &Document::projectReset, this, &TissuePanel::refresh);
  connect(document, &Document::netChanged, this, &TissuePanel::refresh);
  connect(document, &Document::tissueSettingsChanged, this, &TissuePanel::refresh);
  retranslateUi();
}

GestureSpinBox* TissuePanel::addNumber(const QString& name, double low, double high, double step,
                                       int decimals)
{
  auto* number = new GestureSpinBox(this);
  number->setObjectName(name);
  number->setRange(low, high);
  number->setSingleStep(step);
  number->setDecimals(decimals);
  m_form->addRow(new QLabel(this), number);
  return number;
}

void TissuePanel::edit(double TissueSettings::*number, double value, int gesture)
{
  TissueSettings settings = settingsOf(m_document->project().tissue);
  settings.*number = value;
  m_document->setTissueSettings(settings, gesture);
}

void TissuePanel::refresh()
{
  m_refreshing = true;
  const Project& project = m_document->project();
  m_thickness->display(project.tissue.thickness * kMillimetresPerMetre);
  offer(m_density, tr("Density"), tr("Density of the tissue in kg/m³"), true, &TissueParameters::density);
  m_law->setCurrentIndex(static_cast<int>(project.tissue.law));
  offer(m_lawParameter, tr("Stiffening"), tr("Parameter of the force law: how fast the tissue stiffens"),
        project.tissue.law != SpringLaw::Linear, &TissueParameters::stiffening);
  m_gravity->display(project.loads.gravity.z());
  m_fromTissue->setChecked(project.parametersFromTissue);
  m_refreshing = false;
}

/// A number that the rules give is shown as it is outside of all regions, and changed by words.
void TissuePanel::offer(GestureSpinBox* field, const QString& label, const QString& help, bool applies,
                        double TissueParameters::*value)
{
  const TissueModel& tissue = m_document->project().tissue;
  const bool given = comesFromRules(tissue.rules, value);
  if (const TissueField* compiled = m_document->tissueField())
    field->display(compiled->base().*value); // the model's own number if no rule gives it
  field->setEnabled(applies && !given);
  describe(field, label, given ? tr("The rules give this per place: change the words of the inputs") : help);
}

void TissuePanel::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::LanguageChange) retranslateUi();
  QWidget::changeEvent(event);
}

void TissuePanel::retranslateUi()
{
  m_refreshing = true;
  const auto row = [this](QWidget* field, const QString& label, const QString& help) {
    static_cast<QLabel*>(m_form->labelForField(field))->setText(label);
    describe(field, label, help);
  };
  row(m_thickness, tr("Wall thickness"), tr("Thickness of the organ's wall in mm"));
  row(m_density, tr("Density"), QString()); // refresh() says what it is
  row(m_law, tr("Force law"), tr("How the springs answer their extension"));
  row(m_lawParameter, tr("Stiffening"), QString());
  row(m_gravity, tr("Gravity along z"), tr("Acceleration along z in m/s²; -9.81 is the Earth's"));
  m_law->setItemText(0, tr("linear"));
  m_law->setItemText(1, tr("cubic"));
  m_law->setItemText(2, tr("exponential (tissue)"));
  m_fromTissue->setText(tr("Springs follow the tissue"));
  describe(m_fromTissue, m_fromTissue->text(),
           tr("Off: the springs keep the parameters that the net came with"));
  m_thickness->setSuffix(QStringLiteral(" mm"));
  m_density->setSuffix(QStringLiteral(" kg/m³"));
  m_gravity->setSuffix(QStringLiteral(" m/s²"));
  for (GestureSpinBox* number : {m_thickness, m_density, m_lawParameter, m_gravity})
    number->setLocale(QLocale());
  m_refreshing = false;
  refresh();
}

} // namespace esm
