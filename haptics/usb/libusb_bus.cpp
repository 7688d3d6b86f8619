// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/usb/libusb_bus.h"

#include <algorithm>
#include <chrono>
#include <exception>

namespace esm {

namespace {

constexpr timeval kEventWait{0, 100000}; ///< [us]
constexpr auto kLookEvery = std::chrono::seconds(1);

/// One number for a device at its place on the bus.
std::uint64_t keyOf(libusb_device* device) noexcept
{
  libusb_device_descriptor descriptor{};
  libusb_get_device_descriptor(device, &descriptor);
  return std::uint64_t{libusb_get_bus_number(device)} << 40 |
         std::uint64_t{libusb_get_device_address(device)} << 32 | std::uint64_t{descriptor.idVendor} << 16 |
         descriptor.idProduct;
}

} // namespace

Result<std::shared_ptr<LibusbTransport::Bus>> LibusbTransport::Bus::create()
{
  libusb_context* context = nullptr;
  if (const int code = libusb_init(&context); code != LIBUSB_SUCCESS)
    return Error{ErrorCode::NoDevice, std::string("USB cannot be used here: ") + libusb_strerror(code)};
  try {
    return std::shared_ptr<Bus>(new Bus(context));
  } catch (const std::exception& trouble) {
    libusb_exit(context);
    return Error{ErrorCode::NoDevice, std::string("USB cannot be used here: ") + trouble.what()};
  }
}

LibusbTransport::Bus::Bus(libusb_context* context) : m_context(context)
{
  if (libusb_has_capability(LIBUSB_CAP_HAS_HOTPLUG) != 0) {
    const auto events = LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED | LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT;
    m_hasHotplug = libusb_hotplug_register_callback(m_context, events, 0, LIBUSB_HOTPLUG_MATCH_ANY,
                                                    LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY,
                                                    onHotplug, this, &m_hotplug) == LIBUSB_SUCCESS;
  }
  m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

LibusbTransport::Bus::~Bus()
{
  if (m_hasHotplug) libusb_hotplug_deregister_callback(m_context, m_hotplug);
  m_thread.request_stop();
  libusb_interrupt_event_handler(m_context);
  m_thread.join();
  libusb_exit(m_context);
}

void LibusbTransport::Bus::run(const std::stop_token& stop) noexcept
{
  auto lookAt = std::chrono::steady_clock::now();
  while (!stop.stop_requested()) {
    timeval wait = kEventWait;
    libusb_handle_events_timeout_completed(m_context, &wait, nullptr);
    if (m_hasHotplug || std::chrono::steady_clock::now() < lookAt) continue;
    lookAt = std::chrono::steady_clock::now() + kLookEvery;
    look();
  }
}

/// For systems that do not tell of changes.
void LibusbTransport::Bus::look() noexcept
{
  libusb_device** devices = nullptr;
  const ssize_t count = libusb_get_device_list(m_context, &devices);
  if (count < 0) return;
  std::vector<std::uint64_t> now;
  for (ssize_t i = 0; i < count; ++i) now.push_back(keyOf(devices[i]));
  std::sort(now.begin(), now.end());
  if (now != m_seen) {
    m_changes.fetch_add(1, std::memory_order_relaxed);
    const std::lock_guard lock(m_mutex);
    for (LibusbHandle* handle : m_handles) {
      const auto key = keyOf(const_cast<libusb_device*>(handle->device()));
      if (!std::binary_search(now.begin(), now.end(), key)) handle->markLost();
    }
    m_seen = std::move(now);
  }
  libusb_free_device_list(devices, 1);
}

int LIBUSB_CALL LibusbTransport::Bus::onHotplug(libusb_context*, libusb_device* device,
                                                libusb_hotplug_event event, void* self)
{
  auto* bus = static_cast<Bus*>(self);
  bus->m_changes.fetch_add(1, std::memory_order_relaxed);
  if (event == LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT) bus->markLost(device);
  return 0; // stay registered
}

void LibusbTransport::Bus::markLost(const libusb_device* device) noexcept
{
  const std::lock_guard lock(m_mutex);
  for (LibusbHandle* handle : m_handles)
    if (handle->device() == device) handle->markLost();
}

void LibusbTransport::Bus::add(LibusbHandle* handle)
{
  const std::lock_guard lock(m_mutex);
  m_handles.push_back(handle);
}

void LibusbTransport::Bus::remove(LibusbHandle* handle)
{
  const std::lock_guard lock(m_mutex);
  std::erase(m_handles, handle);
}

} // namespace esm
