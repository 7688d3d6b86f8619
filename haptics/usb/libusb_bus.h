// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/usb/libusb_transport.h"

#include <libusb-1.0/libusb.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace esm {

class LibusbHandle;

/// The libusb context with its event thread; transport and handles share it.
class LibusbTransport::Bus {
public:
  static Result<std::shared_ptr<Bus>> create();
  ~Bus();
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;

  libusb_context* context() const noexcept { return m_context; }
  std::uint32_t changes() const noexcept { return m_changes.load(std::memory_order_relaxed); }
  void add(LibusbHandle* handle);
  void remove(LibusbHandle* handle);

private:
  explicit Bus(libusb_context* context);
  static int LIBUSB_CALL onHotplug(libusb_context*, libusb_device* device, libusb_hotplug_event event,
                                   void* self);
  void run(const std::stop_token& stop) noexcept;
  void look() noexcept;
  void markLost(const libusb_device* device) noexcept;

  libusb_context* m_context;
  libusb_hotplug_callback_handle m_hotplug = 0;
  bool m_hasHotplug = false;
  std::atomic<std::uint32_t> m_changes{0};
  std::vector<std::uint64_t> m_seen; ///< without hotplug: what was there at the last look; event thread
  std::mutex m_mutex;                ///< of the list below
  std::vector<LibusbHandle*> m_handles;
  std::jthread m_thread;
};

/// One opened device. Each transfer has its own buffer for good; the event thread only notes that one has
/// ended.
class LibusbHandle final : public UsbHandle {
public:
  LibusbHandle(std::shared_ptr<LibusbTransport::Bus> bus, libusb_device_handle* device, int interface,
               UsbEndpoints endpoints, bool interrupt, Wakeup& wakeup);
  ~LibusbHandle() override;
  LibusbHandle(const LibusbHandle&) = delete;
  LibusbHandle& operator=(const LibusbHandle&) = delete;

  UsbOutcome control(const UsbSetup& setup, std::span<std::uint8_t> data) noexcept override;
  bool submitOut(std::span<const std::uint8_t> bytes) noexcept override;
  bool submitIn(std::size_t bytes) noexcept override;
  bool take(double now, UsbCompletion& completion) noexcept override;
  bool sendAtLast(const UsbSetup& setup, std::span<const std::uint8_t> bytes) noexcept override;
  UsbEndpoints endpoints() const noexcept override { return m_endpoints; }
  bool lost() const noexcept override { return m_lost.load(std::memory_order_acquire); }

  const libusb_device* device() const noexcept { return libusb_get_device(m_device); }
  void markLost() noexcept; ///< any thread

private:
  static constexpr std::size_t kTransfers = 16;
  enum class Phase : std::uint8_t { Free, UnderWay, Ended };
  struct Transfer {
    LibusbHandle* owner = nullptr;
    libusb_transfer* usb = nullptr;
    std::atomic<Phase> phase{Phase::Free};
    std::atomic<std::uint64_t> order{0}; ///< of ending
    std::array<std::uint8_t, UsbCompletion::kMostBytes> bytes{};
  };

  static void LIBUSB_CALL onEnd(libusb_transfer* usb);
  bool submit(std::uint8_t endpoint, std::span<const std::uint8_t> out, std::size_t size,
              unsigned timeout) noexcept;
  bool anyUnderWay() const noexcept;

  std::shared_ptr<LibusbTransport::Bus> m_bus;
  libusb_device_handle* m_device;
  int m_interface;
  UsbEndpoints m_endpoints;
  int m_descriptor; ///< libusb's own of the device file, for sendAtLast(); -1: not found
  bool m_interrupt;
  Wakeup& m_wakeup;
  std::atomic<bool> m_lost{false};
  std::atomic<std::uint64_t> m_ended{0};
  std::atomic<int> m_callbacks{0}; ///< running now
  std::unique_ptr<std::array<Transfer, kTransfers>> m_transfers;
};

} // namespace esm
