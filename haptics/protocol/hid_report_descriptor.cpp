// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/protocol/hid_report_descriptor.h"

#include <algorithm>
#include <cmath>

namespace esm::hid {

namespace {

constexpr std::uint8_t kLongItem = 0xfe;
constexpr std::size_t kMostPushed = 8;
constexpr std::uint32_t kMostReportBits = 8 * (ReportDescriptor::kMostReportBytes - 1);

enum Main : std::uint8_t { kInput = 8, kOutput = 9, kCollection = 10, kFeature = 11, kEndCollection = 12 };
enum Global : std::uint8_t {
  kUsagePage = 0,
  kLogicalMin = 1,
  kLogicalMax = 2,
  kUnitExponent = 5,
  kUnit = 6,
  kReportSize = 7,
  kReportId = 8,
  kReportCount = 9,
  kPush = 10,
  kPop = 11
};
enum Local : std::uint8_t { kUsage = 0, kUsageMin = 1, kUsageMax = 2 };

struct Globals {
  std::uint32_t usagePage = 0, size = 0, count = 0, unit = 0;
  std::int32_t logicalMin = 0, logicalMax = 0;
  std::uint32_t logicalMaxUnsigned = 0;
  std::int8_t exponent = 0;
  std::uint8_t reportId = 0;
};

struct Item {
  std::uint8_t kind = 0, tag = 0; ///< kind: 0 main, 1 global, 2 local
  std::size_t size = 0;
  std::uint32_t value = 0;

  std::int32_t signedValue() const noexcept
  {
    if (size == 1) return static_cast<std::int8_t>(value);
    if (size == 2) return static_cast<std::int16_t>(value);
    return static_cast<std::int32_t>(value);
  }
};

} // namespace

/// Walks through the items, with the state that the format asks for: globals with a stack, locals until the
/// next main item.
class DescriptorReader {
public:
  DescriptorReader(ReportDescriptor& out, std::span<const std::uint8_t> bytes) noexcept
    : m_out(out), m_bytes(bytes)
  {}

  Flaw read() noexcept
  {
    while (m_at < m_bytes.size()) {
      Item item;
      if (!nextItem(item)) return Flaw::Truncated;
      const Flaw flaw = item.kind == 0 ? main(item) : item.kind == 1 ? global(item) : local(item);
      if (flaw != Flaw::None) return flaw;
    }
    return m_depth == 0 ? Flaw::None : Flaw::UnbalancedCollection;
  }

private:
  bool nextItem(Item& item) noexcept
  {
    const std::uint8_t prefix = m_bytes[m_at++];
    if (prefix == kLongItem) { // reserved by the standard, to be skipped
      if (m_bytes.size() - m_at < 2 || m_bytes.size() - m_at - 2 < m_bytes[m_at]) return false;
      m_at += 2u + m_bytes[m_at];
      item.kind = 2;
      item.tag = 0xff;
      return true;
    }
    item.size = (prefix & 3) == 3 ? 4 : prefix & 3;
    item.kind = prefix >> 2 & 3;
    item.tag = prefix >> 4;
    if (m_bytes.size() - m_at < item.size) return false;
    for (std::size_t i = 0; i < item.size; ++i) item.value |= std::uint32_t{m_bytes[m_at + i]} << (8 * i);
    m_at += item.size;
    return true;
  }

  Flaw main(const Item& item) noexcept
  {
    Flaw flaw = Flaw::None;
    if (item.tag == kInput)
      flaw = addField(ReportType::Input, item.value);
    else if (item.tag == kOutput)
      flaw = addField(ReportType::Output, item.value);
    else if (item.tag == kFeature)
      flaw = addField(ReportType::Feature, item.value);
    else if (item.tag == kCollection)
      flaw = openCollection();
    else if (item.tag == kEndCollection)
      flaw = closeCollection();
    m_localCount = 0;
    m_hasUsageMin = m_hasUsageMax = false;
    return flaw;
  }

  Flaw openCollection() noexcept
  {
    if (m_out.m_collectionCount == ReportDescriptor::kMostCollections) return Flaw::TooMany;
    const auto index = static_cast<std::uint8_t>(m_out.m_collectionCount++);
    const std::uint8_t parent = m_depth == 0 ? index : m_open;
    m_out.m_collections[index] = {m_localCount > 0 ? m_locals[0] : 0, parent};
    m_open = index;
    ++m_depth;
    return Flaw::None;
  }

  Flaw closeCollection() noexcept
  {
    if (m_depth == 0) return Flaw::UnbalancedCollection;
    --m_depth;
    m_open = m_out.m_collections[m_open].parent;
    return Flaw::None;
  }

  Flaw addField(ReportType type, std::uint32_t flags) noexcept
  {
    const Globals& g = m_globals;
    if (g.count == 0 || g.size == 0) return Flaw::None;
    if (m_depth == 0) return Flaw::UnbalancedCollection;
    if (g.size > 32 && (flags & 1) == 0) return Flaw::BadSize;
    if (g.size > kMostReportBits || g.count > kMostReportBits) return Flaw::BadSize;
    std::uint16_t& used = m_out.m_reportBits[static_cast<std::size_t>(type)][g.reportId];
    if (used + g.size * g.count > kMostReportBits) return Flaw::BadSize;
    const std::uint16_t offset = used;
    used = static_cast<std::uint16_t>(used + g.size * g.count);
    if ((flags & 1) != 0 && m_localCount == 0 && !m_hasUsageMin) return Flaw::None; // padding
    if (m_out.m_fieldCount == ReportDescriptor::kMostFields) return Flaw::TooMany;
    Field& field = m_out.m_fields[m_out.m_fieldCount];
    field = {};
    field.type = type;
    field.reportId = g.reportId;
    field.collection = m_open;
    field.constant = (flags & 1) != 0;
    field.variable = (flags & 2) != 0;
    field.bitSize = static_cast<std::uint8_t>(std::min<std::uint32_t>(g.size, 32));
    field.unitExponent = g.exponent;
    field.hasUnit = g.unit != 0;
    field.bitOffset = offset;
    field.count = static_cast<std::uint16_t>(g.count);
    field.logicalMin = g.logicalMin;
    // "0 ... 255" is often written with one byte, which would read as -1.
    field.logicalMax =
      g.logicalMin >= 0 && g.logicalMax < g.logicalMin
        ? static_cast<std::int32_t>(std::min<std::uint32_t>(g.logicalMaxUnsigned, 0x7fffffff))
        : g.logicalMax;
    if (const Flaw flaw = addUsages(field); flaw != Flaw::None) return flaw;
    ++m_out.m_fieldCount;
    return Flaw::None;
  }

  Flaw addUsages(Field& field) noexcept
  {
    field.firstUsage = static_cast<std::uint16_t>(m_out.m_usageCount);
    for (std::size_t i = 0; i < m_localCount; ++i)
      if (!addUsage(m_locals[i])) return Flaw::TooMany;
    if (m_hasUsageMin && m_hasUsageMax && m_usageMax >= m_usageMin) {
      // A range of 65536 for 8 values names no more than 8.
      const std::uint32_t most =
        field.variable ? field.count : static_cast<std::uint32_t>(ReportDescriptor::kMostUsages);
      const std::uint32_t span = std::min(m_usageMax - m_usageMin, most);
      for (std::uint32_t i = 0; i <= span && i < most; ++i)
        if (!addUsage(m_usageMin + i)) return Flaw::TooMany;
    }
    field.usageCount = static_cast<std::uint16_t>(m_out.m_usageCount - field.firstUsage);
    return Flaw::None;
  }

  bool addUsage(Usage usage) noexcept
  {
    if (m_out.m_usageCount == ReportDescriptor::kMostUsages) return false;
    m_out.m_usages[m_out.m_usageCount++] = usage;
    return true;
  }

  Flaw global(const Item& item) noexcept
  {
    Globals& g = m_globals;
    switch (item.tag) {
    case kUsagePage:
      g.usagePage = item.value & 0xffff;
      break;
    case kLogicalMin:
      g.logicalMin = item.signedValue();
      break;
    case kLogicalMax:
      g.logicalMax = item.signedValue();
      g.logicalMaxUnsigned = item.value;
      break;
    case kUnitExponent: // usually a nibble, sometimes written as a signed byte
      g.exponent = static_cast<std::int8_t>(
        item.value <= 15 ? (item.value > 7 ? static_cast<int>(item.value) - 16 : static_cast<int>(item.value))
                         : std::clamp(item.signedValue(), -8, 7));
      break;
    case kUnit:
      g.unit = item.value;
      break;
    case kReportSize:
      g.size = item.value;
      break;
    case kReportId:
      g.reportId = static_cast<std::uint8_t>(item.value);
      m_out.m_numbered = true;
      break;
    case kReportCount:
      g.count = item.value;
      break;
    case kPush:
      if (m_pushed == kMostPushed) return Flaw::TooMany;
      m_stack[m_pushed++] = g;
      break;
    case kPop:
      if (m_pushed == 0) return Flaw::UnbalancedPush;
      g = m_stack[--m_pushed];
      break;
    default: // physical range and reserved ones
      break;
    }
    return Flaw::None;
  }

  Flaw local(const Item& item) noexcept
  {
    const Usage usage = item.size == 4 ? item.value : m_globals.usagePage << 16 | item.value;
    if (item.tag == kUsage) {
      if (m_localCount == m_locals.size()) return Flaw::TooMany;
      m_locals[m_localCount++] = usage;
    } else if (item.tag == kUsageMin) {
      m_usageMin = usage;
      m_hasUsageMin = true;
    } else if (item.tag == kUsageMax) {
      m_usageMax = usage;
      m_hasUsageMax = true;
    }
    return Flaw::None;
  }

  ReportDescriptor& m_out;
  std::span<const std::uint8_t> m_bytes;
  std::size_t m_at = 0;
  Globals m_globals;
  std::array<Globals, kMostPushed> m_stack;
  std::size_t m_pushed = 0;
  std::array<Usage, 128> m_locals{};
  std::size_t m_localCount = 0;
  Usage m_usageMin = 0, m_usageMax = 0;
  bool m_hasUsageMin = false, m_hasUsageMax = false;
  std::uint8_t m_open = 0; ///< innermost collection
  std::size_t m_depth = 0;
};

Flaw ReportDescriptor::parse(std::span<const std::uint8_t> bytes) noexcept
{
  m_fieldCount = m_usageCount = m_collectionCount = 0;
  m_numbered = false;
  for (auto& bits : m_reportBits) bits.fill(0);
  const Flaw flaw = DescriptorReader(*this, bytes).read();
  if (flaw != Flaw::None) m_fieldCount = 0;
  return flaw;
}

bool ReportDescriptor::within(const Field& field, Usage usage) const noexcept
{
  std::uint8_t index = field.collection;
  while (m_collections[index].usage != usage) {
    const std::uint8_t parent = m_collections[index].parent;
    if (parent == index) return false;
    index = parent;
  }
  return true;
}

std::size_t ReportDescriptor::reportBytes(ReportType type, std::uint8_t id) const noexcept
{
  const std::size_t bits = m_reportBits[static_cast<std::size_t>(type)][id];
  return bits == 0 ? 0 : (bits + 7) / 8 + (m_numbered ? 1 : 0);
}

std::int32_t getValue(std::span<const std::uint8_t> report, const Slot& slot) noexcept
{
  if (!slot.present() || std::size_t{slot.bit} + slot.bitSize > 8 * report.size()) return 0;
  std::uint32_t value = 0;
  for (unsigned i = 0; i < slot.bitSize; ++i) {
    const unsigned bit = slot.bit + i;
    value |= (unsigned{report[bit / 8]} >> (bit % 8) & 1u) << i;
  }
  if (slot.logicalMin < 0 && slot.bitSize < 32 && (value >> (slot.bitSize - 1) & 1) != 0)
    value |= ~0u << slot.bitSize;
  return static_cast<std::int32_t>(value);
}

void putValue(std::span<std::uint8_t> report, const Slot& slot, std::int64_t value) noexcept
{
  if (!slot.present() || std::size_t{slot.bit} + slot.bitSize > 8 * report.size()) return;
  if (slot.logicalMax > slot.logicalMin)
    value = std::clamp<std::int64_t>(value, slot.logicalMin, slot.logicalMax);
  const auto bits = static_cast<std::uint64_t>(value);
  for (unsigned i = 0; i < slot.bitSize; ++i) {
    const unsigned bit = slot.bit + i;
    const auto mask = static_cast<std::uint8_t>(1u << (bit % 8));
    if ((bits >> i & 1) != 0)
      report[bit / 8] |= mask;
    else
      report[bit / 8] &= static_cast<std::uint8_t>(~mask);
  }
}

std::int32_t scaled(const Slot& slot, double share) noexcept
{
  if (!(std::abs(share) <= 1.0)) share = share > 0.0 ? 1.0 : share < 0.0 ? -1.0 : 0.0;
  const double most = slot.logicalMax, least = slot.logicalMin;
  const double value = slot.logicalMin < 0 ? (share > 0.0 ? share * most : -share * least)
                                           : least + 0.5 * (1.0 + share) * (most - least);
  return static_cast<std::int32_t>(std::lround(value));
}

double centred(const Slot& slot, std::int32_t value) noexcept
{
  const double least = slot.logicalMin, span = static_cast<double>(slot.logicalMax) - least;
  if (!(span > 0.0)) return 0.0;
  return std::clamp(2.0 * (value - least) / span - 1.0, -1.0, 1.0);
}

} // namespace esm::hid
