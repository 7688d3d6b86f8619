// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

/// HID report descriptors: which bits of which report mean what (HID 1.11, section 6.2.2).
namespace esm::hid {

enum class ReportType : std::uint8_t { Input = 0, Output = 1, Feature = 2 };

/// Usage page in the upper, usage id in the lower half.
using Usage = std::uint32_t;

/// One main item: `count` values of `bitSize` bits each, from `bitOffset` on (the report id byte not
/// counted).
struct Field {
  ReportType type = ReportType::Input;
  std::uint8_t reportId = 0;
  std::uint8_t collection = 0; ///< index of the innermost
  bool constant = false;       ///< padding
  bool variable = false;       ///< one value per usage; else each value is an index into the usages
  std::uint8_t bitSize = 0;
  std::int8_t unitExponent = 0;
  bool hasUnit = false;
  std::uint16_t bitOffset = 0, count = 0;
  std::uint16_t firstUsage = 0, usageCount = 0; ///< into ReportDescriptor::usages()
  std::int32_t logicalMin = 0, logicalMax = 0;
};

struct Collection {
  Usage usage = 0;
  std::uint8_t parent = 0; ///< index; the first collection is the root and its own parent
};

enum class Flaw : std::uint8_t { None, Truncated, TooMany, UnbalancedCollection, UnbalancedPush, BadSize };

/// A parsed descriptor. Holds all its tables itself, sized for the largest force-feedback devices known (a
/// few hundred fields), so that no device can make it allocate.
/// @note Pure; any thread; tens of kilobytes, keep it off small stacks.
class ReportDescriptor {
public:
  static constexpr std::size_t kMostFields = 384, kMostUsages = 1024, kMostCollections = 128;
  static constexpr std::size_t kMostReportBytes = 256;

  /// @return None, or what is wrong; then nothing of it may be used.
  Flaw parse(std::span<const std::uint8_t> bytes) noexcept;

  std::span<const Field> fields() const noexcept { return {m_fields.data(), m_fieldCount}; }
  std::span<const Usage> usages(const Field& field) const noexcept
  {
    return {m_usages.data() + field.firstUsage, field.usageCount};
  }
  const Collection& collection(std::size_t index) const noexcept { return m_collections[index]; }
  /// Whether the field lies, at whatever depth, in a collection of this usage.
  bool within(const Field& field, Usage collection) const noexcept;
  /// The size of a report with its id byte, if the device numbers its reports; 0: no such report.
  std::size_t reportBytes(ReportType type, std::uint8_t id) const noexcept;
  bool numbered() const noexcept { return m_numbered; } ///< reports start with their id

private:
  friend class DescriptorReader;

  std::array<Field, kMostFields> m_fields{};
  std::array<Usage, kMostUsages> m_usages{};
  std::array<Collection, kMostCollections> m_collections{};
  std::array<std::array<std::uint16_t, 256>, 3> m_reportBits{};
  std::size_t m_fieldCount = 0, m_usageCount = 0, m_collectionCount = 0;
  bool m_numbered = false;
};

/// Where one value lies in a report; absent if bitSize is 0.
struct Slot {
  ReportType type = ReportType::Input;
  std::uint8_t reportId = 0, bitSize = 0;
  std::uint16_t bit = 0; ///< from the start of the report, id byte counted
  std::int32_t logicalMin = 0, logicalMax = 0;
  int decimalExponent = 0; ///< of the unit; 0 if there is none

  bool present() const noexcept { return bitSize != 0; }
};

/// Sign-extended if the slot's range has negative values; 0 beyond the end of the report.
std::int32_t getValue(std::span<const std::uint8_t> report, const Slot& slot) noexcept;
/// Clamped to the slot's range; nothing happens for an absent slot or beyond the end of the report.
void putValue(std::span<std::uint8_t> report, const Slot& slot, std::int64_t value) noexcept;
/// -1 ... 1 onto the slot's range, zero onto zero if it is a signed one.
std::int32_t scaled(const Slot& slot, double share) noexcept;
/// The reverse for inputs: logical range onto -1 ... 1.
double centred(const Slot& slot, std::int32_t value) noexcept;

} // namespace esm::hid
