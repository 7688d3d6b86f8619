// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dialogs/real_time_dialog.h"

#include "fuzzyeditor/decimal_spin_box.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double kLeastPercent = 0.01, kMostPercent = 50.0;

void name(QWidget* widget, const char* object, const QString& accessible)
{
  widget->setObjectName(QLatin1String(object));
  widget->setAccessibleName(accessible);
}

double savedTolerance(const char* key, double otherwise)
{
  bool isNumber = false;
  const double value = QSettings().value(QLatin1String(key)).toDouble(&isNumber);
  return isNumber && value >= 0.01 * kLeastPercent && value <= 0.01 * kMostPercent ? value : otherwise;
}

} // namespace

QualityPlan savedQualityPlan()
{
  QualityPlan plan;
  const std::string order = QSettings().value(QStringLiteral("realTime/order")).toString().toStdString();
  if (auto read = parseQualityOrder(order); read && read->size() == plan.order.size())
    plan.order = std::move(*read);
  plan.finest = savedTolerance("realTime/finest", plan.finest);
  plan.coarsest = std::max(savedTolerance("realTime/coarsest", plan.coarsest), plan.finest);
  return plan;
}

void saveQualityPlan(const QualityPlan& plan)
{
  QSettings settings;
  settings.setValue(QStringLiteral("realTime/order"), QString::fromStdString(formatQualityOrder(plan.order)));
  settings.setValue(QStringLiteral("realTime/finest"), plan.finest);
  settings.setValue(QStringLiteral("realTime/coarsest"), plan.coarsest);
}

RealTimeDialog::RealTimeDialog(const QualityPlan& plan, QWidget* parent)
  : QDialog(parent),
    m_order(new QListWidget(this)),
    m_up(new QPushButton(tr("Up"), this)),
    m_down(new QPushButton(tr("Down"), this)),
    m_finest(new DecimalSpinBox(this)),
    m_coarsest(new DecimalSpinBox(this))
{
  setObjectName(QStringLiteral("dlgRealTime"));
  setWindowTitle(tr("Real time"));
  name(m_order, "realTimeOrder", tr("What gives way, the first one first"));
  name(m_up, "realTimeUp", tr("Let it give way earlier"));
  name(m_down, "realTimeDown", tr("Let it give way later"));
  name(m_finest, "realTimeFinest", tr("Wanted error"));
  name(m_coarsest, "realTimeCoarsest", tr("Largest allowed error"));
  for (QDoubleSpinBox* box : {m_finest, m_coarsest}) {
    box->setRange(kLeastPercent, kMostPercent);
    box->setDecimals(2);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setSuffix(tr(" %"));
    box->setToolTip(tr("Error of the positions, as a part of the motion"));
  }

  auto* text =
    new QLabel(tr("A model that is too heavy for this computer first gives up accuracy, then runs "
                  "in slow motion. Choose the order; what stands below slow motion never gives way."),
               this);
  text->setWordWrap(true);
  auto* arrows = new QVBoxLayout;
  arrows->addWidget(m_up);
  arrows->addWidget(m_down);
  arrows->addStretch(1);
  auto* order = new QHBoxLayout;
  order->addWidget(m_order, 1);
  order->addLayout(arrows);
  auto* form = new QFormLayout;
  form->addRow(tr("Wanted error"), m_finest);
  form->addRow(tr("Largest allowed error"), m_coarsest);
  auto* buttons = new QDialogButtonBox(
    QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::RestoreDefaults, this);
  const std::pair<QDialogButtonBox::StandardButton, const char*> names[] = {
    {QDialogButtonBox::Ok, "realTimeOk"},
    {QDialogButtonBox::Cancel, "realTimeCancel"},
    {QDialogButtonBox::RestoreDefaults, "realTimeDefaults"}};
  const QString texts[] = {tr("OK"), tr("Cancel"), tr("Defaults")};
  for (int i = 0; i < 3; ++i) {
    QPushButton* button = buttons->button(names[i].first);
    button->setText(texts[i]);
    name(button, names[i].second, texts[i]);
  }
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(text);
  layout->addLayout(order);
  layout->addLayout(form);
  layout->addWidget(buttons);

  connect(m_up, &QPushButton::clicked, this, [this] { move(-1); });
  connect(m_down, &QPushButton::clicked, this, [this] { move(1); });
  connect(m_order, &QListWidget::currentRowChanged, this, &RealTimeDialog::refresh);
  connect(m_finest, &QDoubleSpinBox::valueChanged, m_coarsest, &QDoubleSpinBox::setMinimum);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this,
          [this] { show(QualityPlan()); });
  show(plan);
}

void RealTimeDialog::show(const QualityPlan& plan)
{
  m_order->clear();
  for (const QualityMeasure measure : plan.order) {
    auto* item = new QListWidgetItem(m_order);
    item->setData(Qt::UserRole, static_cast<int>(measure));
  }
  m_coarsest->setMinimum(kLeastPercent);
  m_finest->setValue(100.0 * plan.finest);
  m_coarsest->setValue(100.0 * plan.coarsest);
  m_order->setCurrentRow(0);
  refresh();
}

void RealTimeDialog::move(int by)
{
  const int row = m_order->currentRow();
  if (row < 0 || row + by < 0 || row + by >= m_order->count()) return;
  m_order->insertItem(row + by, m_order->takeItem(row));
  m_order->setCurrentRow(row + by);
  refresh();
}

void RealTimeDialog::refresh()
{
  bool counts = true;
  for (int row = 0; row < m_order->count(); ++row) {
    QListWidgetItem* item = m_order->item(row);
    const auto measure = static_cast<QualityMeasure>(item->data(Qt::UserRole).toInt());
    const QString texts[] = {tr("Larger error, up to the allowed one"),
                             tr("Rougher solver steps, implicit sooner"), tr("Slow motion")};
    const QString text = texts[static_cast<int>(measure)];
    item->setText(counts ? tr("%1. %2").arg(row + 1).arg(text) : tr("never: %1").arg(text));
    counts = counts && measure != QualityMeasure::SlowMotion;
  }
  m_up->setEnabled(m_order->currentRow() > 0);
  m_down->setEnabled(m_order->currentRow() >= 0 && m_order->currentRow() + 1 < m_order->count());
}

QualityPlan RealTimeDialog::plan() const
{
  QualityPlan plan;
  plan.order.clear();
  for (int row = 0; row < m_order->count(); ++row)
    plan.order.push_back(static_cast<QualityMeasure>(m_order->item(row)->data(Qt::UserRole).toInt()));
  plan.finest = 0.01 * m_finest->value();
  plan.coarsest = 0.01 * m_coarsest->value();
  return plan;
}

} // namespace esm
