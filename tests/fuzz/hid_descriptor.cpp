// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/protocol/pid_session.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace {

/// A device that takes all and answers with the bytes at hand.
class AnyPort final : public esm::pid::Port {
public:
  explicit AnyPort(std::span<const std::uint8_t> bytes) : m_bytes(bytes) {}
  bool output(std::span<const std::uint8_t> report) noexcept override { return !report.empty(); }
  bool setFeature(std::span<const std::uint8_t> report) noexcept override { return !report.empty(); }
  bool getFeature(std::uint8_t, std::span<std::uint8_t> report) noexcept override
  {
    std::copy_n(m_bytes.begin(), std::min(m_bytes.size(), report.size()), report.begin());
    return true;
  }

private:
  std::span<const std::uint8_t> m_bytes;
};

} // namespace

/// A device may describe itself as it likes: it is refused, or a whole session with it stays within its
/// reports.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace esm;
  static const auto descriptor = std::make_unique<hid::ReportDescriptor>();
  if (descriptor->parse({data, size}) != hid::Flaw::None) return 0;
  pid::Layout layout;
  if (layout.find(*descriptor)) return 0;
  AnyPort port({data, size});
  pid::Session session(layout, {}, port);
  if (!session.open(0.0))
    for (int i = 0; i < 20; ++i) session.setForce(0.01 * i, {0.1 * i - 1.0, 1.0 - 0.1 * i});
  session.close();
  return 0;
}
