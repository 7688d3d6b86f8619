// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dialogs/recovery_dialog.h"

#include <QDateTime>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

namespace esm {

namespace {

constexpr QSize kPicture(160, 100);

/// A frame that says so where there is no picture.
QPixmap noPicture(const QWidget& list)
{
  QPixmap picture(kPicture);
  picture.fill(list.palette().color(QPalette::AlternateBase));
  QPainter painter(&picture);
  painter.setPen(list.palette().color(QPalette::Disabled, QPalette::Text));
  painter.setFont(list.font());
  const QRect frame = picture.rect().adjusted(0, 0, -1, -1);
  painter.drawRect(frame);
  painter.drawText(frame, Qt::AlignCenter | Qt::TextWordWrap, RecoveryDialog::tr("no picture yet"));
  return picture;
}

QIcon pictureOf(const FoundJournal& journal, const QWidget& list)
{
  const QPixmap picture(QString::fromStdString((journal.folder / kJournalPicture).string()));
  return QIcon(picture.isNull() ? noPicture(list) : picture);
}

} // namespace

QString journalName(const FoundJournal& journal)
{
  if (!journal.name.empty()) return QString::fromStdString(journal.name);
  if (journal.path.empty()) return RecoveryDialog::tr("Untitled");
  return QFileInfo(QString::fromStdString(journal.path)).completeBaseName();
}

QString stepsText(int steps, bool neverSaved, bool hasDraft)
{
  QStringList parts;
  if (steps > 0 && neverSaved)
    parts << RecoveryDialog::tr("%n step(s), never saved", nullptr, steps);
  else if (steps > 0)
    parts << RecoveryDialog::tr("%n step(s) after the last save", nullptr, steps);
  if (hasDraft) parts << RecoveryDialog::tr("a rule that was being written");
  return parts.join(QStringLiteral(", "));
}

RecoveryDialog::RecoveryDialog(const std::vector<FoundJournal>& found, QWidget* parent)
  : QDialog(parent), m_list(new QListWidget(this))
{
  setObjectName(QStringLiteral("dlgRecovery"));
  setWindowTitle(tr("Recover unsaved work"));
  auto* lead = new QLabel(tr("The program ended before this was saved:"));
  m_list->setObjectName(QStringLiteral("recoveryList"));
  m_list->setAccessibleName(lead->text());
  m_list->setIconSize(kPicture);
  for (const FoundJournal& journal : found) addRow(journal);
  m_list->setCurrentRow(0);

  auto* buttons = new QDialogButtonBox;
  const auto add = [&](const QString& text, const char* name, QDialogButtonBox::ButtonRole role,
                       Answer answer) {
    QPushButton* button = buttons->addButton(text, role);
    button->setObjectName(QLatin1String(name));
    connect(button, &QPushButton::clicked, this, [this, answer] { end(answer); });
    return button;
  };
  add(tr("&Recover"), "recoveryRecover", QDialogButtonBox::AcceptRole, Recover)->setDefault(true);
  add(tr("&Discard"), "recoveryDiscard", QDialogButtonBox::DestructiveRole, Discard);
  QPushButton* later = add(tr("&Later"), "recoveryLater", QDialogButtonBox::RejectRole, Later);
  later->setToolTip(tr("Keeps everything; File > Recover unsaved work shows it again"));
  connect(m_list, &QListWidget::itemActivated, this, [this] { end(Recover); });

  auto* layout = new QVBoxLayout(this);
  layout->addWidget(lead);
  layout->addWidget(m_list, 1);
  layout->addWidget(buttons);
  resize(560, 160 + 110 * std::clamp(static_cast<int>(found.size()), 1, 4));
}

void RecoveryDialog::addRow(const FoundJournal& journal)
{
  const QDateTime time = QDateTime::fromSecsSinceEpoch(journal.time);
  const QString path = QString::fromStdString(journal.path);
  QStringList lines{journalName(journal), stepsText(journal.steps, journal.path.empty(), journal.hasDraft),
                    QLocale().toString(time, QLocale::ShortFormat)};
  if (!path.isEmpty()) lines << path;
  auto* item = new QListWidgetItem(pictureOf(journal, *m_list), lines.join(QLatin1Char('\n')), m_list);
  item->setToolTip(path);
}

int RecoveryDialog::chosen() const
{
  return m_list->currentRow();
}

void RecoveryDialog::end(Answer answer)
{
  m_answer = answer;
  answer == Later ? reject() : accept();
}

} // namespace esm
