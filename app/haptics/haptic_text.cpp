// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/haptics/haptic_text.h"

#include "app/text/reason_text.h"

#include <QCoreApplication>

#include <utility>

namespace esm {

namespace {

constexpr const char* kContext = "esm::HapticText";

constexpr KnownSentence kReasons[] = {
  // The servo
  {R"(The device does not know its position yet; move its grip out and in once)",
   QT_TRANSLATE_NOOP("esm::HapticText",
                     "The device does not know its position yet; move its grip out and in once")},
  {R"(Force waits until it would begin below 0\.2 N; move the tool away from the tissue)",
   QT_TRANSLATE_NOOP("esm::HapticText",
                     "Force waits until it would begin below 0.2 N; move the tool away from the tissue")},
  {"No tissue moves: there is no model, or the simulation is paused",
   QT_TRANSLATE_NOOP("esm::HapticText", "No tissue moves: there is no model, or the simulation is paused")},
  {"Nothing is touched or held", QT_TRANSLATE_NOOP("esm::HapticText", "Nothing is touched or held")},
  {"The simulation answers late: the force goes on by its last answer; a model with fewer nodes or a larger "
   "allowed error helps",
   QT_TRANSLATE_NOOP("esm::HapticText", "The simulation answers late: the force goes on by its last answer; "
                                        "a model with fewer nodes or a larger allowed error helps")},
  {"The simulation answers too late to be felt: the scene is too heavy for this computer; a model with fewer "
   "nodes or a larger allowed error helps; force comes back after five answers in time",
   QT_TRANSLATE_NOOP(
     "esm::HapticText",
     "The simulation answers too late to be felt: the scene is too heavy for this computer; a model with "
     "fewer nodes or a larger allowed error helps; force comes back after five answers in time")},
  {"Stopped by the user; arm again to go on",
   QT_TRANSLATE_NOOP("esm::HapticText", "Stopped by the user; arm again to go on")},
  {"The simulation sent a force that is not a number; reset it, then arm again",
   QT_TRANSLATE_NOOP("esm::HapticText",
                     "The simulation sent a force that is not a number; reset it, then arm again")},
  {"The force gave the hand more energy than the tissue holds; lower the gain or the stiffness, then arm "
   "again",
   QT_TRANSLATE_NOOP("esm::HapticText", "The force gave the hand more energy than the tissue holds; lower "
                                        "the gain or the stiffness, then arm again")},
  {"The device does not reply; check its cable, then arm again",
   QT_TRANSLATE_NOOP("esm::HapticText", "The device does not reply; check its cable, then arm again")},
  {"The device was unplugged; connect it and open it again",
   QT_TRANSLATE_NOOP("esm::HapticText", "The device was unplugged; connect it and open it again")},
  {"The device is closed", QT_TRANSLATE_NOOP("esm::HapticText", "The device is closed")},
  // The drivers
  {"Asking the device whether it runs already",
   QT_TRANSLATE_NOOP("esm::HapticText", "Asking the device whether it runs already")},
  {"Uploading the firmware", QT_TRANSLATE_NOOP("esm::HapticText", "Uploading the firmware")},
  {"Pull the grip all the way out, then push it all the way in",
   QT_TRANSLATE_NOOP("esm::HapticText", "Pull the grip all the way out, then push it all the way in")},
  {"Put the grip to its home position, then press Home",
   QT_TRANSLATE_NOOP("esm::HapticText", "Put the grip to its home position, then press Home")},
  {"The device was unplugged", QT_TRANSLATE_NOOP("esm::HapticText", "The device was unplugged")},
  {"The device refuses its serial settings; plug it out and in again",
   QT_TRANSLATE_NOOP("esm::HapticText", "The device refuses its serial settings; plug it out and in again")},
  {"The device took its firmware but does not answer; plug it out and in again",
   QT_TRANSLATE_NOOP("esm::HapticText",
                     "The device took its firmware but does not answer; plug it out and in again")},
  {"The device needs its firmware: name the file of it in the settings of the device",
   QT_TRANSLATE_NOOP("esm::HapticText",
                     "The device needs its firmware: name the file of it in the settings of the device")},
  {"The device does not take the firmware; switch it off and on, and check the file",
   QT_TRANSLATE_NOOP("esm::HapticText",
                     "The device does not take the firmware; switch it off and on, and check the file")},
  {"Reading what the device can do", QT_TRANSLATE_NOOP("esm::HapticText", "Reading what the device can do")},
  {"The device does not describe its reports",
   QT_TRANSLATE_NOOP("esm::HapticText", "The device does not describe its reports")},
  {"The device describes its reports in a way that makes no sense",
   QT_TRANSLATE_NOOP("esm::HapticText", "The device describes its reports in a way that makes no sense")},
  {"The device has no constant force that a program can set",
   QT_TRANSLATE_NOOP("esm::HapticText", "The device has no constant force that a program can set")},
  {"The device does not take a force effect",
   QT_TRANSLATE_NOOP("esm::HapticText", "The device does not take a force effect")},
  // The list
  {"Looking for it", QT_TRANSLATE_NOOP("esm::HapticText", "Looking for it")},
  {"Not plugged in", QT_TRANSLATE_NOOP("esm::HapticText", "Not plugged in")},
  {"No (.+) is plugged in", QT_TRANSLATE_NOOP("esm::HapticText", "No %1 is plugged in")},
  {"You are not permitted to use it; the udev rule permits it",
   QT_TRANSLATE_NOOP("esm::HapticText", "You are not permitted to use it; the udev rule permits it")},
  {"You are not permitted to use the device; this udev rule permits it: (.+)",
   QT_TRANSLATE_NOOP("esm::HapticText",
                     "You are not permitted to use the device; this udev rule permits it: %1")},
  {R"(The USB device (\S+) may not be used by you; put this line into (\S+) and plug the device out and in: (.+))",
   QT_TRANSLATE_NOOP("esm::HapticText", "The USB device %1 may not be used by you; put this line into %2 and "
                                        "plug the device out and in: %3")},
  {R"(The USB device (\S+) is in use by another program; close that one)",
   QT_TRANSLATE_NOOP("esm::HapticText", "The USB device %1 is in use by another program; close that one")},
  {R"(The USB device (\S+) cannot be opened: (.+))",
   QT_TRANSLATE_NOOP("esm::HapticText", "The USB device %1 cannot be opened: %2")},
  {"The device is no longer plugged in",
   QT_TRANSLATE_NOOP("esm::HapticText", "The device is no longer plugged in")},
  {"USB cannot be used here: (.+)", QT_TRANSLATE_NOOP("esm::HapticText", "USB cannot be used here: %1")},
  {"Its USB numbers belong to nobody, so another device may carry them; confirm that it is a (.+)",
   QT_TRANSLATE_NOOP("esm::HapticText", "Its USB numbers belong to nobody, so another device may carry them; "
                                        "confirm that it is a %1")},
  {"Firmware (.+), SHA-256 ([0-9a-f]+)", QT_TRANSLATE_NOOP("esm::HapticText", "Firmware %1, SHA-256 %2")},
  {R"((.+) holds (\d+) bytes; a firmware image has 1 to (\d+))",
   QT_TRANSLATE_NOOP("esm::HapticText", "%1 holds %2 bytes; a firmware image has 1 to %3")},
  // Kinds of devices
  {"A device in the computer, led by the mouse",
   QT_TRANSLATE_NOOP("esm::HapticText", "A device in the computer, led by the mouse")},
  {"An instrument through a trocar in the computer, led by the mouse",
   QT_TRANSLATE_NOOP("esm::HapticText", "An instrument through a trocar in the computer, led by the mouse")},
  {R"(Novint Falcon \(USB\); needs your firmware file)",
   QT_TRANSLATE_NOOP("esm::HapticText", "Novint Falcon (USB); needs your firmware file")},
  {R"(Force-feedback stick or wheel \(USB HID PID\))",
   QT_TRANSLATE_NOOP("esm::HapticText", "Force-feedback stick or wheel (USB HID PID)")},
  {R"(WoodenHaptics \(USB\))", QT_TRANSLATE_NOOP("esm::HapticText", "WoodenHaptics (USB)")},
};

QString look(const char* text)
{
  return QCoreApplication::translate(kContext, text);
}

} // namespace

QString deviceStateText(DeviceState state)
{
  switch (state) {
  case DeviceState::Absent:
    return look(QT_TRANSLATE_NOOP("esm::HapticText", "no device"));
  case DeviceState::Idle:
    return look(QT_TRANSLATE_NOOP("esm::HapticText", "ready, force off"));
  case DeviceState::Arming:
    return look(QT_TRANSLATE_NOOP("esm::HapticText", "force fades in"));
  case DeviceState::Active:
    return look(QT_TRANSLATE_NOOP("esm::HapticText", "force on"));
  case DeviceState::Fading:
    return look(QT_TRANSLATE_NOOP("esm::HapticText", "force fades out"));
  case DeviceState::Fault:
    return look(QT_TRANSLATE_NOOP("esm::HapticText", "stopped, force off"));
  }
  return {};
}

QString devicePhaseText(DevicePhase phase)
{
  switch (phase) {
  case DevicePhase::Opening:
    return look(QT_TRANSLATE_NOOP("esm::HapticText", "is being opened"));
  case DevicePhase::Upload:
    return look(QT_TRANSLATE_NOOP("esm::HapticText", "takes its firmware"));
  case DevicePhase::NeedsHome:
    return look(QT_TRANSLATE_NOOP("esm::HapticText", "needs home"));
  case DevicePhase::Running:
    return look(QT_TRANSLATE_NOOP("esm::HapticText", "connected"));
  case DevicePhase::Fault:
    return look(QT_TRANSLATE_NOOP("esm::HapticText", "fault"));
  case DevicePhase::Lost:
    return look(QT_TRANSLATE_NOOP("esm::HapticText", "unplugged"));
  }
  return {};
}

QString deviceNameText(const std::string& name)
{
  constexpr std::pair<const char*, const char*> kNames[] = {
    {"simulated", QT_TRANSLATE_NOOP("esm::HapticText", "Simulated device")},
    {"laparoscope", QT_TRANSLATE_NOOP("esm::HapticText", "Laparoscope")},
    {"falcon", QT_TRANSLATE_NOOP("esm::HapticText", "Novint Falcon")},
    {"pid", QT_TRANSLATE_NOOP("esm::HapticText", "Stick or wheel")},
    {"wooden", QT_TRANSLATE_NOOP("esm::HapticText", "WoodenHaptics")},
    {"path", QT_TRANSLATE_NOOP("esm::HapticText", "Hand path")},
  };
  for (const auto& [known, text] : kNames)
    if (name == known) return look(text);
  return QString::fromStdString(name);
}

QString hapticReasonText(const std::string& reason)
{
  return translated(QString::fromStdString(reason), kReasons, kContext);
}

QString priorityText(const std::string& priority)
{
  if (priority == "real-time") return look(QT_TRANSLATE_NOOP("esm::HapticText", "real-time priority"));
  if (priority == "raised") return look(QT_TRANSLATE_NOOP("esm::HapticText", "raised priority"));
  return look(QT_TRANSLATE_NOOP("esm::HapticText", "normal priority"));
}

} // namespace esm
