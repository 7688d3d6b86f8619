// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/haptics/umock/usb_testbed.h"

#include "haptics/protocol/byte_order.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <span>
#include <string>
#include <utility>

#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>

namespace esm {

namespace {

constexpr char kNode[] = "/dev/bus/usb/001/002", kPlace[] = "/sys/devices/usb1/1-1";

std::string describe(const UsbDeviceModel& model)
{
  std::string hex;
  for (const auto* bytes : {&model.deviceDescriptor(), &model.configurationDescriptor()})
    for (const std::uint8_t byte : *bytes) {
      char digits[3];
      std::snprintf(digits, sizeof digits, "%02x", unsigned{byte});
      hex += digits;
    }
  return "P: /devices/usb1/1-1\nN: bus/usb/001/002\nE: SUBSYSTEM=usb\nE: DRIVER=usb\nE: BUSNUM=001\nE: "
         "DEVNUM=002\n"
         "E: DEVNAME=/dev/bus/usb/001/002\nE: DEVTYPE=usb_device\nA: bConfigurationValue=1\\n\nA: "
         "busnum=1\\n\n"
         "A: devnum=2\\n\nA: speed=12\\n\nH: descriptors=" +
         hex + "\n";
}

usbdevfs_urb& urbOf(UMockdevIoctlData* data)
{
  return *reinterpret_cast<usbdevfs_urb*>(data->data);
}

} // namespace

UsbTestbed::UsbTestbed(std::shared_ptr<UsbDeviceModel> model)
  : m_model(std::move(model)), m_bed(umockdev_testbed_new()), m_handler(umockdev_ioctl_base_new())
{
  g_signal_connect(m_handler, "handle-ioctl", G_CALLBACK(onIoctl), this);
}

UsbTestbed::~UsbTestbed()
{
  for (auto* list : {&m_underWay, &m_ended})
    for (UMockdevIoctlData* urb : *list) umockdev_ioctl_data_unref(urb);
  g_object_unref(m_handler);
  g_object_unref(m_bed);
}

double UsbTestbed::now() const
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
}

void UsbTestbed::plugIn()
{
  {
    const std::lock_guard lock(m_mutex);
    m_plugged = true;
    m_claimed = false;
  }
  umockdev_testbed_attach_ioctl(m_bed, kNode, m_handler,
                                nullptr); // before the news of it: it is opened at once
  umockdev_testbed_add_from_string(m_bed, describe(*m_model).c_str(), nullptr);
}

void UsbTestbed::unplug()
{
  {
    const std::lock_guard lock(m_mutex);
    m_plugged = false;
  }
  umockdev_testbed_uevent(m_bed, kPlace, "remove");
  umockdev_testbed_remove_device(m_bed, kPlace);
  umockdev_testbed_detach_ioctl(m_bed, kNode, nullptr);
}

bool UsbTestbed::claimed() const
{
  const std::lock_guard lock(m_mutex);
  return m_claimed;
}

void UsbTestbed::setMute(bool mute)
{
  const std::lock_guard lock(m_mutex);
  m_mute = mute;
}

gboolean UsbTestbed::onIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self)
{
  return static_cast<UsbTestbed*>(self)->answer(client) ? TRUE : FALSE;
}

bool UsbTestbed::answer(UMockdevIoctlClient* client)
{
  const std::lock_guard lock(m_mutex);
  UMockdevIoctlData* argument = umockdev_ioctl_client_get_arg(client);
  switch (umockdev_ioctl_client_get_request(client)) {
  case USBDEVFS_GET_CAPABILITIES: {
    UMockdevIoctlData* word = umockdev_ioctl_data_resolve(argument, 0, sizeof(guint32), nullptr);
    *reinterpret_cast<guint32*>(word->data) =
      USBDEVFS_CAP_NO_PACKET_SIZE_LIM | USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
    umockdev_ioctl_data_unref(word);
    umockdev_ioctl_client_complete(client, 0, 0);
    break;
  }
  case USBDEVFS_CLAIMINTERFACE:
  case USBDEVFS_DISCONNECT_CLAIM:
    m_claimed = true;
    umockdev_ioctl_client_complete(client, 0, 0);
    break;
  case USBDEVFS_RELEASEINTERFACE:
    m_claimed = false;
    umockdev_ioctl_client_complete(client, 0, 0);
    break;
  case USBDEVFS_GETDRIVER:
    umockdev_ioctl_client_complete(client, -1, ENODATA);
    break;
  case USBDEVFS_IOCTL: // give back to a kernel driver: there is none
  case USBDEVFS_CLEAR_HALT:
    umockdev_ioctl_client_complete(client, 0, 0);
    break;
  case USBDEVFS_SUBMITURB:
    submit(client, argument);
    break;
  case USBDEVFS_REAPURB:
  case USBDEVFS_REAPURBNDELAY:
    reap(client, argument);
    break;
  case USBDEVFS_DISCARDURB:
    discard(client, argument);
    break;
  default:
    return false;
  }
  return true;
}

void UsbTestbed::submit(UMockdevIoctlClient* client, UMockdevIoctlData* argument)
{
  if (!m_plugged) return umockdev_ioctl_client_complete(client, -1, ENODEV);
  UMockdevIoctlData* urb = umockdev_ioctl_data_resolve(argument, 0, sizeof(usbdevfs_urb), nullptr);
  UMockdevIoctlData* buffer = umockdev_ioctl_data_resolve(
    urb, offsetof(usbdevfs_urb, buffer), static_cast<gsize>(urbOf(urb).buffer_length), nullptr);
  umockdev_ioctl_data_unref(buffer); // its parent keeps it
  m_underWay.push_back(urb);
  umockdev_ioctl_client_complete(client, 0, 0);
}

bool UsbTestbed::work(UMockdevIoctlData* data)
{
  usbdevfs_urb& urb = urbOf(data);
  const std::span bytes(static_cast<std::uint8_t*>(urb.buffer), static_cast<std::size_t>(urb.buffer_length));
  int moved = 0;
  if (urb.type == USBDEVFS_URB_TYPE_CONTROL) {
    const std::uint8_t* s = bytes.data();
    const UsbSetup setup{s[0], s[1], getLe16(s + 2), getLe16(s + 4), getLe16(s + 6)};
    moved = m_model->control(setup, bytes.subspan(8));
  } else if ((urb.endpoint & 0x80) != 0) {
    moved = m_model->in(bytes);
    if (moved == UsbDeviceModel::kNothingYet) return false;
  } else {
    moved = m_model->out(bytes) ? urb.buffer_length : UsbDeviceModel::kStall;
  }
  urb.status = moved < 0 ? -EPIPE : 0;
  urb.actual_length = std::max(moved, 0);
  return true;
}

void UsbTestbed::reap(UMockdevIoctlClient* client, UMockdevIoctlData* argument)
{
  m_model->advance(now());
  for (auto it = m_underWay.begin(); m_ended.empty() && it != m_underWay.end(); ++it) {
    const bool gone = !m_plugged;
    if (gone)
      urbOf(*it).status = -ESHUTDOWN;
    else if (m_mute || !work(*it))
      continue;
    m_ended.push_back(*it);
    m_underWay.erase(it);
    break;
  }
  if (m_ended.empty()) return umockdev_ioctl_client_complete(client, -1, m_plugged ? EAGAIN : ENODEV);
  UMockdevIoctlData* urb = m_ended.front();
  m_ended.pop_front();
  UMockdevIoctlData* place = umockdev_ioctl_data_resolve(argument, 0, sizeof(gpointer), nullptr);
  umockdev_ioctl_data_set_ptr(place, 0, urb);
  umockdev_ioctl_client_complete(client, 0, 0);
  umockdev_ioctl_data_unref(place);
  umockdev_ioctl_data_unref(urb);
}

void UsbTestbed::discard(UMockdevIoctlClient* client, UMockdevIoctlData* argument)
{
  const gulong wanted = *reinterpret_cast<gulong*>(argument->data);
  const auto found =
    std::find_if(m_underWay.begin(), m_underWay.end(),
                 [wanted](const UMockdevIoctlData* urb) { return urb->client_addr == wanted; });
  if (found == m_underWay.end()) return umockdev_ioctl_client_complete(client, -1, EINVAL);
  urbOf(*found).status = -ENOENT;
  m_ended.push_back(*found);
  m_underWay.erase(found);
  umockdev_ioctl_client_complete(client, 0, 0);
}

} // namespace esm
