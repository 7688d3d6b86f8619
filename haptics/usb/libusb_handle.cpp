// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/usb/libusb_bus.h"

#include <linux/usbdevice_fs.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include <sys/ioctl.h>

namespace esm {

namespace {

constexpr unsigned kControlTimeout = 250; ///< [ms]
constexpr unsigned kOutTimeout = 200;     ///< [ms]; drivers call a device silent long before
constexpr unsigned kLastTimeout = 20;     ///< [ms]
constexpr int kEndWaits = 1000;           ///< of 1 ms, for cancelled transfers to come back

/// libusb keeps the descriptor of a device file to itself, but the system tells: the last one of that name,
/// which is the one opened last.
int descriptorOf(libusb_device_handle* handle)
{
  namespace fs = std::filesystem;
  libusb_device* device = libusb_get_device(handle);
  std::array<char, 24> name{};
  std::snprintf(name.data(), name.size(), "/bus/usb/%03d/%03d", libusb_get_bus_number(device),
                libusb_get_device_address(device));
  int found = -1;
  std::error_code error;
  for (fs::directory_iterator at("/proc/self/fd", error), end; !error && at != end; at.increment(error)) {
    std::error_code noLink;
    if (!fs::read_symlink(at->path(), noLink).string().ends_with(name.data())) continue;
    const std::string number = at->path().filename().string();
    int descriptor = -1;
    std::from_chars(number.data(), number.data() + number.size(), descriptor);
    found = std::max(found, descriptor);
  }
  return found;
}

UsbStatus statusOf(libusb_transfer_status status) noexcept
{
  switch (status) {
  case LIBUSB_TRANSFER_COMPLETED:
    return UsbStatus::Ok;
  case LIBUSB_TRANSFER_TIMED_OUT:
    return UsbStatus::TimedOut;
  case LIBUSB_TRANSFER_STALL:
    return UsbStatus::Stalled;
  case LIBUSB_TRANSFER_CANCELLED:
    return UsbStatus::Cancelled;
  case LIBUSB_TRANSFER_NO_DEVICE:
    return UsbStatus::Lost;
  default:
    return UsbStatus::Failed;
  }
}

} // namespace

LibusbHandle::LibusbHandle(std::shared_ptr<LibusbTransport::Bus> bus, libusb_device_handle* device,
                           int interface, UsbEndpoints endpoints, bool interrupt, Wakeup& wakeup)
  : m_bus(std::move(bus)),
    m_device(device),
    m_interface(interface),
    m_endpoints(endpoints),
    m_descriptor(descriptorOf(device)),
    m_interrupt(interrupt),
    m_wakeup(wakeup),
    m_transfers(std::make_unique<std::array<Transfer, kTransfers>>())
{
  for (Transfer& transfer : *m_transfers) {
    transfer.owner = this;
    transfer.usb = libusb_alloc_transfer(0);
  }
  m_bus->add(this);
}

LibusbHandle::~LibusbHandle()
{
  m_bus->remove(this);
  for (Transfer& transfer : *m_transfers)
    if (transfer.phase.load(std::memory_order_acquire) == Phase::UnderWay)
      libusb_cancel_transfer(transfer.usb);
  for (int i = 0; i < kEndWaits && anyUnderWay(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const bool stuck = anyUnderWay();
  libusb_release_interface(m_device, m_interface);
  libusb_close(m_device);
  if (stuck) {
    m_transfers.release(); // the system may still write there: better lost than overwritten
    return;
  }
  for (Transfer& transfer : *m_transfers) libusb_free_transfer(transfer.usb);
}

bool LibusbHandle::anyUnderWay() const noexcept
{
  return m_callbacks.load(std::memory_order_acquire) != 0 ||
         std::any_of(m_transfers->begin(), m_transfers->end(), [](const Transfer& transfer) {
           return transfer.phase.load(std::memory_order_acquire) == Phase::UnderWay;
         });
}

void LibusbHandle::markLost() noexcept
{
  m_lost.store(true, std::memory_order_release);
  m_wakeup.post();
}

UsbOutcome LibusbHandle::control(const UsbSetup& setup, std::span<std::uint8_t> data) noexcept
{
  if (lost()) return {UsbStatus::Lost, 0};
  const auto size = static_cast<std::uint16_t>(std::min<std::size_t>(data.size(), setup.length));
  const int moved = libusb_control_transfer(m_device, setup.requestType, setup.request, setup.value,
                                            setup.index, data.data(), size, kControlTimeout);
  if (moved >= 0) return {UsbStatus::Ok, static_cast<std::size_t>(moved)};
  if (moved == LIBUSB_ERROR_NO_DEVICE) {
    markLost();
    return {UsbStatus::Lost, 0};
  }
  if (moved == LIBUSB_ERROR_PIPE) return {UsbStatus::Stalled, 0};
  return {moved == LIBUSB_ERROR_TIMEOUT ? UsbStatus::TimedOut : UsbStatus::Failed, 0};
}

bool LibusbHandle::submit(std::uint8_t endpoint, std::span<const std::uint8_t> out, std::size_t size,
                          unsigned timeout) noexcept
{
  if (lost() || endpoint == 0 || size > UsbCompletion::kMostBytes) return false;
  const auto free = std::find_if(m_transfers->begin(), m_transfers->end(), [](const Transfer& transfer) {
    return transfer.phase.load(std::memory_order_acquire) == Phase::Free;
  });
  if (free == m_transfers->end() || !free->usb) return false;
  std::copy(out.begin(), out.end(), free->bytes.begin());
  const auto length = static_cast<int>(size);
  if (m_interrupt)
    libusb_fill_interrupt_transfer(free->usb, m_device, endpoint, free->bytes.data(), length, onEnd, &*free,
                                   timeout);
  else
    libusb_fill_bulk_transfer(free->usb, m_device, endpoint, free->bytes.data(), length, onEnd, &*free,
                              timeout);
  free->phase.store(Phase::UnderWay, std::memory_order_release);
  const int code = libusb_submit_transfer(free->usb);
  if (code == LIBUSB_SUCCESS) return true;
  free->phase.store(Phase::Free, std::memory_order_release);
  if (code == LIBUSB_ERROR_NO_DEVICE) markLost();
  return false;
}

bool LibusbHandle::submitOut(std::span<const std::uint8_t> bytes) noexcept
{
  return submit(m_endpoints.out, bytes, bytes.size(), kOutTimeout);
}

bool LibusbHandle::submitIn(std::size_t bytes) noexcept
{
  return submit(m_endpoints.in, {}, bytes, 0);
}

/// Past libusb, whose locks the thread that dies may hold: the system queues it behind what is under way.
bool LibusbHandle::sendAtLast(const UsbSetup& setup, std::span<const std::uint8_t> bytes) noexcept
{
  if (m_descriptor < 0 || lost()) return false;
  std::array<std::uint8_t, UsbCompletion::kMostBytes> data{};
  if (bytes.size() > data.size()) return false;
  std::copy(bytes.begin(), bytes.end(), data.begin());
  if (m_endpoints.out != 0) { // an interrupt endpoint too
    usbdevfs_bulktransfer out{m_endpoints.out, static_cast<unsigned>(bytes.size()), kLastTimeout,
                              data.data()};
    return ioctl(m_descriptor, USBDEVFS_BULK, &out) >= 0;
  }
  usbdevfs_ctrltransfer control{
    setup.requestType, setup.request, setup.value, setup.index, static_cast<std::uint16_t>(bytes.size()),
    kLastTimeout,      data.data()};
  return ioctl(m_descriptor, USBDEVFS_CONTROL, &control) >= 0;
}

void LIBUSB_CALL LibusbHandle::onEnd(libusb_transfer* usb)
{
  auto* transfer = static_cast<Transfer*>(usb->user_data);
  LibusbHandle* self = transfer->owner;
  self->m_callbacks.fetch_add(1, std::memory_order_acq_rel);
  if (usb->status == LIBUSB_TRANSFER_NO_DEVICE) self->m_lost.store(true, std::memory_order_release);
  transfer->order.store(self->m_ended.fetch_add(1, std::memory_order_relaxed), std::memory_order_relaxed);
  transfer->phase.store(Phase::Ended, std::memory_order_release);
  self->m_wakeup.post();
  self->m_callbacks.fetch_sub(1, std::memory_order_acq_rel); // from here on the handle may go
}

bool LibusbHandle::take(double, UsbCompletion& completion) noexcept
{
  Transfer* first = nullptr;
  for (Transfer& transfer : *m_transfers) {
    if (transfer.phase.load(std::memory_order_acquire) != Phase::Ended) continue;
    if (!first ||
        transfer.order.load(std::memory_order_relaxed) < first->order.load(std::memory_order_relaxed))
      first = &transfer;
  }
  if (!first) return false;
  completion.status = statusOf(first->usb->status);
  completion.endpoint = first->usb->endpoint;
  completion.length = static_cast<std::size_t>(std::max(first->usb->actual_length, 0));
  std::copy_n(first->bytes.begin(), completion.length, completion.bytes.begin());
  first->phase.store(Phase::Free, std::memory_order_release);
  return true;
}

} // namespace esm
