// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/input_row.h"

#include "fuzzyeditor/number_spin_box.h"
#include "fuzzyeditor/panel_colors.h"
#include "fuzzyeditor/rules/rule_display.h"

#include <QAccessible>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QSlider>
#include <QToolButton>

#include <algorithm>
#include <array>
#include <cmath>

namespace esm {
namespace {

constexpr int kSliderSteps = 1000;

} // namespace

InputRow::InputRow(FuzzyDocument* document, int input, QWidget* parent)
  : QWidget(parent),
    m_document(document),
    m_input(input),
    m_name(new QLabel),
    m_slider(new QSlider(Qt::Horizontal)),
    m_spin(new NumberSpinBox),
    m_word(new QComboBox),
    m_reset(new QToolButton),
    m_mistake(new QLabel)
{
  const QString id = toQt(variable().id);
  m_slider->setObjectName("slider_" + id);
  m_spin->setObjectName("spin_" + id);
  m_word->setObjectName("word_" + id);
  m_reset->setObjectName("reset_" + id);
  m_mistake->setObjectName("mistake_" + id);
  layOut();

  const fuzzy::Variable& v = variable();
  const DisplayUnit unit = RuleDisplay::displayUnit(v.unit);
  m_slider->setRange(0, kSliderSteps);
  m_slider->setSingleStep(kSliderSteps / 100);
  m_slider->setPageStep(kSliderSteps / 10);
  m_spin->setRange(v.minimum / unit.factor, v.maximum / unit.factor);
  const double span = m_spin->maximum() - m_spin->minimum();
  m_spin->setDecimals(std::clamp(3 - static_cast<int>(std::floor(std::log10(span))), 0, 6));
  m_spin->setSingleStep(span / 100);
  m_spin->setSuffix(unit.symbol.isEmpty() ? QString() : QChar(0x00a0) + unit.symbol);
  connectFields();
  retranslate();
}

void InputRow::layOut()
{
  m_word->setEditable(true);
  m_word->setInsertPolicy(QComboBox::NoInsert);
  m_word->setCompleter(nullptr); // it would turn "hart" into the first word that starts so
  m_word->setFocusPolicy(Qt::StrongFocus);
  m_word->setMinimumContentsLength(12);
  m_word->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_reset->setText(QStringLiteral("↺"));
  m_reset->setAutoRaise(true);
  m_reset->setFocusPolicy(Qt::TabFocus);
  m_mistake->setWordWrap(true);
  m_mistake->setTextFormat(Qt::PlainText);
  m_mistake->hide();
  QFont bold = m_name->font();
  bold.setWeight(QFont::DemiBold);
  m_name->setFont(bold);
  m_name->setBuddy(m_slider);

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 4);
  grid->setHorizontalSpacing(6);
  grid->setVerticalSpacing(2);
  grid->addWidget(m_name, 0, 0);
  grid->addWidget(m_word, 0, 1, 1, 2);
  grid->addWidget(m_slider, 1, 0);
  grid->addWidget(m_spin, 1, 1);
  grid->addWidget(m_reset, 1, 2);
  grid->addWidget(m_mistake, 2, 0, 1, 3);
  grid->setColumnStretch(0, 1);
  m_spin->setMinimumWidth(m_spin->fontMetrics().horizontalAdvance("00,0000") + 40);
  QWidget::setTabOrder(m_slider, m_spin);
  QWidget::setTabOrder(m_spin, m_word);
  QWidget::setTabOrder(m_word, m_reset);
  for (QWidget* field : std::array<QWidget*, 4>{m_slider, m_spin, m_word, m_word->lineEdit()})
    field->installEventFilter(this);
}

void InputRow::connectFields()
{
  connect(m_slider, &QSlider::sliderPressed, this, [this] { m_drag = nextGesture(); });
  connect(m_slider, &QSlider::sliderReleased, this, [this] { m_keys.end(); });
  connect(m_slider, &QSlider::valueChanged, this, [this](int position) {
    if (m_showing) return;
    setCrisp(fromSlider(double(position) / kSliderSteps), m_slider->isSliderDown() ? m_drag : m_keys.press());
  });
  connect(m_spin, &NumberSpinBox::aboutToStep, this, [this] { m_stepping = true; });
  connect(m_spin, &QDoubleSpinBox::valueChanged, this, [this](double shown) {
    const bool stepped = std::exchange(m_stepping, false);
    if (!m_showing)
      setCrisp(shown * RuleDisplay::displayUnit(variable().unit).factor, stepped ? m_keys.press() : 0);
  });
  connect(m_word->lineEdit(), &QLineEdit::textEdited, this, [this] {
    m_wordTyped = true;
    showMistake({});
  });
  connect(m_word->lineEdit(), &QLineEdit::editingFinished, this, [this] {
    if (m_wordTyped) takeWord(m_word->currentText());
  });
  connect(m_word, &QComboBox::activated, this, [this](int row) {
    if (!m_wordTyped || m_word->itemText(row) == m_word->currentText()) takeWord(m_word->itemText(row));
  });
  connect(m_reset, &QToolButton::clicked, this, [this] {
    m_wordTyped = false;
    showMistake({});
    m_document->setInput(m_input, variable().defaultValue, 0);
    showValue();
  });
}

const fuzzy::Variable& InputRow::variable() const
{
  return m_document->ruleBase().inputs[static_cast<std::size_t>(m_input)];
}

fuzzy::InputValue InputRow::value() const
{
  const auto index = static_cast<std::size_t>(m_input);
  return index < m_document->inputs().size() ? m_document->inputs()[index]
                                             : fuzzy::InputValue(variable().defaultValue);
}

double InputRow::toSlider(double plain) const
{
  const fuzzy::Variable& v = variable();
  const double x = std::clamp(plain, v.minimum, v.maximum);
  if (v.logarithmic) return std::log(x / v.minimum) / std::log(v.maximum / v.minimum);
  return (x - v.minimum) / (v.maximum - v.minimum);
}

double InputRow::fromSlider(double position) const
{
  const fuzzy::Variable& v = variable();
  if (v.logarithmic) return v.minimum * std::pow(v.maximum / v.minimum, position);
  return v.minimum + position * (v.maximum - v.minimum);
}

/// Where a word sits on the slider: the middle of what it fits best.
double InputRow::crispOf(const fuzzy::InputValue& input) const
{
  if (const double* crisp = std::get_if<double>(&input))
    return std::isfinite(*crisp) ? *crisp : variable().defaultValue;
  const fuzzy::Word& word = std::get<fuzzy::Word>(input);
  for (const fuzzy::Term& term : variable().terms) {
    if (term.id != word.term) continue;
    double best = -1, first = 0, last = 0;
    for (int step = 0; step <= kSliderSteps; ++step) {
      const double position = double(step) / kSliderSteps;
      const double x = fromSlider(position);
      const double mu =
        fuzzy::applyHedges(word.hedges, fuzzy::membership(term, variable().logarithmic ? std::log10(x) : x));
      if (mu > best + 1e-9) {
        best = mu;
        first = position;
      }
      if (mu >= best - 1e-9) last = position;
    }
    return fromSlider((first + last) / 2);
  }
  return variable().defaultValue;
}

void InputRow::setCrisp(double plain, int gestureNumber)
{
  m_wordTyped = false;
  showMistake({});
  m_document->setInput(m_input, plain, gestureNumber);
}

void InputRow::takeWord(const QString& text)
{
  const std::string utf8 = toUtf8(text);
  const auto parsed = fuzzy::parseInput(utf8, variable());
  if (const auto* error = std::get_if<fuzzy::RuleTextError>(&parsed)) {
    QString sentence = RuleDisplay::mistakeSentence(*error, RuleDisplay::offendingWord(utf8, *error),
                                                    m_document->ruleLanguage());
    if (!error->suggestion.empty()) sentence = tr("%1 Is ‘%2’ meant?").arg(sentence, toQt(error->suggestion));
    showMistake(sentence);
    return;
  }
  const fuzzy::InputValue input = std::get<fuzzy::InputValue>(parsed);
  const double* crisp = std::get_if<double>(&input);
  if (crisp && !(*crisp >= variable().minimum && *crisp <= variable().maximum)) {
    showMistake(tr("The value must lie between %1 and %2.")
                  .arg(RuleDisplay::quantity(variable().minimum, variable().unit, locale()),
                       RuleDisplay::quantity(variable().maximum, variable().unit, locale())));
    return;
  }
  m_wordTyped = false;
  showMistake({});
  if (input != value()) m_document->setInput(m_input, input, 0);
  showValue();
}

void InputRow::showMistake(const QString& sentence)
{
  if (m_mistake->text() == sentence) return;
  m_mistake->setText(sentence);
  m_mistake->setVisible(!sentence.isEmpty());
  QPalette colors = m_word->palette();
  colors.setColor(QPalette::Text,
                  sentence.isEmpty() ? palette().color(QPalette::Text) : panel_colors::mistake(palette()));
  m_word->lineEdit()->setPalette(colors);
  m_word->setAccessibleDescription(sentence);
  QPalette red = palette();
  red.setColor(QPalette::WindowText, panel_colors::mistake(palette()));
  m_mistake->setPalette(red);
  if (sentence.isEmpty() || !isVisible()) return;
  QAccessibleEvent alert(m_mistake, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
}

/// "hard 0.70" for a number, the word itself for a word.
QString InputRow::valueInWords(const fuzzy::InputValue& input) const
{
  const Language language = m_document->ruleLanguage();
  const double* crisp = std::get_if<double>(&input);
  if (!crisp) return toQt(fuzzy::formatInput(input, variable(), language));
  const fuzzy::NamedDegree best = fuzzy::bestTerm(variable(), *crisp);
  if (best.term < 0) return {};
  const QString word = toQt(variable().terms[static_cast<std::size_t>(best.term)].name.in(language));
  return word + ' ' + locale().toString(best.degree, 'f', 2);
}

void InputRow::showValue()
{
  const fuzzy::InputValue input = value();
  const double plain = crispOf(input);
  m_showing = true;
  if (!m_slider->isSliderDown()) m_slider->setValue(qRound(toSlider(plain) * kSliderSteps));
  m_spin->setValue(plain / RuleDisplay::displayUnit(variable().unit).factor);
  m_showing = false;
  if (!m_wordTyped) { // what was typed and not understood stays until it is mended or left by Esc
    const QString words = valueInWords(input);
    if (m_word->currentText() != words) m_word->setEditText(words);
    m_word->lineEdit()->setCursorPosition(0);
  }
  m_reset->setEnabled(input != fuzzy::InputValue(variable().defaultValue));
}

void InputRow::fillWords()
{
  const Language language = m_document->ruleLanguage();
  m_word->clear();
  for (const fuzzy::Term& term : variable().terms) {
    m_word->addItem(toQt(term.name.in(language)));
    const fuzzy::Word very{term.id, {fuzzy::Hedge::Very}};
    m_word->addItem(toQt(fuzzy::formatInput(very, variable(), language)));
  }
}

void InputRow::retranslate()
{
  const QString name = RuleDisplay::title(variable(), m_document->ruleLanguage());
  const QString typed = m_wordTyped ? m_word->currentText() : QString();
  m_name->setText(name);
  fillWords();
  if (m_wordTyped) m_word->setEditText(typed);
  m_slider->setAccessibleName(tr("%1, slider").arg(name));
  m_spin->setNamesForAccess(tr("%1, number").arg(name));
  m_word->setAccessibleName(tr("%1, word").arg(name));
  m_word->lineEdit()->setAccessibleName(tr("%1, word").arg(name));
  m_word->setToolTip(tr("Type a number or a word, for instance ‘%1’.").arg(m_word->itemText(1)));
  m_reset->setAccessibleName(tr("Reset %1 to its default").arg(name));
  m_reset->setToolTip(tr("Reset %1 to its default").arg(name));
  showValue();
}

bool InputRow::eventFilter(QObject* watched, QEvent* event)
{
  if (event->type() == QEvent::FocusIn) {
    emit focused(m_input);
    if (watched == m_word->lineEdit())
      QMetaObject::invokeMethod(m_word->lineEdit(), &QLineEdit::selectAll, Qt::QueuedConnection);
  }
  const bool unfocusedWheel = event->type() == QEvent::Wheel && (watched == m_slider || watched == m_word) &&
                              !static_cast<QWidget*>(watched)->hasFocus();
  if (unfocusedWheel) {
    event->ignore(); // scrolling the panel must not change the tissue
    return true;
  }
  if (event->type() == QEvent::KeyPress && watched == m_word->lineEdit() && m_wordTyped &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    m_wordTyped = false;
    showMistake({});
    showValue();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

} // namespace esm
