// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
// esm-usbip-device: a haptic device in the computer, on the USB bus of any Linux machine.
//
//     esm-usbip-device falcon &          # listens on 127.0.0.1:3240
//     sudo modprobe vhci-hcd && sudo usbip attach -r 127.0.0.1 -b 1-1
#include "core/base/text_number.h"
#include "haptics/emulator/falcon_model.h"
#include "haptics/emulator/pid_model.h"
#include "haptics/emulator/usbip_server.h"
#include "haptics/emulator/wooden_model.h"
#include "haptics/servo_clock.h"

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

#include <arpa/inet.h>
#include <csignal>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace {

using namespace esm;

constexpr const char* kUsage =
  "usage: esm-usbip-device falcon|pid|wooden [--port N | --fd N | --vhci PORT] [--homed] [--image-size "
  "BYTES]\n"
  "  --port N        listen on 127.0.0.1:N (default 3240) for: usbip attach -r 127.0.0.1 -b 1-1\n"
  "  --fd N          speak on this socket, whose other end the kernel has\n"
  "  --vhci PORT     hand a socket to this machine's vhci-hcd (root)\n"
  "  --homed         falcon: firmware and home are there already\n"
  "  --image-size N  falcon: bytes of firmware it waits for (default 3000)\n";

struct Options {
  std::string kind;
  long long port = 3240, fd = -1, vhci = -1, imageSize = 3000;
  bool homed = false;
};

/// A hand that pulls the grip out and pushes it in, which homes a Falcon, and goes on so.
class RockingHand final : public Hand {
public:
  HandPose pose(double time) noexcept override
  {
    return {Eigen::Vector3d(0.0, 0.0, 0.045 * std::sin(std::numbers::pi * time)), Eigen::Vector3d::Zero(), 0};
  }
};

std::optional<Options> parse(int argc, char** argv)
{
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    long long* number = word == "--port"         ? &options.port
                        : word == "--fd"         ? &options.fd
                        : word == "--vhci"       ? &options.vhci
                        : word == "--image-size" ? &options.imageSize
                                                 : nullptr;
    if (number) {
      const auto value = i + 1 < argc ? parseInteger(argv[++i]) : std::nullopt;
      if (!value || *value < 0 || *value > 65535) return {};
      *number = *value;
    } else if (word == "--homed") {
      options.homed = true;
    } else if (options.kind.empty() && (word == "falcon" || word == "pid" || word == "wooden")) {
      options.kind = word;
    } else {
      return {};
    }
  }
  if (options.kind.empty()) return {};
  return options;
}

std::unique_ptr<UsbDeviceModel> makeModel(const Options& options)
{
  if (options.kind == "pid")
    return std::make_unique<PidModel>(PidModel::Settings{}, std::make_unique<RockingHand>());
  if (options.kind == "wooden")
    return std::make_unique<WoodenModel>(SimulatedDeviceSettings{}, std::make_unique<RockingHand>());
  FalconModel::Settings settings;
  settings.running = settings.homed = options.homed;
  settings.imageSize = static_cast<std::size_t>(options.imageSize);
  return std::make_unique<FalconModel>(settings, options.homed ? nullptr : std::make_unique<RockingHand>());
}

bool sendAll(int fd, std::vector<std::uint8_t>& bytes)
{
  std::size_t sent = 0;
  while (sent < bytes.size()) {
    const ssize_t count = send(fd, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (count <= 0) return false;
    sent += static_cast<std::size_t>(count);
  }
  bytes.clear();
  return true;
}

/// One connection to its end.
void serve(int fd, UsbDeviceModel& device, bool imported)
{
  UsbIpServer server(device, imported);
  SteadyClock clock;
  std::array<std::uint8_t, 16384> bytes{};
  for (;;) {
    pollfd waiting{fd, POLLIN, 0};
    poll(&waiting, 1, 1); // devices have timers of a millisecond
    server.advance(clock.now());
    if ((waiting.revents & (POLLIN | POLLHUP | POLLERR)) != 0) {
      const ssize_t count = recv(fd, bytes.data(), bytes.size(), 0);
      if (count <= 0) break;
      if (!server.receive({bytes.data(), static_cast<std::size_t>(count)})) {
        std::fputs("esm-usbip-device: what came is no USB/IP\n", stderr);
        break;
      }
    }
    if (!server.output().empty() && !sendAll(fd, server.output())) break;
  }
  close(fd);
}

/// What tests want to know in the end: whether the last the device heard was no force.
void report(const UsbDeviceModel& device)
{
  if (const auto* falcon = dynamic_cast<const FalconModel*>(&device))
    std::printf("falcon commands %llu zeros %d running %d\n",
                static_cast<unsigned long long>(falcon->commands()), falcon->zerosInRow(),
                falcon->running() ? 1 : 0);
  if (const auto* pid = dynamic_cast<const PidModel*>(&device))
    std::printf("pid reports %llu zeros %d effects %d enabled %d\n",
                static_cast<unsigned long long>(pid->reports()), pid->zerosInRow(), pid->effects(),
                pid->enabled() ? 1 : 0);
  if (const auto* wooden = dynamic_cast<const WoodenModel*>(&device))
    std::printf("wooden reports %llu zeros %d\n", static_cast<unsigned long long>(wooden->reports()),
                wooden->zerosInRow());
  std::fflush(stdout);
}

int attachHere(const Options& options, UsbDeviceModel& device)
{
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) return 1;
  std::ofstream attach("/sys/devices/platform/vhci_hcd.0/attach");
  // port, socket, device id (bus 1, number 2), full speed
  attach << options.vhci << ' ' << ends[1] << ' ' << (1 << 16 | 2) << ' ' << 2 << std::flush;
  if (!attach) {
    std::fputs(
      "esm-usbip-device: vhci-hcd did not take the device; is the module loaded, and are you root?\n",
      stderr);
    return 1;
  }
  close(ends[1]); // the kernel has it
  serve(ends[0], device, true);
  return 0;
}

int listenHere(const Options& options, UsbDeviceModel& device)
{
  const int listener = socket(AF_INET, SOCK_STREAM, 0);
  const int on = 1;
  setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<std::uint16_t>(options.port));
  if (bind(listener, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0 ||
      listen(listener, 1) != 0) {
    std::fprintf(stderr, "esm-usbip-device: 127.0.0.1:%lld cannot be listened on: %s\n", options.port,
                 std::strerror(errno));
    return 1;
  }
  std::printf("listening on 127.0.0.1:%lld, bus id 1-1\n", options.port);
  std::fflush(stdout);
  for (;;) {
    const int fd = accept(listener, nullptr, nullptr);
    if (fd < 0) return 1;
    setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    serve(fd, device, false);
    report(device);
  }
}

} // namespace

int main(int argc, char** argv)
{
  const auto options = parse(argc, argv);
  if (!options) {
    std::fputs(kUsage, stderr);
    return 2;
  }
  std::signal(SIGPIPE, SIG_IGN);
  const auto device = makeModel(*options);
  int code = 0;
  if (options->vhci >= 0)
    code = attachHere(*options, *device);
  else if (options->fd >= 0)
    serve(static_cast<int>(options->fd), *device, true);
  else
    code = listenHere(*options, *device);
  report(*device);
  return code;
}
