// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What a file manager is to a user: a small window from which files are dragged onto another program, by the
// display's own protocol.
// usage: esm_drag_source X Y FILE...
// Ends after the drag: with 0 if it was taken, with 1 if not.

#include <QApplication>
#include <QDrag>
#include <QFileInfo>
#include <QLabel>
#include <QMimeData>
#include <QMouseEvent>
#include <QUrl>

namespace {

class FileLabel : public QLabel {
public:
  explicit FileLabel(const QStringList& files)
    : QLabel(QString::number(files.size()) + QStringLiteral(" file(s)"), nullptr,
             Qt::Window | Qt::FramelessWindowHint)
  {
    for (const QString& file : files) m_urls.append(QUrl::fromLocalFile(QFileInfo(file).absoluteFilePath()));
    setWindowTitle(QStringLiteral("Files to drag"));
    setAlignment(Qt::AlignCenter);
    setFixedSize(120, 60);
  }

protected:
  void mousePressEvent(QMouseEvent*) override
  {
    auto* dragged = new QMimeData;
    dragged->setUrls(m_urls);
    // The drag goes when the other side has what it asked for, which may be after the button.
    auto* drag = new QDrag(this);
    drag->setMimeData(dragged);
    connect(drag, &QObject::destroyed, this, [this] { QApplication::exit(m_taken ? 0 : 1); });
    m_taken = drag->exec(Qt::CopyAction) == Qt::CopyAction;
  }

private:
  QList<QUrl> m_urls;
  bool m_taken = false;
};

} // namespace

int main(int argc, char** argv)
{
  QApplication application(argc, argv);
  const QStringList arguments = QApplication::arguments();
  if (arguments.size() < 4) return 2;
  FileLabel label(arguments.mid(3));
  label.move(arguments[1].toInt(), arguments[2].toInt());
  label.show();
  return QApplication::exec();
}
