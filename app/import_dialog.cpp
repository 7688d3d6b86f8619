// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/import_dialog.h"

#include "app/error_text.h"
#include "app/import/defect_list.h"
#include "app/import/format_memory.h"
#include "app/import/note_text.h"
#include "app/import/recipe_form.h"
#include "app/import/unit_question.h"
#include "app/screen_room.h"
#include "app/theme.h"
#include "app/viewport/scene_view.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QEvent>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QScreen>
#include <QScrollArea>
#include <QSplitter>
#include <QStyle>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace esm {

namespace {

template <class Widget>
Widget* named(Widget* widget, const char* name)
{
  widget->setObjectName(QLatin1String(name));
  return widget;
}

QLabel* wrappedLabel(QWidget* parent, const char* name)
{
  auto* label = named(new QLabel(parent), name);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

bool sameTissue(const TissueModel& a, const TissueModel& b)
{
  return a.rules == b.rules && a.inputs == b.inputs && a.regions == b.regions &&
         settingsOf(a) == settingsOf(b);
}

} // namespace

LengthUnit guessedUnit(double largestExtent)
{
  return largestExtent > 2.0 ? LengthUnit::Millimetre : LengthUnit::Metre;
}

ImportDialog::ImportDialog(const QStringList& paths, JobRunner* jobs, bool modelIsEmpty, TissueModel tissue,
                           QWidget* parent)
  : QDialog(parent), m_paths(paths), m_jobs(jobs), m_tissue(std::move(tissue))
{
  setObjectName(QStringLiteral("dlgImport"));
  resize(QSize(1280, 800).boundedTo(sizeWithoutFrame(screen()->availableSize())));
  buildWidgets(modelIsEmpty);
  m_settle.setSingleShot(true);
  m_settle.setInterval(150); // [ms]
  connect(&m_settle, &QTimer::timeout, this, &ImportDialog::makeNet);
  m_progressTimer.setInterval(50); // [ms]
  connect(&m_progressTimer, &QTimer::timeout, this, [this] {
    const double done = m_jobs->done();
    m_progress->setRange(0, done > 0.0 ? 100 : 0); // a worker process does not tell how far it is
    m_progress->setValue(static_cast<int>(100.0 * done));
  });
  connect(m_form, &RecipeForm::readingChanged, this, &ImportDialog::readFiles);
  connect(m_form, &RecipeForm::changed, this, [this] {
    showSize();
    askForNet();
  });
  const auto otherTissue = [this] {
    if (!sameTissue(wantedTissue(), m_askedTissue)) askForNet();
  };
  connect(m_replace, &QRadioButton::toggled, this, otherTissue);
  connect(m_keeps, &QComboBox::currentIndexChanged, this, otherTissue);
  connect(m_defects, &DefectList::chosen, this, [this](const Eigen::Matrix3Xd& places) {
    m_view->setMarks(places);
    if (places.cols() == 0 || !m_preview) return;
    const MeshReport& report = m_preview->made.before;
    m_view->flyTo(places, 0.15 * (report.boxMax - report.boxMin).norm());
  });
  if (const auto remembered = rememberedRecipe(format())) {
    m_remembered = true;
    m_form->setRecipe(*remembered);
  }
  retranslate();
  readFiles();
}

ImportDialog::~ImportDialog()
{
  m_jobs->cancel();
}

// === Widgets

/// The choices scroll; what becomes of the present model can always be seen.
QWidget* ImportDialog::buildLeft(bool modelIsEmpty)
{
  m_form = named(new RecipeForm(this), "importForm");
  m_left = named(new QScrollArea(this), "importScroll");
  m_left->setWidget(m_form);
  m_left->setWidgetResizable(true);
  m_left->setFrameShape(QFrame::NoFrame);
  m_left->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* left = new QWidget(this);
  m_replace = named(new QRadioButton(left), "importReplace");
  m_add = named(new QRadioButton(left), "importAdd");
  m_replace->setChecked(true);
  m_keepsText = named(new QLabel(left), "importKeepsText");
  m_keeps = named(new QComboBox(left), "importKeeps");
  for (int row = 0; row < 3; ++row) m_keeps->addItem(QString());
  for (QWidget* widget : {static_cast<QWidget*>(m_keepsText), static_cast<QWidget*>(m_keeps)}) {
    widget->setVisible(!modelIsEmpty);
    connect(m_replace, &QRadioButton::toggled, widget, &QWidget::setEnabled);
  }
  m_add->setEnabled(!modelIsEmpty);
  auto* kept = new QHBoxLayout;
  kept->setContentsMargins(22, 0, 0, 0); // below the button's text
  kept->addWidget(m_keepsText);
  kept->addWidget(m_keeps, 1);
  auto* layout = new QVBoxLayout(left);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_left, 1);
  layout->addWidget(m_replace);
  layout->addLayout(kept);
  layout->addWidget(m_add);
  return left;
}

QWidget* ImportDialog::buildRight()
{
  auto* right = new QWidget(this);
  auto* layout = new QVBoxLayout(right);
  layout->setContentsMargins(0, 0, 0, 0);
  m_report = named(new QTableWidget(0, 3, right), "importReport");
  m_report->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  m_report->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  m_report->verticalHeader()->hide();
  m_report->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  m_report->setEditTriggers(QAbstractItemView::NoEditTriggers);
  m_report->setSelectionMode(QAbstractItemView::NoSelection);
  m_report->setFocusPolicy(Qt::NoFocus);
  m_defects = new DefectList(right);
  m_notes = named(new QListWidget(right), "importNotes");
  m_notes->setWordWrap(true);
  m_notes->setMaximumHeight(120);
  layout->addWidget(m_report, 3);
  layout->addWidget(m_defects, 3);
  layout->addWidget(m_notes, 1);
  return right;
}

void ImportDialog::buildWidgets(bool modelIsEmpty)
{
  m_view = new SceneView(this);
  named(m_view, "importView")->setColouring(Colouring::None);
  auto* columns = new QSplitter(Qt::Horizontal, this);
  columns->addWidget(buildLeft(modelIsEmpty));
  columns->addWidget(m_view);
  columns->addWidget(buildRight());
  columns->setChildrenCollapsible(false);
  columns->setStretchFactor(1, 1);
  columns->setSizes({350, 560, 340});

  m_size = wrappedLabel(this, "importSize");
  m_prediction = wrappedLabel(this, "importPrediction");
  m_message = wrappedLabel(this, "importMessage");
  m_message->hide();
  m_rememberedNote = wrappedLabel(this, "importRemembered");
  m_reset = named(new QPushButton(this), "importReset");
  m_progress = named(new QProgressBar(this), "importProgress");
  m_progress->setMaximumWidth(180);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  m_ok = named(buttons->button(QDialogButtonBox::Ok), "importOk");
  m_cancel = named(buttons->button(QDialogButtonBox::Cancel), "importCancel");
  connect(buttons, &QDialogButtonBox::accepted, this, &ImportDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &ImportDialog::reject);
  connect(m_reset, &QPushButton::clicked, this, &ImportDialog::resetRemembered);

  auto* memory = new QHBoxLayout;
  memory->addWidget(m_rememberedNote, 1);
  memory->addWidget(m_reset);
  auto* bottom = new QHBoxLayout;
  bottom->addLayout(memory, 1);
  bottom->addWidget(m_progress);
  bottom->addWidget(buttons);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(columns, 1);
  layout->addWidget(m_size);
  layout->addWidget(m_prediction);
  layout->addWidget(m_message);
  layout->addLayout(bottom);
}

// === Work

ImportRecipe ImportDialog::recipe() const
{
  ImportRecipe recipe = m_form->recipe();
  recipe.files.clear();
  for (const QString& path : m_paths)
    recipe.files.push_back({QFileInfo(path).absoluteFilePath().toStdString()});
  return recipe;
}

QString ImportDialog::format() const
{
  return formatOf(m_paths.front());
}

void ImportDialog::readFiles()
{
  m_settle.stop();
  setBusy(true);
  m_jobs->start([recipe = recipe()](WorkControl* control) { return readMeshes(recipe, {}, control); },
                [this](Result<MeshSource> source) {
                  if (!source) return showFailure(source.error());
                  takeSource(std::move(source).value());
                });
}

void ImportDialog::takeSource(MeshSource source)
{
  if (!m_source && m_remembered) { // but for the unit: a wrong one would go unseen
    ImportRecipe remembered = m_form->recipe();
    remembered.unit = guessedUnit((source.report.boxMax - source.report.boxMin).maxCoeff());
    m_form->setRecipe(remembered);
  }
  if (!m_source && !m_remembered) {
    ImportRecipe guessed = m_form->recipe();
    if (!source.stated.metres)
      guessed.unit = guessedUnit((source.report.boxMax - source.report.boxMin).maxCoeff());
    m_form->setRecipe(guessed);
  }
  m_source = std::make_shared<const MeshSource>(std::move(source));
  m_form->setStated(m_source->isInScene ? StatedFrame{} : m_source->stated);
  showSize();
  makeNet();
}

/// Of other choices: soon, since more of them may follow.
void ImportDialog::askForNet()
{
  setBusy(true);
  m_settle.start();
}

/// A model that is added to gets its tissue as it is; so does a new one, which has nothing before it.
TissueModel ImportDialog::wantedTissue() const
{
  TissueModel tissue = m_tissue;
  if (!m_replace->isChecked() || m_keeps->isHidden()) return tissue;
  const auto keeps = static_cast<Keeps>(m_keeps->currentIndex());
  if (keeps == Keeps::Nothing) return defaultTissue();
  if (keeps == Keeps::BaseTissue) tissue.regions.clear();
  return tissue;
}

void ImportDialog::makeNet()
{
  if (!m_source) return; // it comes when the files are read
  if (!m_source->serves(recipe())) return readFiles();
  setBusy(true);
  m_askedTissue = wantedTissue();
  m_jobs->start([source = m_source, recipe = recipe(), tissue = m_askedTissue](
                  WorkControl* control) { return makePreview(*source, recipe, tissue, control); },
                [this](Result<ImportPreview> preview) {
                  if (!preview) return showFailure(preview.error());
                  showPreview(std::move(preview).value());
                });
}

/// Without a net of the present choices there is nothing to take.
void ImportDialog::setBusy(bool busy)
{
  if (busy) {
    m_preview.reset();
    m_message->hide();
    m_progressTimer.start();
  } else {
    m_progressTimer.stop();
  }
  m_progress->setVisible(busy);
  m_ok->setEnabled(m_preview.has_value());
}

void ImportDialog::showFailure(const Error& error)
{
  setBusy(false);
  m_prediction->clear();
  m_message->setText(errorText(error));
  m_message->show();
}

// === What is shown

void ImportDialog::showPreview(ImportPreview preview)
{
  m_view->setMarks(Eigen::Matrix3Xd(3, 0));
  m_view->setNet(std::make_shared<const SpringNet>(preview.made.net), ++m_generation);
  m_preview = std::move(preview);
  setBusy(false);
  m_defects->setDefects(m_preview->defects);
  showReport();
  showSize();
}

void ImportDialog::addRow(const QString& what, const QString& before, const QString& after, bool bad)
{
  const int row = m_report->rowCount();
  m_report->insertRow(row);
  const QString texts[] = {bad ? QStringLiteral("⚠ ") + what : what, before, after};
  for (int column = 0; column < 3; ++column) {
    auto* item = new QTableWidgetItem(texts[column]);
    if (column > 0) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    if (bad) item->setForeground(signalColours(palette()).warning);
    m_report->setItem(row, column, item);
  }
}

/// A finding as it is said in the window's language.
QString ImportDialog::textOf(const QualityFinding& finding, const QualityReport& report)
{
  const QLocale locale;
  const QString dent = locale.toString(finding.value * 1000.0, 'g', 2);
  const QString poke = locale.toString(report.poke, 'g', 2);
  const auto count = static_cast<int>(std::min<std::int64_t>(finding.count, 1'000'000'000));
  const auto places = static_cast<int>(finding.nodes.size());
  switch (finding.kind) {
  case QualityFinding::Kind::Carries:
    return tr("The net carries load: a poke of %1 N dents it by %2 mm.").arg(poke, dent);
  case QualityFinding::Kind::Soft:
    return tr("The net is soft: a poke of %1 N dents it by %2 mm.").arg(poke, dent);
  case QualityFinding::Kind::Collapses:
    return tr("The net collapses: a poke of %1 N moves it by more than its size.").arg(poke);
  case QualityFinding::Kind::NothingInside:
    return tr("Nothing is inside the surface: it gives way like a bag. Choose a support.");
  case QualityFinding::Kind::Mechanisms:
    return tr("%n motion(s) of the net that no spring resists", nullptr, count);
  case QualityFinding::Kind::FlatNodes:
    return tr("%n node(s) that nothing holds across the plane of their springs", nullptr, places);
  case QualityFinding::Kind::HingeNode:
    return tr("%n node(s) at which parts hang together alone", nullptr, places);
  case QualityFinding::Kind::HingeLine:
    return tr("%n node(s) of lines along which parts hang together alone", nullptr, places);
  case QualityFinding::Kind::Unheld:
    return tr("%n part(s) that neither bands nor held nodes hold", nullptr, count);
  case QualityFinding::Kind::TooLarge:
    return tr("The net is too large to be judged before it runs.");
  }
  return {};
}

void ImportDialog::showReport()
{
  if (!m_preview) return;
  const MeshReport &before = m_preview->made.before, &after = m_preview->made.after;
  m_report->setRowCount(0);
  const auto count = [this](const QString& what, Index was, Index is, bool isDefect) {
    addRow(what, QString::number(was), QString::number(is), isDefect && is > 0);
  };
  addRow(tr("Format"), QString::fromStdString(m_preview->made.files.front().format), QString(), false);
  count(tr("Vertices"), before.nodes, after.nodes, false);
  count(tr("Triangles"), before.triangles, after.triangles, false);
  count(tr("Line segments"), before.segments, after.segments, false);
  count(tr("Connected parts"), before.components, after.components, false);
  count(tr("Boundary edges"), before.boundaryEdges, after.boundaryEdges, false);
  count(tr("Non-manifold edges"), before.nonManifoldEdges, after.nonManifoldEdges, true);
  count(tr("Degenerate triangles"), before.degenerateFaces, after.degenerateFaces, true);
  count(tr("Duplicate triangles"), before.duplicateFaces, after.duplicateFaces, true);
  count(tr("Isolated vertices"), before.isolatedVertices, after.isolatedVertices, true);
  count(tr("Vertices without a place (NaN)"), before.nonFiniteVertices, after.nonFiniteVertices, true);
  m_notes->clear();
  for (const QualityFinding& finding : m_preview->quality.findings) {
    const bool bad = finding.severity == QualityFinding::Severity::Warning;
    const QString text = textOf(finding, m_preview->quality);
    m_notes->addItem(bad ? QStringLiteral("⚠ ") + text : text);
    if (bad) m_notes->item(m_notes->count() - 1)->setForeground(signalColours(palette()).warning);
  }
  for (const std::string& note : m_preview->made.notes) m_notes->addItem(importNoteText(note));
  m_notes->setVisible(m_notes->count() > 0);

  const QLocale locale;
  const NetPrediction& prediction = m_preview->prediction;
  QString text =
    tr("%1 nodes, %2 springs").arg(m_preview->made.net.nodeCount()).arg(m_preview->made.net.springCount());
  text +=
    tr("; about %1 MB of memory").arg(locale.toString(static_cast<double>(prediction.bytes) / 1e6, 'f', 1));
  if (prediction.step > 0.0)
    text += tr("; time step %1 ms, explicit steps then reach about %2 times real time on one core")
              .arg(locale.toString(prediction.step * 1000.0, 'g', 2),
                   locale.toString(prediction.realTime, prediction.realTime < 10.0 ? 'g' : 'f',
                                   prediction.realTime < 10.0 ? 2 : 0));
  m_prediction->setText(text);
}

void ImportDialog::showSize()
{
  if (!m_source) return;
  const Eigen::Vector3d extent =
    extentInScene(m_source->report.boxMin, m_source->report.boxMax, m_source->frame(m_form->recipe())) *
    1000.0;
  const QLocale locale;
  const auto text = [&](double length) { return locale.toString(length, 'g', 4); };
  QString size = tr("%1 × %2 × %3 mm").arg(text(extent.x()), text(extent.y()), text(extent.z()));
  m_extent = (m_source->report.boxMax - m_source->report.boxMin).maxCoeff();
  m_metres = extent.maxCoeff() / 1000.0;
  if (!isUsualSize(m_metres))
    size += QStringLiteral("   ⚠ ") + tr("Not the size of an organ: is the unit right?") + QLatin1Char(' ') +
            likelyText(m_extent);
  m_size->setText(size);
}

// === Memory of the choices

void ImportDialog::resetRemembered()
{
  forgetRecipe(format());
  m_remembered = false;
  m_source = nullptr; // so that the unit is guessed anew
  m_form->setRecipe({});
  retranslate();
  readFiles();
}

bool ImportDialog::replaces() const
{
  return m_replace->isChecked();
}

/// A model that is smaller or larger than any organ is taken only by a word of the user.
bool ImportDialog::unitIsMeant()
{
  if (isUsualSize(m_metres)) return true;
  const UnitAnswer answer = askAboutUnit(m_extent, m_metres, this);
  if (answer == UnitAnswer::UseLikely) {
    ImportRecipe likely = m_form->recipe();
    if (m_source->stated.metres && !likely.ignoreStated) { // the file's own unit was wrong, not its axes
      likely.ignoreStated = true;
      likely.up = m_source->stated.up.value_or(likely.up);
      likely.patientAxes = m_source->stated.patientAxes.value_or(likely.patientAxes);
    }
    likely.unit = likelyUnit(m_extent).value_or(likely.unit);
    m_form->setRecipe(likely);
    showSize();
    askForNet();
  }
  return answer == UnitAnswer::Keep;
}

void ImportDialog::accept()
{
  if (!m_preview || !unitIsMeant()) return;
  rememberRecipe(format(), m_form->recipe());
  QDialog::accept();
}

IncomingModel ImportDialog::takeModel()
{
  IncomingModel model;
  model.name = QFileInfo(m_paths.front()).completeBaseName();
  model.source = std::move(m_preview->made.recipe);
  model.net = std::move(m_preview->made.net);
  if (replaces() || model.source.material != MaterialOptions{}) model.tissue = std::move(m_preview->tissue);
  m_preview.reset();
  return model;
}

// === Texts

void ImportDialog::changeEvent(QEvent* event)
{
  QDialog::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

void ImportDialog::retranslate()
{
  setWindowTitle(m_paths.size() == 1
                   ? tr("Import %1").arg(QFileInfo(m_paths.front()).fileName())
                   : tr("Import %1 and %n more file(s)", nullptr, static_cast<int>(m_paths.size()) - 1)
                       .arg(QFileInfo(m_paths.front()).fileName()));
  m_report->setHorizontalHeaderLabels({tr("Count"), tr("File"), tr("Repaired")});
  m_report->setAccessibleName(tr("Report on the mesh"));
  m_notes->setAccessibleName(tr("Notes of the importer"));
  m_size->setAccessibleName(tr("Size of the model"));
  m_prediction->setAccessibleName(tr("Net that will come of it"));
  m_message->setAccessibleName(tr("Message"));
  m_progress->setAccessibleName(tr("Progress"));
  m_replace->setText(tr("Replace the model"));
  m_replace->setToolTip(tr("Gravity stays; loads on single nodes go with the former model"));
  m_keepsText->setText(tr("What stays of its tissue"));
  m_keeps->setItemText(0, tr("rules and base tissue"));
  m_keeps->setItemText(1, tr("rules, base tissue and regions"));
  m_keeps->setItemText(2, tr("nothing: the default tissue"));
  m_keeps->setToolTip(tr("Regions lie where the former organ was"));
  m_keeps->setAccessibleName(m_keepsText->text());
  m_add->setText(tr("Add to the model"));
  m_ok->setText(tr("Import"));
  m_cancel->setText(tr("Cancel"));
  m_reset->setText(tr("Reset"));
  m_rememberedNote->setText(m_remembered ? tr("Choices as for the last %1 file").arg(format()) : QString());
  m_reset->setToolTip(tr("Forget the choices for files of this kind"));
  m_reset->setVisible(m_remembered);
  for (QWidget* widget : std::initializer_list<QAbstractButton*>{m_replace, m_add, m_ok, m_cancel, m_reset})
    widget->setAccessibleName(static_cast<QAbstractButton*>(widget)->text());
  m_rememberedNote->setAccessibleName(tr("Remembered choices"));
  showReport();
  showSize();
  // As wide as its texts in this language.
  m_left->setMinimumWidth(m_left->widget()->sizeHint().width() +
                          style()->pixelMetric(QStyle::PM_ScrollBarExtent));
}

} // namespace esm
