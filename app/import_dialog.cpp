// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/import_dialog.h"

#include "app/error_text.h"
#include "app/theme.h"
#include "core/net/net_builder.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <cmath>

namespace esm {

namespace {

void name(QWidget* widget, const char* object, const QString& text)
{
  widget->setObjectName(QLatin1String(object));
  widget->setAccessibleName(text);
}

} // namespace

LengthUnit guessedUnit(double largestExtent)
{
  return largestExtent > 2.0 ? LengthUnit::Millimetre : LengthUnit::Metre;
}

ImportDialog::ImportDialog(const QString& path, JobRunner* jobs, bool modelIsEmpty, QWidget* parent)
  : QDialog(parent), m_path(path), m_jobs(jobs)
{
  setObjectName(QStringLiteral("dlgImport"));
  setWindowTitle(tr("Import %1").arg(QFileInfo(path).fileName()));
  resize(720, 620);
  buildWidgets(modelIsEmpty);
  readFile();
}

ImportDialog::~ImportDialog()
{
  m_jobs->cancel();
}

void ImportDialog::buildWidgets(bool modelIsEmpty)
{
  m_report = new QTableWidget(0, 2, this);
  name(m_report, "importReport", tr("Report on the mesh"));
  m_report->setHorizontalHeaderLabels({tr("In the file"), tr("Count")});
  m_report->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  m_report->verticalHeader()->hide();
  m_report->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  m_report->setEditTriggers(QAbstractItemView::NoEditTriggers);
  m_report->setSelectionMode(QAbstractItemView::NoSelection);
  m_notes = new QListWidget(this);
  name(m_notes, "importNotes", tr("Notes of the importer"));
  m_notes->setWordWrap(true);
  m_notes->setMaximumHeight(110);

  m_unit = new QComboBox(this);
  name(m_unit, "importUnit", tr("Unit of the file"));
  for (const LengthUnit unit :
       {LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Metre, LengthUnit::Inch})
    m_unit->addItem(QString::fromStdString(lengthUnitName(unit)), static_cast<int>(unit));
  m_up = new QComboBox(this);
  name(m_up, "importUp", tr("Axis of the file that points up"));
  m_up->addItem(QStringLiteral("z"), static_cast<int>(UpAxis::Z));
  m_up->addItem(QStringLiteral("y"), static_cast<int>(UpAxis::Y));
  m_weld = new QCheckBox(tr("Join vertices at the same place"), this);
  name(m_weld, "importWeld", m_weld->text());
  m_weld->setChecked(true);
  m_tolerance = new QDoubleSpinBox(this);
  name(m_tolerance, "importTolerance", tr("Weld tolerance in the unit of the file"));
  m_tolerance->setDecimals(6);
  m_tolerance->setRange(0.0, 1e6);
  m_tolerance->setSingleStep(0.001);
  m_tolerance->setKeyboardTracking(false);
  m_tolerance->setSpecialValueText(tr("equal positions only"));
  m_size = new QLabel(this);
  name(m_size, "importSize", tr("Size of the model"));
  m_prediction = new QLabel(this);
  name(m_prediction, "importPrediction", tr("Net that will come of it"));
  m_replace = new QRadioButton(tr("Replace the model"), this);
  name(m_replace, "importReplace", m_replace->text());
  m_replace->setToolTip(tr("Rules, inputs and regions stay; loads on single nodes go with the old model"));
  m_add = new QRadioButton(tr("Add to the model"), this);
  name(m_add, "importAdd", m_add->text());
  m_replace->setChecked(true);
  m_add->setEnabled(!modelIsEmpty);
  m_message = new QLabel(this);
  name(m_message, "importMessage", tr("Message"));
  m_message->setWordWrap(true);
  m_message->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_message->hide();
  m_progress = new QProgressBar(this);
  name(m_progress, "importProgress", tr("Reading the file"));
  m_progress->setRange(0, 0);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  m_ok = buttons->button(QDialogButtonBox::Ok);
  m_ok->setText(tr("Import"));
  name(m_ok, "importOk", m_ok->text());
  name(buttons->button(QDialogButtonBox::Cancel), "importCancel", tr("Cancel"));

  auto* form = new QFormLayout;
  form->addRow(tr("Unit"), m_unit);
  form->addRow(tr("Up axis"), m_up);
  form->addRow(m_weld);
  form->addRow(tr("Weld tolerance"), m_tolerance);
  form->addRow(tr("Size"), m_size);
  form->addRow(tr("Net"), m_prediction);
  auto* use = new QGroupBox(tr("Use"), this);
  auto* useLayout = new QVBoxLayout(use);
  useLayout->addWidget(m_replace);
  useLayout->addWidget(m_add);
  auto* right = new QVBoxLayout;
  right->addLayout(form);
  right->addWidget(use);
  right->addStretch();
  auto* columns = new QHBoxLayout;
  columns->addWidget(m_report, 1);
  columns->addLayout(right, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(columns, 1);
  layout->addWidget(m_notes);
  layout->addWidget(m_message);
  layout->addWidget(m_progress);
  layout->addWidget(buttons);

  connect(buttons, &QDialogButtonBox::accepted, this, &ImportDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &ImportDialog::reject);
  connect(m_unit, &QComboBox::currentIndexChanged, this, &ImportDialog::refreshSize);
  connect(m_up, &QComboBox::currentIndexChanged, this, &ImportDialog::refreshSize);
  connect(m_weld, &QCheckBox::toggled, this, [this](bool on) {
    m_tolerance->setEnabled(on);
    readFile();
  });
  connect(m_tolerance, &QDoubleSpinBox::valueChanged, this, &ImportDialog::readFile);
}

void ImportDialog::readFile()
{
  setReady(false);
  m_message->hide();
  ImportOptions options;
  options.weld = m_weld->isChecked();
  options.weldTolerance = m_tolerance->value();
  m_jobs->start([path = std::filesystem::path(m_path.toStdString()),
                 options](WorkControl* control) { return importMesh(path, options, control); },
                [this](Result<ImportedMesh> mesh) {
                  if (!mesh) return showFailure(mesh.error());
                  const bool first = !m_mesh.has_value();
                  m_mesh = std::move(mesh).value();
                  const Eigen::Vector3d extent = m_mesh->report.boxMax - m_mesh->report.boxMin;
                  if (first)
                    m_unit->setCurrentIndex(
                      m_unit->findData(static_cast<int>(guessedUnit(extent.maxCoeff()))));
                  showReport();
                  setReady(true);
                });
}

void ImportDialog::addLine(const QString& what, const QString& value, bool bad)
{
  const int row = m_report->rowCount();
  m_report->insertRow(row);
  auto* label = new QTableWidgetItem(bad ? QStringLiteral("⚠ ") + what : what);
  auto* number = new QTableWidgetItem(value);
  number->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  if (bad)
    for (QTableWidgetItem* item : {label, number}) item->setForeground(signalColours(palette()).warning);
  m_report->setItem(row, 0, label);
  m_report->setItem(row, 1, number);
}

void ImportDialog::showReport()
{
  const MeshReport& report = m_mesh->report;
  m_report->setRowCount(0);
  const auto defect = [this](const QString& what, Index count) {
    addLine(what, QString::number(count), count > 0);
  };
  addLine(tr("Format"), QString::fromStdString(m_mesh->format));
  addLine(tr("Vertices"), QString::number(report.nodes));
  addLine(tr("Triangles"), QString::number(report.triangles));
  addLine(tr("Line segments"), QString::number(report.segments));
  addLine(tr("Connected parts"), QString::number(report.components), report.components > 1);
  addLine(tr("Boundary edges"), QString::number(report.boundaryEdges));
  defect(tr("Non-manifold edges"), report.nonManifoldEdges);
  defect(tr("Degenerate triangles"), report.degenerateFaces);
  defect(tr("Duplicate triangles"), report.duplicateFaces);
  defect(tr("Isolated vertices"), report.isolatedVertices);
  defect(tr("Vertices without a place (NaN)"), report.nonFiniteVertices);
  m_notes->clear();
  for (const std::string& note : m_mesh->notes) m_notes->addItem(QString::fromStdString(note));
  m_notes->setVisible(m_notes->count() > 0);
  m_prediction->setText(
    tr("%1 nodes, %2 springs").arg(report.nodes - report.isolatedVertices).arg(report.springs));
  refreshSize();
}

void ImportDialog::showFailure(const Error& error)
{
  setReady(false);
  m_progress->hide();
  m_message->setText(errorText(error));
  m_message->show();
}

void ImportDialog::refreshSize()
{
  if (!m_mesh) return;
  Eigen::Vector3d extent = (m_mesh->report.boxMax - m_mesh->report.boxMin) * metresPer(unit()) * 1000.0;
  if (upAxis() == UpAxis::Y) std::swap(extent.y(), extent.z());
  const QLocale locale;
  const auto text = [&](double length) { return locale.toString(length, 'g', 4); };
  QString size = tr("%1 × %2 × %3 mm").arg(text(extent.x()), text(extent.y()), text(extent.z()));
  if (extent.maxCoeff() < 3.0 || extent.maxCoeff() > 2000.0)
    size += QStringLiteral("\n⚠ ") + tr("Not the size of an organ: is the unit right?");
  m_size->setText(size);
}

void ImportDialog::setReady(bool ready)
{
  m_ok->setEnabled(ready);
  m_progress->setVisible(!ready);
}

LengthUnit ImportDialog::unit() const
{
  return static_cast<LengthUnit>(m_unit->currentData().toInt());
}
UpAxis ImportDialog::upAxis() const
{
  return static_cast<UpAxis>(m_up->currentData().toInt());
}
bool ImportDialog::replaces() const
{
  return m_replace->isChecked();
}

void ImportDialog::accept()
{
  if (!m_mesh || m_jobs->busy()) return;
  setReady(false);
  m_jobs->start(
    [mesh = m_mesh->mesh, unit = unit(), up = upAxis()](WorkControl* control) mutable {
      toScene(mesh, unit, up);
      return buildNet(mesh, nullptr, control);
    },
    [this](Result<SpringNet> net) {
      if (!net) return showFailure(net.error());
      m_net = std::move(net).value();
      QDialog::accept();
    });
}

IncomingModel ImportDialog::takeModel()
{
  IncomingModel model;
  const QFileInfo file(m_path);
  model.name = file.completeBaseName();
  model.source.files = {{file.absoluteFilePath().toStdString(), m_mesh->fingerprint}};
  model.source.unit = unit();
  model.source.up = upAxis();
  model.source.weldTolerance = m_weld->isChecked() ? m_tolerance->value() : -1.0;
  model.net = std::move(m_net).value();
  m_net.reset();
  return model;
}

} // namespace esm
