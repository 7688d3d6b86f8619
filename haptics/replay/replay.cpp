// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/replay/replay.h"

#include "haptics/device/driven_device.h"
#include "haptics/device/driver_profile.h"
#include "haptics/device/falcon_driver.h"
#include "haptics/emulator/fake_usb_transport.h"
#include "haptics/emulator/falcon_model.h"
#include "haptics/simulated_device.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {

namespace {

constexpr std::uint64_t kGeneration = 1;

Eigen::Vector3d middleOf(const HandPath& path)
{
  return 0.5 * (path.position.rowwise().minCoeff() + path.position.rowwise().maxCoeff());
}

struct FalconTwin {
  std::shared_ptr<FalconModel> model;
  std::unique_ptr<HapticDevice> device;
};

/// Running and homed, its own middle where the path has its.
FalconTwin falconAlong(HandPath path)
{
  DriverProfile profile = *parseProfile(builtInProfile("falcon"), {}, "falcon");
  profile.origin = Delta3::centre() - middleOf(path);
  FalconModel::Settings settings;
  settings.running = settings.homed = true;
  settings.origin = profile.origin;
  auto model = std::make_shared<FalconModel>(settings, std::make_unique<RecordedHand>(std::move(path)));
  FakeUsbTransport usb(model);
  auto wakeup = std::make_unique<Wakeup>();
  auto handle = *usb.open(usb.list().front(), 0, *wakeup);
  auto driver = std::make_unique<FalconDriver>(std::move(profile), std::move(wakeup), std::move(handle),
                                               std::vector<std::uint8_t>{});
  return {std::move(model), std::make_unique<DrivenDevice>(std::move(driver), DrivenDevice::Drive::Inline)};
}

} // namespace

Result<std::unique_ptr<Replay>> Replay::create(ReplayScene scene, HandPath path, ReplayDevice device,
                                               double frameRate)
{
  if (!(frameRate > 0.0) || !std::isfinite(frameRate))
    return Error{ErrorCode::InvalidValue, "the frame rate must be a positive number"};
  if (path.time.empty()) return Error{ErrorCode::EmptyResult, "the hand path has no points"};
  std::unique_ptr<Replay> replay(new Replay);
  replay->m_runner = std::make_unique<SimRunner>(frameRate, replay->m_tool, replay->m_contact);
  SimRunner& runner = *replay->m_runner;
  const Eigen::Vector3d start = path.position.col(0);
  runner.apply(command::SetQuality{}); // what a live simulation begins with
  runner.apply(
    command::Load{kGeneration, std::move(scene.net), std::move(scene.loads), std::move(scene.solver)});
  SimSnapshot picture;
  runner.draw(picture);
  if (picture.stability == Stability::Idle) return Error{ErrorCode::InvalidValue, picture.message};
  if (scene.node)
    runner.apply(command::Grab{*scene.node, start, scene.toolLimit, scene.gripRadius});
  else
    runner.apply(command::Touch{true, scene.tipRadius, scene.toolLimit});
  runner.apply(command::FollowDevice{true});
  runner.apply(command::Play{});
  replay->makeDevice(std::move(path), device);
  return replay;
}

void Replay::makeDevice(HandPath path, ReplayDevice kind)
{
  std::unique_ptr<HapticDevice> device;
  if (kind == ReplayDevice::Falcon) {
    FalconTwin twin = falconAlong(std::move(path));
    m_look = [model = twin.model] {
      return ReplayTick{0.0, model->grip().position(), model->force(), {}, model->grip().handWork()};
    };
    device = std::move(twin.device);
  } else {
    const Eigen::Vector3d start = path.position.col(0);
    auto simulated = std::make_unique<SimulatedDevice>(SimulatedDeviceSettings{},
                                                       std::make_unique<RecordedHand>(std::move(path)));
    simulated->setMotion(start, Eigen::Vector3d::Zero());
    m_look = [grip = simulated.get()] {
      return ReplayTick{0.0, grip->position(), grip->force(), {}, grip->handWork()};
    };
    device = std::move(simulated);
  }
  m_loop =
    std::make_unique<ServoLoop>(std::move(device), std::make_unique<VirtualClock>(), m_tool, m_contact);
}

void Replay::tick()
{
  const double before = m_last.time;
  if (m_armWanted && m_loop->device().report().phase == DevicePhase::Running) {
    m_loop->core().orders().give(ForceOrder::Arm);
    m_armWanted = false;
  }
  m_loop->runTicks(1);
  m_last = m_look();
  m_last.time = before + m_loop->device().profile().period;
  m_last.state = m_loop->core().status().state;
  if (!m_alive || m_last.time < m_nextFrame) return;
  m_nextFrame += m_runner->framePeriod();
  m_runner->runFrame();
}

void Replay::setFrameRate(double framesPerSecond)
{
  m_runner->apply(command::SetFrameRate{framesPerSecond});
  m_nextFrame = std::min(m_nextFrame, m_last.time + m_runner->framePeriod());
}

} // namespace esm
