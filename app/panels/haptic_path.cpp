// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/haptic_path.h"

#include "app/panels/describe.h"
#include "app/text/error_text.h"
#include "core/base/file_io.h"
#include "core/base/state_folder.h"
#include "haptics/emulator/emulated_falcon.h"
#include "haptics/simulated_device.h"
#include "haptics/trace_log.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QEvent>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>

#include <algorithm>

namespace esm {

namespace {

QString number(double value, int decimals)
{
  return QLocale().toString(value, 'f', decimals);
}

constexpr const char* kPathDevice = "path"; ///< simulated, led by a path

QString recordingsFolder()
{
  return QString::fromStdString(stateFolder("recordings").string());
}

/// The newest one whose program, the number at the end of its name, runs no more; empty if there is none.
QString leftRecording()
{
  if (recordingsFolder().isEmpty()) return {};
  const QDir folder(recordingsFolder());
  for (const QFileInfo& file :
       folder.entryInfoList({QStringLiteral("felt-*.csv")}, QDir::Files, QDir::Time)) {
    const QString program = file.completeBaseName().section(QLatin1Char('-'), -1);
    if (!QFileInfo::exists(QStringLiteral("/proc/") + program)) return file.absoluteFilePath();
  }
  return {};
}

} // namespace

HapticPath::HapticPath(DeviceDesk* desk, SimulationController* controller, QWidget* parent)
  : QWidget(parent), m_desk(desk), m_controller(controller), m_left(leftRecording())
{
  const auto button = [this](const char* name) {
    auto* made = new QPushButton(this);
    made->setObjectName(QLatin1String(name));
    made->setAutoDefault(false);
    return made;
  };
  const auto label = [this](const char* name) {
    auto* made = new QLabel(this);
    made->setObjectName(QLatin1String(name));
    made->setWordWrap(true);
    return made;
  };
  m_record = button("hapticRecord");
  m_record->setCheckable(true);
  m_savePath = button("hapticSavePath");
  m_saveLog = button("hapticSaveLog");
  m_load = button("hapticLoadPath");
  m_lead = button("hapticLead");
  m_recorded = label("hapticRecorded");
  m_loaded = label("hapticLoaded");
  auto* grid = new QGridLayout(this);
  grid->addWidget(m_record, 0, 0);
  grid->addWidget(m_savePath, 0, 1);
  grid->addWidget(m_saveLog, 0, 2);
  grid->addWidget(m_recorded, 1, 0, 1, 4);
  grid->addWidget(m_load, 2, 0);
  grid->addWidget(m_lead, 2, 1, 1, 2);
  grid->addWidget(m_loaded, 3, 0, 1, 4);
  grid->setRowStretch(4, 1);
  grid->setColumnStretch(3, 1);
  connect(m_record, &QPushButton::toggled, this, &HapticPath::record);
  connect(m_savePath, &QPushButton::clicked, this, [this] { save(true); });
  connect(m_saveLog, &QPushButton::clicked, this, [this] { save(false); });
  connect(m_load, &QPushButton::clicked, this, &HapticPath::load);
  connect(m_lead, &QPushButton::clicked, this, &HapticPath::lead);
  connect(m_controller, &SimulationController::deviceTicked, this, &HapticPath::take);
  connect(m_controller, &SimulationController::deviceChanged, this, [this] {
    if (m_controller->deviceName() != kPathDevice) m_hand = nullptr;
    if (m_recording) m_record->setChecked(false); // another device, another clock
    refresh();
  });
  retranslateUi();
}

HapticPath::~HapticPath()
{
  dropLog();
}

void HapticPath::take(const std::vector<TraceSample>& ticks)
{
  if (!m_recording) return;
  m_ticks.insert(m_ticks.end(), ticks.begin(), ticks.end());
  if (m_log) m_log->add(ticks);
  if (m_ticks.size() >= kMostTicks) m_record->setChecked(false);
}

void HapticPath::record(bool on)
{
  m_recording = on;
  if (on) {
    m_ticks.clear();
    beginLog();
  } else if (m_log) {
    const Status written = m_log->finish();
    m_log.reset();
    if (!written) emit said(errorText(written.error()));
  }
  refresh();
}

/// Without one it is recorded all the same, and the user knows that it would not survive.
void HapticPath::beginLog()
{
  dropLog();
  const QString folder = recordingsFolder();
  if (folder.isEmpty()) return;
  QDir().mkpath(folder);
  const QString file =
    QStringLiteral("%1/felt-%2-%3.csv")
      .arg(folder, QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss")))
      .arg(QCoreApplication::applicationPid());
  Result<TraceLog> log = TraceLog::create(file.toStdString(), TraceLog::Columns::All);
  if (!log) return emit said(errorText(log.error()));
  m_log.emplace(std::move(*log));
  m_logFile = file;
}

void HapticPath::dropLog()
{
  m_log.reset();
  if (!m_logFile.isEmpty()) QFile::remove(m_logFile);
  m_logFile.clear();
}

void HapticPath::refresh()
{
  const bool device = !m_controller->deviceName().empty();
  m_record->setEnabled(device || m_recording);
  m_record->setText(m_recording ? tr("End recording") : tr("Record"));
  m_savePath->setEnabled(!m_recording && !m_ticks.empty());
  m_saveLog->setEnabled(!m_recording && !m_ticks.empty());
  double peak = 0.0;
  if (!m_recording)
    for (const TraceSample& tick : m_ticks) peak = std::max(peak, tick.force.norm());
  const double seconds = m_ticks.empty() ? 0.0 : m_ticks.back().time - m_ticks.front().time;
  if (m_recording)
    m_recorded->setText(tr("Recording: %1 s").arg(number(seconds, 1)));
  else if (m_ticks.empty())
    m_recorded->setText(m_left.isEmpty() ? tr("Nothing is recorded yet.")
                                         : tr("A recording that was not saved is in %1").arg(m_left));
  else
    m_recorded->setText(tr("Recorded: %1 s, largest force %2 N").arg(number(seconds, 1), number(peak, 2)));
  m_lead->setEnabled(m_path.has_value());
  m_lead->setText(m_hand != nullptr || emulated() ? tr("Lead the hand") : tr("Connect the path's hand"));
  m_loaded->setText(m_path ? tr("%1: %2 s, %3 points")
                               .arg(QFileInfo(m_file).fileName(), number(m_path->duration(), 1))
                               .arg(m_path->time.size())
                           : tr("No path is loaded."));
}

void HapticPath::save(bool path)
{
  const QString file =
    QFileDialog::getSaveFileName(this, path ? tr("Save the path of the hand") : tr("Save what the hand felt"),
                                 path ? tr("hand.csv") : tr("felt.csv"), tr("Tables (*.csv)"));
  if (file.isEmpty()) return;
  const Status written = path ? writeHandPath(file.toStdString(), handPathOf(m_ticks))
                              : writeFileAtomically(file.toStdString(), traceCsv(m_ticks));
  if (!written) return emit said(errorText(written.error()));
  if (!path) dropLog();
}

void HapticPath::load()
{
  const QString file =
    QFileDialog::getOpenFileName(this, tr("Path of a hand"), QFileInfo(m_file).absolutePath(),
                                 tr("Tables (*.csv)") + QStringLiteral(";;") + tr("All files (*)"));
  if (file.isEmpty()) return;
  Result<HandPath> path = readHandPath(file.toStdString());
  if (!path) return emit said(errorText(path.error()));
  m_path = std::move(*path);
  m_file = file;
  refresh();
}

bool HapticPath::emulated() const
{
  return m_desk->emulated() != nullptr && m_controller->deviceName() == "falcon";
}

/// The hand rests where the path begins until it is led: so force can be turned on first.
void HapticPath::lead()
{
  if (!m_path) return;
  if (emulated()) return m_desk->emulated()->follow(*m_path);
  if (m_hand != nullptr) return m_hand->go();
  auto hand = std::make_unique<WaitingHand>(*m_path);
  WaitingHand* waiting = hand.get();
  auto device = std::make_unique<SimulatedDevice>(SimulatedDeviceSettings{}, std::move(hand));
  const Status attached =
    m_controller->attachDevice(std::move(device), kPathDevice, SimulationController::Coupling::Touches);
  if (!attached) return emit said(errorText(attached.error()));
  m_hand = waiting;
  refresh();
}

void HapticPath::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::LanguageChange) retranslateUi();
  QWidget::changeEvent(event);
}

void HapticPath::retranslateUi()
{
  describe(m_record, tr("Record the way of the hand and what it feels, ten minutes at most"));
  m_savePath->setText(tr("Save path…"));
  describe(m_savePath, tr("Save the way of the hand: t, x, y, z in s and m"));
  m_saveLog->setText(tr("Save log…"));
  describe(m_saveLog, tr("Save what the hand felt, tick by tick: position, velocity, force, work, lateness"));
  m_load->setText(tr("Load path…"));
  describe(m_load, tr("Load the way of a hand"));
  describe(m_lead, tr("Let the loaded path lead the hand of a device in the computer"));
  refresh();
}

} // namespace esm
