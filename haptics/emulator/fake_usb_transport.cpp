// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/emulator/fake_usb_transport.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace esm {

/// What the transport and its handles share.
struct FakeUsbTransport::Bus {
  std::mutex mutex;
  std::shared_ptr<UsbDeviceModel> model;
  bool plugged = true, mute = false, permitted = true;
  double latency = 0.0;
  std::optional<std::size_t> corrupt;
  std::uint32_t generation = 0; ///< a handle of an older one is lost
};

namespace {

using Bus = FakeUsbTransport::Bus;

class FakeHandle final : public UsbHandle {
public:
  FakeHandle(std::shared_ptr<Bus> bus, Wakeup& wakeup)
    : m_bus(std::move(bus)), m_wakeup(wakeup), m_generation(m_bus->generation)
  {}

  UsbOutcome control(const UsbSetup& setup, std::span<std::uint8_t> data) noexcept override
  {
    const std::lock_guard lock(m_bus->mutex);
    if (gone()) return {UsbStatus::Lost, 0};
    if (m_bus->mute) return {UsbStatus::TimedOut, 0};
    const int moved = m_bus->model->control(setup, data);
    if (moved < 0) return {UsbStatus::Stalled, 0};
    return {UsbStatus::Ok, static_cast<std::size_t>(moved)};
  }

  bool submitOut(std::span<const std::uint8_t> bytes) noexcept override
  {
    const std::lock_guard lock(m_bus->mutex);
    if (gone() || m_outDone == kMostUnderWay) return false;
    if (m_bus->mute) {
      m_swallowed = std::min(m_swallowed + 1, kMostUnderWay);
      return m_swallowed < kMostUnderWay;
    }
    m_swallowed = 0;
    m_outStatus[m_outDone++] = m_bus->model->out(bytes) ? UsbStatus::Ok : UsbStatus::Stalled;
    m_wakeup.post();
    return true;
  }

  bool sendAtLast(const UsbSetup& setup, std::span<const std::uint8_t> bytes) noexcept override
  {
    const std::unique_lock lock(m_bus->mutex, std::try_to_lock);
    if (!lock || gone() || m_bus->mute) return false;
    if (endpoints().out != 0) return m_bus->model->out(bytes);
    std::array<std::uint8_t, UsbCompletion::kMostBytes> data{};
    std::copy(bytes.begin(), bytes.end(), data.begin());
    return m_bus->model->control(setup, {data.data(), bytes.size()}) >= 0;
  }

  bool submitIn(std::size_t bytes) noexcept override
  {
    const std::lock_guard lock(m_bus->mutex);
    if (gone() || m_inPending == kMostUnderWay || bytes > UsbCompletion::kMostBytes) return false;
    m_inSize[m_inPending++] = bytes;
    return true;
  }

  bool take(double now, UsbCompletion& completion) noexcept override
  {
    const std::lock_guard lock(m_bus->mutex);
    if (gone()) return takeLost(completion);
    m_bus->model->advance(now);
    if (m_outDone > 0) {
      completion.status = m_outStatus[0];
      completion.endpoint = endpoints().out;
      completion.length = 0;
      std::shift_left(m_outStatus.begin(), m_outStatus.end(), 1);
      --m_outDone;
      return true;
    }
    if (m_bus->mute || m_inPending == 0) return false;
    if (!m_held) {
      const int moved = m_bus->model->in({m_bytes.data(), m_inSize[0]});
      if (moved == UsbDeviceModel::kNothingYet) return false;
      m_length = moved;
      m_held = true;
      m_dueAt = now + m_bus->latency;
    }
    if (now < m_dueAt) return false;
    m_held = false;
    std::shift_left(m_inSize.begin(), m_inSize.end(), 1);
    --m_inPending;
    completion.endpoint = endpoints().in;
    completion.status = m_length < 0 ? UsbStatus::Stalled : UsbStatus::Ok;
    completion.length = m_length < 0 ? 0 : static_cast<std::size_t>(m_length);
    std::copy_n(m_bytes.begin(), completion.length, completion.bytes.begin());
    if (m_bus->corrupt && *m_bus->corrupt < completion.length) {
      completion.bytes[*m_bus->corrupt] = static_cast<std::uint8_t>(completion.bytes[*m_bus->corrupt] ^ 0x15);
      m_bus->corrupt.reset();
    }
    return true;
  }

  UsbEndpoints endpoints() const noexcept override
  {
    const UsbDeviceModel::Identity& id = m_bus->model->identity();
    return {id.endpointIn, id.noOutEndpoint ? std::uint8_t{0} : id.endpointOut};
  }

  bool lost() const noexcept override
  {
    const std::lock_guard lock(m_bus->mutex);
    return gone();
  }

private:
  static constexpr std::size_t kMostUnderWay = 16;

  bool gone() const noexcept { return !m_bus->plugged || m_bus->generation != m_generation; }

  bool takeLost(UsbCompletion& completion) noexcept
  {
    if (m_inPending + m_outDone == 0) return false;
    completion.status = UsbStatus::Lost;
    completion.endpoint = m_inPending > 0 ? endpoints().in : endpoints().out;
    completion.length = 0;
    --(m_inPending > 0 ? m_inPending : m_outDone);
    return true;
  }

  std::shared_ptr<Bus> m_bus;
  Wakeup& m_wakeup;
  std::uint32_t m_generation;
  std::array<UsbStatus, kMostUnderWay> m_outStatus{};
  std::array<std::size_t, kMostUnderWay> m_inSize{};
  std::size_t m_outDone = 0, m_inPending = 0, m_swallowed = 0;
  std::array<std::uint8_t, UsbCompletion::kMostBytes> m_bytes{};
  int m_length = 0;
  bool m_held = false;
  double m_dueAt = 0.0;
};

} // namespace

FakeUsbTransport::FakeUsbTransport(std::shared_ptr<UsbDeviceModel> model) : m_bus(std::make_shared<Bus>())
{
  m_bus->model = std::move(model);
}

std::vector<UsbDeviceInfo> FakeUsbTransport::list()
{
  const std::lock_guard lock(m_bus->mutex);
  if (!m_bus->plugged) return {};
  const UsbDeviceModel::Identity& id = m_bus->model->identity();
  return {{id.vendor, id.product, 1, static_cast<std::uint8_t>(2 + m_bus->generation),
           id.hidDescriptor.empty() ? -1 : 0, mentionsForceFeedback(id.hidDescriptor), m_bus->permitted}};
}

Result<std::unique_ptr<UsbHandle>> FakeUsbTransport::open(const UsbDeviceInfo& device, int, Wakeup& wakeup)
{
  const std::lock_guard lock(m_bus->mutex);
  if (!m_bus->plugged) return Error{ErrorCode::NoDevice, "The device is no longer plugged in"};
  if (!m_bus->permitted)
    return Error{ErrorCode::NoDevice, "You are not permitted to use the device; this udev rule permits it: " +
                                        udevRule(device.vendor, device.product)};
  return std::unique_ptr<UsbHandle>(std::make_unique<FakeHandle>(m_bus, wakeup));
}

std::uint32_t FakeUsbTransport::changes() const noexcept
{
  const std::lock_guard lock(m_bus->mutex);
  return 2 * m_bus->generation + (m_bus->plugged ? 0 : 1);
}

void FakeUsbTransport::unplug()
{
  const std::lock_guard lock(m_bus->mutex);
  m_bus->plugged = false;
}

void FakeUsbTransport::plugIn()
{
  const std::lock_guard lock(m_bus->mutex);
  m_bus->plugged = true;
  ++m_bus->generation;
}

void FakeUsbTransport::setMute(bool mute)
{
  const std::lock_guard lock(m_bus->mutex);
  m_bus->mute = mute;
}

void FakeUsbTransport::setPermitted(bool permitted)
{
  const std::lock_guard lock(m_bus->mutex);
  m_bus->permitted = permitted;
}

void FakeUsbTransport::corruptNext(std::size_t byte)
{
  const std::lock_guard lock(m_bus->mutex);
  m_bus->corrupt = byte;
}

void FakeUsbTransport::setLatency(double seconds)
{
  const std::lock_guard lock(m_bus->mutex);
  m_bus->latency = seconds;
}

} // namespace esm
