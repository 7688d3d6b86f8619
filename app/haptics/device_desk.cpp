// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/haptics/device_desk.h"

#include <QSettings>

#include <algorithm>
#include <utility>

namespace esm {

namespace {

constexpr int kWatchEvery = 200; // [ms]; a change shows soon, and asking for the counter costs nothing

QString firmwareKey()
{
  return QStringLiteral("haptics/firmware");
}

bool isUsb(const std::string& name)
{
  const auto kinds = deviceKinds();
  const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const auto& k) { return k.name == name; });
  return found != kinds.end() && found->usb;
}

} // namespace

DeviceDesk::DeviceDesk(std::shared_ptr<DeviceSource> source, QObject* parent)
  : QObject(parent), m_source(std::move(source)), m_scan(this), m_open(this)
{
  m_options.firmware = QSettings().value(firmwareKey()).toString().toStdString();
  for (const DeviceKind& kind : deviceKinds()) // until USB has answered
    m_listings.push_back({std::string(kind.name), std::string(kind.description), !kind.usb,
                          kind.usb ? "Looking for it" : "", "", ""});
  for (JobRunner* runner : {&m_scan, &m_open})
    connect(runner, &JobRunner::busyChanged, this, &DeviceDesk::busyChanged);
  connect(&m_watch, &QTimer::timeout, this, [this] {
    const std::uint32_t changes = m_source->changes();
    if (changes == m_changes) return;
    m_changes = changes;
    rescan();
  });
  m_watch.start(kWatchEvery);
  rescan();
}

const DeviceListing* DeviceDesk::find(const std::string& name) const
{
  const auto found = std::find_if(m_listings.begin(), m_listings.end(),
                                  [&](const DeviceListing& listing) { return listing.name == name; });
  return found == m_listings.end() ? nullptr : &*found;
}

void DeviceDesk::rescan()
{
  m_scan.start([source = m_source, options = m_options](
                 WorkControl*) -> Result<std::vector<DeviceListing>> { return source->list(options); },
               [this](Result<std::vector<DeviceListing>> found) {
                 if (!found) return; // no memory: the former list is the best there is
                 m_listings = std::move(*found);
                 emit listed();
               });
}

void DeviceDesk::open(const std::string& name, std::function<void(Opened)> finish)
{
  m_open.cancel();
  if (!isUsb(name)) return finish(openDevice(name)); // never waits for a scan
  m_open.start([source = m_source, name,
                options = m_options](WorkControl*) -> Opened { return source->open(name, options); },
               [finish = std::move(finish)](Opened opened) { finish(std::move(opened)); });
}

void DeviceDesk::setFirmware(const QString& file)
{
  m_options.firmware = file.toStdString();
  QSettings().setValue(firmwareKey(), file);
  rescan();
}

void DeviceDesk::setConsent(bool consent)
{
  m_options.optIn = consent;
  rescan();
}

} // namespace esm
