// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/protocol/pid_layout.h"

namespace esm::pid {

namespace {

using hid::Field;
using hid::ReportDescriptor;
using hid::ReportType;
using hid::Slot;
using hid::Usage;

constexpr Usage kX = 0x010030, kY = 0x010031, kSteering = 0x0200c8, kButtonPage = 0x090000;
constexpr Usage kByteCount = 0x01003b;
constexpr Usage kOrdinal1 = 0x0a0001, kOrdinal2 = 0x0a0002;

Slot slotOf(const ReportDescriptor& descriptor, const Field& field, std::size_t index) noexcept
{
  Slot slot;
  slot.type = field.type;
  slot.reportId = field.reportId;
  slot.bitSize = field.bitSize;
  slot.bit =
    static_cast<std::uint16_t>(field.bitOffset + index * field.bitSize + (descriptor.numbered() ? 8 : 0));
  slot.logicalMin = field.logicalMin;
  slot.logicalMax = field.logicalMax;
  slot.decimalExponent = field.hasUnit ? field.unitExponent : 0;
  return slot;
}

/// The value of this usage within a report of this usage, if the device has it.
Slot find(const ReportDescriptor& descriptor, ReportType type, Usage report, Usage value) noexcept
{
  for (const Field& field : descriptor.fields()) {
    if (field.type != type || field.constant || (report != 0 && !descriptor.within(field, report))) continue;
    const auto usages = descriptor.usages(field);
    for (std::size_t i = 0; i < usages.size() && i < field.count; ++i)
      if (usages[i] == value) return slotOf(descriptor, field, i);
  }
  return {};
}

/// A choice: an array field of which one entry, or the collection around it, is `value`.
Choice findChoice(const ReportDescriptor& descriptor, ReportType type, Usage report, Usage around) noexcept
{
  Choice choice;
  for (const Field& field : descriptor.fields()) {
    if (field.type != type || field.constant || !descriptor.within(field, report)) continue;
    if (!descriptor.within(field, around)) continue;
    const auto usages = descriptor.usages(field);
    if (field.variable && field.bitSize == 1) {
      choice.bits = true;
      for (std::size_t i = 0; i < usages.size() && i < field.count && choice.count < Choice::kMost; ++i) {
        choice.bitSlots[choice.count] = slotOf(descriptor, field, i);
        choice.usages[choice.count++] = usages[i];
      }
      choice.slot = choice.bitSlots[0];
    } else if (!choice.slot.present() && !usages.empty()) {
      choice.slot = slotOf(descriptor, field, 0);
      for (const Usage usage : usages)
        if (choice.count < Choice::kMost) choice.usages[choice.count++] = usage;
      return choice;
    }
  }
  return choice;
}

} // namespace

bool Choice::has(Usage usage) const noexcept
{
  for (std::size_t i = 0; i < count; ++i)
    if (usages[i] == usage) return true;
  return false;
}

bool Choice::put(std::span<std::uint8_t> report, Usage usage, bool fromOne) const noexcept
{
  for (std::size_t i = 0; i < count; ++i) {
    if (usages[i] != usage) continue;
    if (bits) {
      hid::putValue(report, bitSlots[i], 1);
      return true;
    }
    Slot wide = slot;
    const std::int64_t first = fromOne && slot.logicalMin == 0 ? 1 : slot.logicalMin;
    if (fromOne) ++wide.logicalMax;
    hid::putValue(report, wide, first + static_cast<std::int64_t>(i));
    return true;
  }
  return false;
}

Usage Choice::get(std::span<const std::uint8_t> report) const noexcept
{
  if (bits) {
    for (std::size_t i = 0; i < count; ++i)
      if (hid::getValue(report, bitSlots[i]) != 0) return usages[i];
    return 0;
  }
  const std::int64_t index = std::int64_t{hid::getValue(report, slot)} - slot.logicalMin;
  return index >= 0 && index < static_cast<std::int64_t>(count) ? usages[static_cast<std::size_t>(index)] : 0;
}

const char* Layout::find(const ReportDescriptor& d) noexcept
{
  *this = {};
  constexpr auto out = ReportType::Output, feature = ReportType::Feature;
  const auto slot = [&](ReportType type, std::uint32_t report, Usage value) {
    return pid::find(d, type, usage(report), value);
  };
  numbered = d.numbered();
  effect.block = slot(out, 0x21, usage(0x22));
  effect.duration = slot(out, 0x21, usage(0x50));
  effect.samplePeriod = slot(out, 0x21, usage(0x51));
  effect.gain = slot(out, 0x21, usage(0x52));
  effect.triggerButton = slot(out, 0x21, usage(0x53));
  effect.triggerRepeat = slot(out, 0x21, usage(0x54));
  effect.startDelay = slot(out, 0x21, usage(0xa7));
  effect.directionEnable = slot(out, 0x21, usage(0x56));
  effect.axisEnable = {slot(out, 0x21, kX), slot(out, 0x21, kY)};
  effect.direction = {slot(out, 0x21, kOrdinal1), slot(out, 0x21, kOrdinal2)};
  effect.type = findChoice(d, out, usage(0x21), usage(0x25));
  constant.block = slot(out, 0x73, usage(0x22));
  constant.magnitude = slot(out, 0x73, usage(0x70));
  operation.block = slot(out, 0x77, usage(0x22));
  operation.loops = slot(out, 0x77, usage(0x7c));
  operation.what = findChoice(d, out, usage(0x77), usage(0x78));
  blockFree = slot(out, 0x90, usage(0x22));
  deviceGain = slot(out, 0x7d, usage(0x7e));
  control = findChoice(d, out, usage(0x96), usage(0x96));
  if (control.count == 0) control = findChoice(d, out, usage(0x95), usage(0x95));
  create.type = findChoice(d, feature, usage(0xab), usage(0x25));
  create.bytes = slot(feature, 0xab, kByteCount);
  blockLoad.block = slot(feature, 0x89, usage(0x22));
  blockLoad.status = findChoice(d, feature, usage(0x89), usage(0x8b));
  axes[0] = pid::find(d, ReportType::Input, 0, kX);
  if (!axes[0].present()) axes[0] = pid::find(d, ReportType::Input, 0, kSteering);
  axes[1] = pid::find(d, ReportType::Input, 0, kY);
  for (std::uint32_t i = 0; i < buttons.size(); ++i)
    buttons[i] = pid::find(d, ReportType::Input, 0, kButtonPage + 1 + i);

  const auto bytes = [&](const Slot& any) {
    return any.present() ? d.reportBytes(any.type, any.reportId) : 0;
  };
  effectBytes = bytes(effect.block);
  constantBytes = bytes(constant.magnitude);
  operationBytes = bytes(operation.block);
  blockFreeBytes = bytes(blockFree);
  deviceGainBytes = bytes(deviceGain);
  controlBytes = bytes(control.slot);
  createBytes = bytes(create.type.slot);
  blockLoadBytes = bytes(blockLoad.block);

  if (!constant.block.present() || !constant.magnitude.present()) return "no constant force report";
  if (!effect.block.present() || !effect.type.has(usage(0x26))) return "no constant force effect";
  if (!operation.block.present() || !operation.what.has(usage(0x79))) return "no report to start an effect";
  if (!create.type.has(usage(0x26)) || !blockLoad.block.present()) return "no report to create an effect";
  if (!axes[0].present()) return "no axis";
  return nullptr;
}

} // namespace esm::pid
