// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/emulator_panel.h"

#include "haptics/emulator/emulated_falcon.h"

#include <QCheckBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

namespace esm {

EmulatorPanel::EmulatorPanel(DeviceDesk* desk, QWidget* parent) : QWidget(parent), m_desk(desk)
{
  const auto box = [this](const char* name, bool on) {
    auto* made = new QCheckBox(this);
    made->setObjectName(QLatin1String(name));
    made->setChecked(on);
    return made;
  };
  m_what = new QLabel(this);
  m_what->setObjectName(QStringLiteral("emulatorWhat"));
  m_what->setWordWrap(true);
  m_plugged = box("emulatorPlugged", true);
  m_permitted = box("emulatorPermitted", true);
  m_mute = box("emulatorMute", false);
  m_outAndIn = new QPushButton(this);
  m_outAndIn->setObjectName(QStringLiteral("emulatorOutAndIn"));
  m_outAndIn->setAutoDefault(false);
  auto* grid = new QGridLayout(this);
  grid->addWidget(m_what, 0, 0, 1, 3);
  grid->addWidget(m_plugged, 1, 0);
  grid->addWidget(m_permitted, 1, 1);
  grid->addWidget(m_mute, 1, 2);
  grid->addWidget(m_outAndIn, 2, 0, 1, 3, Qt::AlignLeft);
  grid->setRowStretch(3, 1);
  connect(m_plugged, &QCheckBox::toggled, this, [this](bool on) { m_desk->emulated()->setPlugged(on); });
  connect(m_permitted, &QCheckBox::toggled, this, [this](bool on) {
    m_desk->emulated()->setPermitted(on);
    m_desk->rescan(); // rights change without a sound
  });
  connect(m_mute, &QCheckBox::toggled, this, [this](bool on) { m_desk->emulated()->setMute(on); });
  connect(m_outAndIn, &QPushButton::clicked, this, [this] { m_desk->emulated()->pullOutAndIn(); });
  retranslateUi();
}

void EmulatorPanel::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::LanguageChange) retranslateUi();
  QWidget::changeEvent(event);
}

void EmulatorPanel::retranslateUi()
{
  m_what->setText(
    tr("The Falcon of this list is emulated: driver and force loop are real, the device is not. "
       "Any file will do as its firmware; with the tool Pull the mouse leads its grip."));
  m_plugged->setText(tr("Plugged in"));
  m_permitted->setText(tr("Permitted"));
  m_mute->setText(tr("Loose contact"));
  m_outAndIn->setText(tr("Pull the grip out and push it in"));
  for (QAbstractButton* each :
       {static_cast<QAbstractButton*>(m_plugged), static_cast<QAbstractButton*>(m_permitted),
        static_cast<QAbstractButton*>(m_mute), static_cast<QAbstractButton*>(m_outAndIn)})
    each->setAccessibleName(each->text());
}

} // namespace esm
