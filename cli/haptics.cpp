// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/haptics.h"

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/output_files.h"
#include "core/base/json_line.h"
#include "core/base/text_number.h"
#include "haptics/device_registry.h"
#include "haptics/selftest/selftest.h"

#include <algorithm>

namespace esm::cli {

namespace {

std::string padded(std::string text, std::size_t width)
{
  text.resize(std::max(width, text.size()), ' ');
  return text;
}

Exit list(const DeviceOptions& options, bool json)
{
  std::vector<JsonLine> devices;
  for (const DeviceListing& device : listDevices(options)) {
    JsonLine line;
    line.add("name", device.name);
    line.add("description", device.description);
    line.add("usable", device.usable);
    line.add("reason", device.reason);
    line.add("details", device.details);
    line.add("udev_rule", device.udevRule);
    devices.push_back(line);
    if (json) continue;
    print(padded(device.name, 22) + (device.usable ? "ready" : device.reason));
    if (!device.details.empty()) print(padded("", 22) + device.details);
    if (!device.udevRule.empty())
      print(padded("", 22) + "rule for /etc/udev/rules.d/70-esm-haptics.rules: " + device.udevRule);
  }
  if (!json) return Exit::Done;
  JsonLine all;
  all.add("devices", devices);
  print(all.text());
  return Exit::Done;
}

/// A USB device need not be there to be told of.
Result<DeviceProfile> profileOf(const std::string& name, const DeviceOptions& options)
{
  for (const DeviceKind& kind : deviceKinds())
    if (kind.usb && kind.name == name) {
      const Result<DriverProfile> profile = loadProfile(name, options);
      if (!profile) return profile.error();
      return profile->device;
    }
  const Result<std::unique_ptr<HapticDevice>> device = openDevice(name, options);
  if (!device) return device.error();
  return (*device)->profile();
}

Exit info(const std::string& name, const DeviceOptions& options, bool json)
{
  const Result<DeviceProfile> found = profileOf(name, options);
  if (!found) return fail(found.error());
  const DeviceProfile& profile = *found;
  std::string details;
  for (const DeviceListing& device : listDevices(options))
    if (device.name == name) details = device.details;
  const struct {
    const char* key;
    const char* what;
    double value;
    const char* unit;
  } lines[] = {{"max_force", "largest force", profile.maxForce, "N"},
               {"max_stiffness", "largest stiffness", profile.maxStiffness, "N/m"},
               {"max_damping", "largest damping", profile.maxDamping, "N s/m"},
               {"own_damping", "damping of the mechanism", profile.ownDamping, "N s/m"},
               {"delay", "delay", profile.delay, "s"},
               {"period", "tick", profile.period, "s"},
               {"arm_time", "force fades in over", profile.armTime, "s"}};
  JsonLine line;
  line.add("name", profile.name);
  line.add("details", details);
  for (const auto& entry : lines) line.add(entry.key, entry.value);
  if (json) {
    print(line.text());
    return Exit::Done;
  }
  print(profile.name);
  for (const auto& entry : lines)
    print("  " + padded(entry.what, 26) + formatDouble(entry.value) + " " + entry.unit);
  if (!details.empty()) print("  " + details);
  return Exit::Done;
}

std::string rangeText(const SelftestRow& row)
{
  if (row.most > 1e300) return ">= " + formatDouble(row.least, 3);
  if (row.least == 0.0) return "<= " + formatDouble(row.most, 4);
  return formatDouble(row.least, 3) + " ... " + formatDouble(row.most, 4);
}

Exit selftest(bool json)
{
  const std::vector<SelftestRow> rows = runSelftest();
  const auto bad = std::count_if(rows.begin(), rows.end(), [](const SelftestRow& r) { return !r.good(); });
  std::vector<JsonLine> lines;
  for (const SelftestRow& row : rows) {
    JsonLine line;
    line.add("id", row.id);
    line.add("what", row.what);
    line.add("figure", row.figure);
    line.add("least", row.least);
    line.add("most", row.most);
    line.add("unit", row.unit);
    line.add("good", row.good());
    lines.push_back(line);
    if (!json)
      print(row.id + "  " + (row.good() ? "good  " : "BAD   ") + padded(row.what, 76) +
            padded(formatDouble(row.figure, 4) + " " + row.unit, 16) + "(" + rangeText(row) + ")");
  }
  if (json) {
    JsonLine all;
    all.add("good", bad == 0);
    all.add("rows", lines);
    print(all.text());
  }
  if (bad == 0) return Exit::Done;
  say(std::to_string(bad) + " of " + std::to_string(rows.size()) +
      " figures are out of their range; do not use force with this build");
  return Exit::Numerics;
}

void addRunOptions(CLI::App& command, HapticRunOptions& options)
{
  addNumber(command, "--seconds", options.seconds, "how long [s]", NumberRange::Positive);
  addJsonFlag(command, options.json);
}

void addTissueOptions(CLI::App& command, HapticRunOptions& options)
{
  addNumber(command, "--force-limit", options.forceLimit, "largest force [N] (default: 5)",
            NumberRange::Positive);
  addNumber(command, "--gain", options.gain, "force felt over force of the tissue (default: 1)",
            NumberRange::NotNegative);
  addNumber(command, "--frames", options.frameRate, "frames of the simulation per second (default: 60)",
            NumberRange::Positive);
  addInteger(command, "--node", options.node,
             "hold this node and what is within 8 mm of it instead of touching the surface", 0, 1 << 30);
  command.add_option(
    "--csv", options.csv,
    "what came to pass, tick by tick, written meanwhile: t, position, velocity, force, work, "
    "lateness");
}

} // namespace

void addHaptics(CLI::App& program, Work& work)
{
  CLI::App* haptics = program.add_subcommand("haptics", "Force-feedback devices: what is there, run, test");
  haptics->require_subcommand(1);
  auto options = std::make_shared<HapticRunOptions>();
  const auto device = [&](CLI::App& command) {
    command.add_option("--device", options->device, "a name of `esm haptics list` (default: simulated)")
      ->type_name("NAME");
  };
  const auto own = [&](CLI::App& command) {
    command.add_option("--profile", options->own.profile, "JSON laid over the device's profile");
    command.add_option("--firmware", options->own.firmware, "image to upload (Falcon)");
    command.add_flag("--opt-in", options->own.optIn,
                     "yes, what carries these unregistered USB numbers is that device (WoodenHaptics)");
  };
  const auto run = [&](CLI::App* command, Exit (*task)(const HapticRunOptions&)) {
    command->callback([options, task, &work] {
      keepFilesApart(
        {options->project, options->path, options->own.profile.string(), options->own.firmware.string()},
        {options->csv, options->output});
      work = [options, task] { return task(*options); };
    });
  };

  CLI::App* command = haptics->add_subcommand("list", "Devices, and what stands in their way");
  own(*command);
  addJsonFlag(*command, options->json);
  run(command, [](const HapticRunOptions& o) { return list(o.own, o.json); });

  command = haptics->add_subcommand("info", "What a device can bear");
  device(*command);
  own(*command);
  addJsonFlag(*command, options->json);
  run(command, [](const HapticRunOptions& o) { return info(o.device, o.own, o.json); });

  command =
    haptics->add_subcommand("run", "Feel a net, or only see how even the ticks are; force with --arm");
  command->add_option("PROJECT", options->project, "net to touch; none: nothing to feel");
  device(*command);
  own(*command);
  addRunOptions(*command, *options);
  addTissueOptions(*command, *options);
  command->add_option("--path", options->path, "CSV that leads the hand on a simulated device");
  command->add_flag("--arm", options->arm, "let force flow; without it the device gets 0 N");
  run(command, runDevice);

  command = haptics->add_subcommand("record", "Write the way of the hand on a device");
  device(*command);
  own(*command);
  addRunOptions(*command, *options);
  command->add_option("-o,--output", options->output, "CSV: t [s], x, y, z [m]")->required();
  run(command, recordPath);

  command = haptics->add_subcommand(
    "replay", "Lead a device in the computer along a path; virtual time, equal results");
  command->add_option("PATH", options->path, "CSV: t [s], x, y, z [m]")->required();
  command->add_option("PROJECT", options->project, "net to touch")->required();
  addRunOptions(*command, *options);
  addTissueOptions(*command, *options);
  command
    ->add_option("--device", options->device, "simulated, or falcon: its emulated twin (default: simulated)")
    ->type_name("NAME");
  command->add_flag("--compare", options->compare,
                    "compute the force without frames, at 5 kHz, and say how far the felt one is from it");
  addNumber(*command, "--stop-simulation", options->stopAfter,
            "after this the simulation answers no more [s]: the force must fade", NumberRange::NotNegative);
  run(command, replayPath);

  command = haptics->add_subcommand("selftest", "Prove the force loop's promises on a virtual clock");
  addJsonFlag(*command, options->json);
  run(command, [](const HapticRunOptions& o) { return selftest(o.json); });
  haptics->footer("Example:\n  esm haptics selftest\n  esm haptics run uterus.esm --path hand.csv --arm "
                  "--seconds 5 --csv felt.csv");
}

} // namespace esm::cli
