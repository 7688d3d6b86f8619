// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/usb/libusb_transport.h"

#include "core/base/file_io.h"
#include "haptics/usb/libusb_bus.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include <unistd.h>

namespace esm {

namespace {

struct ConfigDeleter {
  void operator()(libusb_config_descriptor* config) const noexcept { libusb_free_config_descriptor(config); }
};
using Config = std::unique_ptr<libusb_config_descriptor, ConfigDeleter>;

Config configOf(libusb_device* device)
{
  libusb_config_descriptor* config = nullptr;
  if (libusb_get_active_config_descriptor(device, &config) != LIBUSB_SUCCESS &&
      libusb_get_config_descriptor(device, 0, &config) != LIBUSB_SUCCESS)
    return nullptr;
  return Config(config);
}

int firstHidInterface(const libusb_config_descriptor& config)
{
  for (int i = 0; i < config.bNumInterfaces; ++i)
    if (config.interface[i].num_altsetting > 0 &&
        config.interface[i].altsetting[0].bInterfaceClass == LIBUSB_CLASS_HID)
      return config.interface[i].altsetting[0].bInterfaceNumber;
  return -1;
}

/// The system shows the report descriptors of HID devices to everybody: no need to open a stranger's keyboard
/// to see that it has no motors.
bool showsForceFeedback(libusb_device* device, int interface)
{
  std::array<std::uint8_t, 8> ports{};
  const int depth = libusb_get_port_numbers(device, ports.data(), static_cast<int>(ports.size()));
  if (depth <= 0) return false;
  std::string name = std::to_string(libusb_get_bus_number(device)) + "-";
  for (int i = 0; i < depth; ++i) name += (i ? "." : "") + std::to_string(ports[static_cast<std::size_t>(i)]);
  const std::filesystem::path folder =
    std::filesystem::path("/sys/bus/usb/devices") / (name + ":1." + std::to_string(interface));
  std::error_code failed;
  for (const auto& entry : std::filesystem::directory_iterator(folder, failed)) {
    const auto path = entry.path() / "report_descriptor";
    if (!std::filesystem::exists(path, failed)) continue;
    const Result<std::string> bytes = readFile(path);
    if (bytes && mentionsForceFeedback({reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size()}))
      return true;
  }
  return false;
}

bool mayOpen(const UsbDeviceInfo& info)
{
  char path[40];
  std::snprintf(path, sizeof path, "/dev/bus/usb/%03u/%03u", unsigned{info.bus}, unsigned{info.address});
  return access(path, R_OK | W_OK) == 0;
}

UsbDeviceInfo describe(libusb_device* device, const libusb_device_descriptor& descriptor)
{
  UsbDeviceInfo info;
  info.vendor = descriptor.idVendor;
  info.product = descriptor.idProduct;
  info.bus = libusb_get_bus_number(device);
  info.address = libusb_get_device_address(device);
  if (const Config config = configOf(device)) info.hidInterface = firstHidInterface(*config);
  info.forceFeedback = info.hidInterface >= 0 && showsForceFeedback(device, info.hidInterface);
  info.permitted = mayOpen(info);
  return info;
}

/// The first endpoint of each direction that can carry our reports.
bool findEndpoints(libusb_device* device, int interface, UsbEndpoints& endpoints, bool& interrupt)
{
  const Config config = configOf(device);
  if (!config || interface >= config->bNumInterfaces) return false;
  const libusb_interface_descriptor& setting = config->interface[interface].altsetting[0];
  for (int i = 0; i < setting.bNumEndpoints; ++i) {
    const libusb_endpoint_descriptor& endpoint = setting.endpoint[i];
    const int kind = endpoint.bmAttributes & LIBUSB_TRANSFER_TYPE_MASK;
    if (kind != LIBUSB_TRANSFER_TYPE_BULK && kind != LIBUSB_TRANSFER_TYPE_INTERRUPT) continue;
    interrupt = kind == LIBUSB_TRANSFER_TYPE_INTERRUPT;
    std::uint8_t& place =
      (endpoint.bEndpointAddress & LIBUSB_ENDPOINT_IN) != 0 ? endpoints.in : endpoints.out;
    if (place == 0) place = endpoint.bEndpointAddress;
  }
  return endpoints.in != 0;
}

Error openingError(int code, const UsbDeviceInfo& info)
{
  char name[16];
  std::snprintf(name, sizeof name, "%04x:%04x", unsigned{info.vendor}, unsigned{info.product});
  const std::string device = std::string("The USB device ") + name;
  if (code == LIBUSB_ERROR_ACCESS)
    return {ErrorCode::NoDevice,
            device +
              " may not be used by you; put this line into /etc/udev/rules.d/70-esm-haptics.rules "
              "and plug the device out and in: " +
              udevRule(info.vendor, info.product)};
  if (code == LIBUSB_ERROR_BUSY)
    return {ErrorCode::NoDevice, device + " is in use by another program; close that one"};
  return {ErrorCode::NoDevice, device + " cannot be opened: " + libusb_strerror(code)};
}

/// Calls `see(device, descriptor)` for each device until it says true.
template <class See>
void forEachDevice(libusb_context* context, See see)
{
  libusb_device** devices = nullptr;
  const ssize_t count = libusb_get_device_list(context, &devices);
  for (ssize_t i = 0; i < count; ++i) {
    libusb_device_descriptor descriptor{};
    if (libusb_get_device_descriptor(devices[i], &descriptor) == LIBUSB_SUCCESS &&
        see(devices[i], descriptor))
      break;
  }
  if (count >= 0) libusb_free_device_list(devices, 1);
}

} // namespace

Result<std::unique_ptr<LibusbTransport>> LibusbTransport::create()
{
  auto bus = Bus::create();
  if (!bus) return bus.error();
  return std::unique_ptr<LibusbTransport>(new LibusbTransport(std::move(*bus)));
}

std::vector<UsbDeviceInfo> LibusbTransport::list()
{
  std::vector<UsbDeviceInfo> found;
  forEachDevice(m_bus->context(), [&](libusb_device* device, const libusb_device_descriptor& descriptor) {
    if (descriptor.bDeviceClass != LIBUSB_CLASS_HUB) found.push_back(describe(device, descriptor));
    return false;
  });
  return found;
}

Result<std::unique_ptr<UsbHandle>> LibusbTransport::open(const UsbDeviceInfo& info, int interface,
                                                         Wakeup& wakeup)
{
  libusb_device_handle* opened = nullptr;
  UsbEndpoints endpoints;
  bool interrupt = false, usable = false;
  int code = LIBUSB_ERROR_NO_DEVICE;
  forEachDevice(m_bus->context(), [&](libusb_device* device, const libusb_device_descriptor& descriptor) {
    if (libusb_get_bus_number(device) != info.bus || libusb_get_device_address(device) != info.address ||
        descriptor.idVendor != info.vendor || descriptor.idProduct != info.product)
      return false;
    usable = findEndpoints(device, interface, endpoints, interrupt);
    code = libusb_open(device, &opened);
    return true;
  });
  if (code != LIBUSB_SUCCESS) return openingError(code, info);
  libusb_set_auto_detach_kernel_driver(opened, 1);
  code = usable ? libusb_claim_interface(opened, interface) : LIBUSB_ERROR_NOT_FOUND;
  if (code != LIBUSB_SUCCESS) {
    libusb_close(opened);
    return openingError(code, info);
  }
  return std::unique_ptr<UsbHandle>(
    std::make_unique<LibusbHandle>(m_bus, opened, interface, endpoints, interrupt, wakeup));
}

std::uint32_t LibusbTransport::changes() const noexcept
{
  return m_bus->changes();
}

} // namespace esm
