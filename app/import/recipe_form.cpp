// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/import/recipe_form.h"

#include "fuzzyeditor/decimal_spin_box.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr LengthUnit kUnits[] = {LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Metre,
                                 LengthUnit::Inch};
/// What the box of axes offers, in its order.
struct Axes {
  UpAxis up;
  PatientAxes patient;
};
constexpr Axes kAxes[] = {{UpAxis::Z, PatientAxes::None},
                          {UpAxis::Y, PatientAxes::None},
                          {UpAxis::Z, PatientAxes::Lps},
                          {UpAxis::Z, PatientAxes::Ras}};

using Interior = SupportOptions::Interior;
/// What the box of interiors offers, in its order: what serves most organs first.
constexpr Interior kInteriors[] = {Interior::None, Interior::Wall,    Interior::Struts,
                                   Interior::Hub,  Interior::Lattice, Interior::Tetrahedra};

int placeOf(Interior interior)
{
  return static_cast<int>(std::find(std::begin(kInteriors), std::end(kInteriors), interior) -
                          std::begin(kInteriors));
}

/// For whom each is, and how far it is off finite elements (docs/BENCHMARKS.md).
const char* hintOf(Interior interior)
{
  switch (interior) {
  case Interior::Wall:
    return QT_TRANSLATE_NOOP(
      "esm::RecipeForm",
      "For hollow organs and tubes. On a tube under small loads 6 % off finite elements, in a pinch 30 %; "
      "deep pinches may snap.");
  case Interior::Struts:
    return QT_TRANSLATE_NOOP(
      "esm::RecipeForm", "For thin and open bodies. Expected error against finite elements: 35 %, in a pinch "
                         "more than 100 %.");
  case Interior::Hub:
    return QT_TRANSLATE_NOOP("esm::RecipeForm", "For fat organs, with the fewest springs.");
  case Interior::Lattice:
    return QT_TRANSLATE_NOOP("esm::RecipeForm", "For fat organs, alike everywhere.");
  case Interior::Tetrahedra:
    return QT_TRANSLATE_NOOP("esm::RecipeForm", "For closed, clean surfaces.");
  case Interior::None:
    break;
  }
  return QT_TRANSLATE_NOOP("esm::RecipeForm",
                           "The skin alone gives way like a bag. For hollow organs choose the wall.");
}

int placeOf(LengthUnit unit)
{
  return static_cast<int>(std::find(std::begin(kUnits), std::end(kUnits), unit) - std::begin(kUnits));
}

int placeOf(UpAxis up, PatientAxes patient)
{
  const auto* found = std::find_if(std::begin(kAxes), std::end(kAxes), [&](const Axes& axes) {
    return axes.patient == patient && (patient != PatientAxes::None || axes.up == up);
  });
  return static_cast<int>(found - std::begin(kAxes));
}

} // namespace

RecipeForm::RecipeForm(QWidget* parent) : QWidget(parent)
{
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  addFileGroup();
  addRepairGroup();
  addNetGroup();
  addSupportGroup();
  addMaterialGroup();
  layout->addStretch();
  retranslate();
  setRecipe({});
}

// === Building

QFormLayout* RecipeForm::addGroup(const char* title, const char* name)
{
  auto* group = new QGroupBox(this);
  group->setObjectName(QLatin1String(name));
  layout()->addWidget(group);
  m_lines.push_back({group, title});
  return new QFormLayout(group);
}

template <class Widget>
Widget* RecipeForm::add(QFormLayout* form, Widget* widget, const char* name, const char* text)
{
  widget->setObjectName(QLatin1String(name));
  if (qobject_cast<QCheckBox*>(widget))
    form->addRow(widget);
  else
    form->addRow(tr(text), widget);
  m_lines.push_back({widget, text});
  return widget;
}

QCheckBox* RecipeForm::addCheck(QFormLayout* form, const char* name, const char* text)
{
  auto* box = add(form, new QCheckBox(this), name, text);
  connect(box, &QCheckBox::toggled, this, &RecipeForm::told);
  return box;
}

QComboBox* RecipeForm::addCombo(QFormLayout* form, const char* name, const char* text,
                                std::vector<const char*> items)
{
  auto* box = add(form, new QComboBox(this), name, text);
  for (const char* item : items) box->addItem(QLatin1String(item));
  connect(box, &QComboBox::currentIndexChanged, this, &RecipeForm::told);
  m_combos.emplace_back(box, std::move(items));
  return box;
}

QSpinBox* RecipeForm::addCount(QFormLayout* form, const char* name, const char* text, int most,
                               const char* none)
{
  auto* box = add(form, new QSpinBox(this), name, text);
  box->setRange(0, most);
  box->setKeyboardTracking(false);
  box->setGroupSeparatorShown(false);
  connect(box, &QSpinBox::valueChanged, this, &RecipeForm::told);
  m_counts.emplace_back(box, none);
  return box;
}

QDoubleSpinBox* RecipeForm::addNumber(QFormLayout* form, const char* name, const char* text, double least,
                                      double most, int decimals)
{
  auto* box = add(form, new DecimalSpinBox(this), name, text);
  box->setDecimals(decimals);
  box->setRange(least, most);
  box->setKeyboardTracking(false);
  connect(box, &QDoubleSpinBox::valueChanged, this, &RecipeForm::told);
  return box;
}

void RecipeForm::addFileGroup()
{
  QFormLayout* form = addGroup(QT_TR_NOOP("File"), "importFileGroup");
  m_unit = addCombo(form, "importUnit", QT_TR_NOOP("Unit"), {"mm", "cm", "m", QT_TR_NOOP("inch")});
  m_axes = addCombo(form, "importUp", QT_TR_NOOP("Axes"),
                    {QT_TR_NOOP("z up"), QT_TR_NOOP("y up"), QT_TR_NOOP("patient, LPS (DICOM)"),
                     QT_TR_NOOP("patient, RAS (NIfTI)")});
  m_useStated = addCheck(form, "importUseStated", QT_TR_NOOP("As the file itself states"));
  m_weld = add(form, new QCheckBox(this), "importWeld", QT_TR_NOOP("Join vertices at the same place"));
  m_tolerance =
    add(form, new DecimalSpinBox(this), "importTolerance", QT_TR_NOOP("Weld tolerance (unit of the file)"));
  m_tolerance->setDecimals(6);
  m_tolerance->setRange(0.0, 1e6);
  m_tolerance->setSingleStep(0.001);
  m_tolerance->setKeyboardTracking(false);
  const auto reread = [this] {
    refreshEnabled();
    if (!m_silent) emit readingChanged();
  };
  connect(m_weld, &QCheckBox::toggled, this, reread);
  connect(m_tolerance, &QDoubleSpinBox::valueChanged, this, reread);
}

void RecipeForm::addRepairGroup()
{
  QFormLayout* form = addGroup(QT_TR_NOOP("Repair"), "importRepairGroup");
  m_useless = addCheck(form, "importUseless", QT_TR_NOOP("Take away degenerate and duplicate triangles"));
  m_orientation = addCheck(form, "importOrientation", QT_TR_NOOP("Turn all triangles to the same side"));
  m_junctions = addCheck(form, "importJunctions", QT_TR_NOOP("Tie vertices to edges that they lie on"));
  m_smallParts = addNumber(form, "importSmallParts", QT_TR_NOOP("Drop parts below"), 0.0, 99.0, 1);
  m_holes = addCount(form, "importHoles", QT_TR_NOOP("Fill holes up to"), 100'000, QT_TR_NOOP("no hole"));
}

void RecipeForm::addNetGroup()
{
  QFormLayout* form = addGroup(QT_TR_NOOP("Net"), "importNetGroup");
  m_triangles =
    addCount(form, "importTriangles", QT_TR_NOOP("Remesh to"), 10'000'000, QT_TR_NOOP("as it is"));
  m_triangles->setSingleStep(1000);
  m_polygons = addCombo(form, "importPolygons", QT_TR_NOOP("Polygons"),
                        {QT_TR_NOOP("edges and diagonals"), QT_TR_NOOP("edges only")});
}

void RecipeForm::addSupportGroup()
{
  QFormLayout* form = addGroup(QT_TR_NOOP("Support"), "importSupportGroup");
  m_interior = addCombo(form, "importInterior", QT_TR_NOOP("Inside"),
                        {QT_TR_NOOP("nothing"), QT_TR_NOOP("wall of cells (hollow organs)"),
                         QT_TR_NOOP("struts to the opposite wall"), QT_TR_NOOP("hubs with spokes"),
                         QT_TR_NOOP("lattice"), QT_TR_NOOP("tetrahedra (tetgen or gmsh)")});
  m_hint = new QLabel(this);
  m_hint->setObjectName(QStringLiteral("importInteriorHint"));
  m_hint->setWordWrap(true);
  form->addRow(m_hint);
  m_struts = add(form, new QSpinBox(this), "importStruts", QT_TR_NOOP("Struts per node"));
  m_struts->setRange(1, 16);
  m_struts->setKeyboardTracking(false);
  connect(m_struts, &QSpinBox::valueChanged, this, &RecipeForm::told);
  m_anchors = addCombo(form, "importAnchors", QT_TR_NOOP("Bands to the cavity"),
                       {QT_TR_NOOP("none"), QT_TR_NOOP("from every node")});
  m_band = addNumber(form, "importBand", QT_TR_NOOP("Length of the bands"), 0.1, 1000.0, 1);
  m_pressure = addNumber(form, "importPressure", QT_TR_NOOP("Pressure keeps the volume"), 0.0, 1e6, 1);
}

void RecipeForm::addMaterialGroup()
{
  QFormLayout* form = addGroup(QT_TR_NOOP("Material"), "importMaterialGroup");
  m_body =
    addCombo(form, "importBody", QT_TR_NOOP("Body"), {QT_TR_NOOP("wall of tissue"), QT_TR_NOOP("solid")});
  m_thickness = addNumber(form, "importThickness", QT_TR_NOOP("Wall thickness"), 0.0, 100.0, 2);
  m_density = addNumber(form, "importDensity", QT_TR_NOOP("Density"), 0.0, 10'000.0, 0);
  m_modulus = addNumber(form, "importModulus", QT_TR_NOOP("Young's modulus"), 0.0, 100'000.0, 2);
  m_fit = addCheck(form, "importFit", QT_TR_NOOP("Fit the springs to Young's modulus"));
}

// === Values

ImportRecipe RecipeForm::recipe() const
{
  ImportRecipe recipe = m_recipe;
  recipe.unit = kUnits[m_unit->currentIndex()];
  recipe.up = kAxes[m_axes->currentIndex()].up;
  recipe.patientAxes = kAxes[m_axes->currentIndex()].patient;
  recipe.ignoreStated = !m_useStated->isChecked();
  recipe.weldTolerance = m_weld->isChecked() ? m_tolerance->value() : -1.0;
  recipe.polygons = static_cast<PolygonSprings>(m_polygons->currentIndex());
  recipe.repair.removeUseless = m_useless->isChecked();
  recipe.repair.unifyOrientation = m_orientation->isChecked();
  recipe.repair.closeTJunctions = m_junctions->isChecked();
  recipe.repair.dropPartsShare = m_smallParts->value() / 100.0;
  recipe.repair.fillHolesUpTo = m_holes->value();
  recipe.repair.triangles = m_triangles->value();
  recipe.support.interior = kInteriors[m_interior->currentIndex()];
  recipe.support.strutsPerNode = m_struts->value();
  recipe.support.anchors = static_cast<SupportOptions::Anchors>(m_anchors->currentIndex());
  recipe.support.anchorLength = m_band->value() / 1000.0;
  recipe.support.bulkModulus = m_pressure->value() * 1000.0;
  recipe.material.body = static_cast<MaterialOptions::Body>(m_body->currentIndex());
  recipe.material.thickness = m_thickness->value() / 1000.0;
  recipe.material.density = m_density->value();
  recipe.material.youngsModulus = m_modulus->value() * 1000.0;
  recipe.material.fitModulus = m_fit->isChecked();
  return recipe;
}

void RecipeForm::setRecipe(const ImportRecipe& recipe)
{
  m_silent = true;
  m_recipe = recipe;
  m_unit->setCurrentIndex(placeOf(recipe.unit));
  m_axes->setCurrentIndex(placeOf(recipe.up, recipe.patientAxes));
  m_useStated->setChecked(!recipe.ignoreStated);
  m_weld->setChecked(recipe.weldTolerance >= 0.0);
  m_tolerance->setValue(std::max(recipe.weldTolerance, 0.0));
  m_polygons->setCurrentIndex(static_cast<int>(recipe.polygons));
  m_useless->setChecked(recipe.repair.removeUseless);
  m_orientation->setChecked(recipe.repair.unifyOrientation);
  m_junctions->setChecked(recipe.repair.closeTJunctions);
  m_smallParts->setValue(recipe.repair.dropPartsShare * 100.0);
  m_holes->setValue(recipe.repair.fillHolesUpTo);
  m_triangles->setValue(recipe.repair.triangles);
  m_interior->setCurrentIndex(placeOf(recipe.support.interior));
  m_struts->setValue(recipe.support.strutsPerNode);
  m_anchors->setCurrentIndex(recipe.support.anchors == SupportOptions::Anchors::None ? 0 : 1);
  m_band->setValue(recipe.support.anchorLength * 1000.0);
  m_pressure->setValue(recipe.support.bulkModulus / 1000.0);
  m_body->setCurrentIndex(static_cast<int>(recipe.material.body));
  m_thickness->setValue(recipe.material.thickness * 1000.0);
  m_density->setValue(recipe.material.density);
  m_modulus->setValue(recipe.material.youngsModulus / 1000.0);
  m_fit->setChecked(recipe.material.fitModulus);
  m_silent = false;
  refreshEnabled();
}

void RecipeForm::told()
{
  refreshEnabled();
  if (!m_silent) emit changed();
}

void RecipeForm::setStated(const StatedFrame& stated)
{
  m_stated = stated;
  refreshEnabled();
}

/// What holds is what is shown; a choice against it begins there.
void RecipeForm::showStated()
{
  const QSignalBlocker noUnit(m_unit), noAxes(m_axes);
  for (const LengthUnit unit : kUnits)
    if (m_stated.metres && std::abs(*m_stated.metres / metresPer(unit) - 1.0) < 1e-9)
      m_unit->setCurrentIndex(placeOf(unit));
  if (!m_stated.up && !m_stated.patientAxes) return;
  const int axes = placeOf(m_stated.up.value_or(UpAxis::Z), m_stated.patientAxes.value_or(PatientAxes::None));
  if (axes < m_axes->count()) m_axes->setCurrentIndex(axes);
}

void RecipeForm::refreshEnabled()
{
  const bool asStated = m_useStated->isChecked();
  if (asStated) showStated();
  m_useStated->setVisible(!m_stated.isEmpty());
  m_unit->setEnabled(!asStated || !m_stated.metres);
  m_axes->setEnabled(!asStated || !(m_stated.up || m_stated.patientAxes));
  m_tolerance->setEnabled(m_weld->isChecked());
  m_struts->setEnabled(kInteriors[m_interior->currentIndex()] == Interior::Struts);
  m_hint->setText(tr(hintOf(kInteriors[m_interior->currentIndex()])));
  m_band->setEnabled(m_anchors->currentIndex() > 0);
  m_fit->setEnabled(!(m_modulus->value() > 0.0)); // a given modulus brings the fit with it
}

// === Texts

void RecipeForm::changeEvent(QEvent* event)
{
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

void RecipeForm::retranslate()
{
  for (const Line& line : m_lines) {
    const QString text = tr(line.text);
    line.field->setAccessibleName(text);
    if (auto* group = qobject_cast<QGroupBox*>(line.field)) {
      group->setTitle(text);
    } else if (auto* box = qobject_cast<QCheckBox*>(line.field)) {
      box->setText(text);
    } else if (auto* form = qobject_cast<QFormLayout*>(line.field->parentWidget()->layout())) {
      static_cast<QLabel*>(form->labelForField(line.field))->setText(text);
    }
  }
  for (const auto& [box, items] : m_combos)
    for (std::size_t i = 0; i < items.size(); ++i) box->setItemText(static_cast<int>(i), tr(items[i]));
  m_hint->setText(tr(hintOf(kInteriors[m_interior->currentIndex()])));
  for (const auto& [box, none] : m_counts) box->setSpecialValueText(tr(none));
  m_tolerance->setSpecialValueText(tr("equal positions only"));
  m_smallParts->setSpecialValueText(tr("none"));
  m_smallParts->setSuffix(tr(" % of the largest"));
  m_holes->setSuffix(tr(" edges"));
  m_triangles->setSuffix(tr(" triangles"));
  m_band->setSuffix(QStringLiteral(" mm"));
  m_thickness->setSuffix(QStringLiteral(" mm"));
  m_density->setSuffix(QStringLiteral(" kg/m³"));
  m_modulus->setSuffix(QStringLiteral(" kPa"));
  m_pressure->setSuffix(QStringLiteral(" kPa"));
  m_pressure->setSpecialValueText(tr("no pressure"));
  m_pressure->setToolTip(
    tr("Bulk modulus of what fills a closed surface: the larger, the less its volume gives way"));
  for (QDoubleSpinBox* box : {m_thickness, m_density, m_modulus})
    box->setSpecialValueText(tr("as the tissue says"));
  m_modulus->setToolTip(
    tr("Sets the inputs of the rules, and scales all springs until the net is as stiff as the body"));
  m_density->setToolTip(tr("Sets the inputs of the rules"));
  m_fit->setToolTip(
    tr("A virtual tension test: pulled along its longest axis the net becomes as stiff as the body"));
  m_triangles->setToolTip(tr("Springs of nearly equal length allow a larger time step"));
  m_interior->setToolTip(
    tr("A surface alone gives way like a bag; what is inside carries the load. It can be taken away again."));
}

} // namespace esm
