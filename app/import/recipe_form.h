// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/import_recipe.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QSpinBox;

namespace esm {

/// The choices of an import, group by group: file, repair, net, support, material. Edits a recipe; whatever
/// the form does not show stays as it was given.
class RecipeForm : public QWidget {
  Q_OBJECT
public:
  explicit RecipeForm(QWidget* parent = nullptr);

  ImportRecipe recipe() const;
  void setRecipe(const ImportRecipe& recipe); ///< without a signal
  /// What the files state themselves holds in place of the choices, unless a box says no.
  void setStated(const StatedFrame& stated);

signals:
  void readingChanged(); ///< welding: the files must be read again
  void changed();        ///< anything else

protected:
  void changeEvent(QEvent* event) override;

private:
  /// A line of the form; its text follows the language.
  struct Line {
    QWidget* field;
    const char* text;
  };
  QFormLayout* addGroup(const char* title, const char* name);
  template <class Widget>
  Widget* add(QFormLayout* form, Widget* widget, const char* name, const char* text);
  QCheckBox* addCheck(QFormLayout* form, const char* name, const char* text);
  QComboBox* addCombo(QFormLayout* form, const char* name, const char* text, std::vector<const char*> items);
  QSpinBox* addCount(QFormLayout* form, const char* name, const char* text, int most, const char* none);
  void addFileGroup();
  void addRepairGroup();
  void addNetGroup();
  void addSupportGroup();
  void addMaterialGroup();
  QDoubleSpinBox* addNumber(QFormLayout* form, const char* name, const char* text, double least, double most,
                            int decimals);
  void retranslate();
  void showStated();
  void refreshEnabled();
  void told();

  ImportRecipe m_recipe;
  StatedFrame m_stated;
  bool m_silent = false;
  std::vector<Line> m_lines;
  std::vector<std::pair<QComboBox*, std::vector<const char*>>> m_combos;
  std::vector<std::pair<QSpinBox*, const char*>> m_counts; ///< with the text for none

  QLabel* m_hint = nullptr; ///< about the chosen interior
  QComboBox *m_unit = nullptr, *m_axes = nullptr, *m_polygons = nullptr, *m_interior = nullptr,
            *m_anchors = nullptr, *m_body = nullptr;
  QCheckBox *m_useStated = nullptr, *m_weld = nullptr, *m_useless = nullptr, *m_orientation = nullptr,
            *m_junctions = nullptr, *m_fit = nullptr;
  QDoubleSpinBox *m_tolerance = nullptr, *m_smallParts = nullptr, *m_band = nullptr, *m_thickness = nullptr,
                 *m_density = nullptr, *m_modulus = nullptr, *m_pressure = nullptr;
  QSpinBox *m_holes = nullptr, *m_triangles = nullptr, *m_struts = nullptr;
};

} // namespace esm
