// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/tissue/region_edit.h"

#include <algorithm>
#include <utility>

namespace esm {

namespace {

auto at(TissueModel& model, std::size_t place)
{
  return model.regions.begin() + static_cast<std::ptrdiff_t>(place);
}

Status mustExist(const TissueModel& model, std::size_t place)
{
  if (place < model.regions.size()) return {};
  return Error{ErrorCode::InvalidValue, "there is no region " + std::to_string(place + 1) + ", only " +
                                          std::to_string(model.regions.size())};
}

} // namespace

Status mayEditRegion(const TissueModel& model, std::size_t place)
{
  if (const Status status = mustExist(model, place); !status) return status;
  if (!model.regions[place].locked) return {};
  return Error{ErrorCode::InvalidValue, "region " + std::to_string(place + 1) + " '" +
                                          model.regions[place].name + "' is locked; unlock it first"};
}

Status insertRegion(TissueModel& model, std::size_t place, Region region)
{
  if (place > model.regions.size()) return mustExist(model, place);
  model.regions.insert(at(model, place), std::move(region));
  return {};
}

Status replaceRegion(TissueModel& model, std::size_t place, Region region)
{
  if (const Status status = mayEditRegion(model, place); !status) return status;
  region.locked = false;
  model.regions[place] = std::move(region);
  return {};
}

Status removeRegion(TissueModel& model, std::size_t place)
{
  if (const Status status = mayEditRegion(model, place); !status) return status;
  model.regions.erase(at(model, place));
  return {};
}

Status moveRegion(TissueModel& model, std::size_t from, std::size_t to)
{
  if (const Status status = mayEditRegion(model, from); !status) return status;
  if (const Status status = mustExist(model, to); !status) return status;
  if (from < to)
    std::rotate(at(model, from), at(model, from + 1), at(model, to + 1));
  else
    std::rotate(at(model, to), at(model, from), at(model, from + 1));
  return {};
}

Status lockRegion(TissueModel& model, std::size_t place, bool locked)
{
  if (const Status status = mustExist(model, place); !status) return status;
  model.regions[place].locked = locked;
  return {};
}

Status showRegion(TissueModel& model, std::size_t place, bool visible)
{
  if (const Status status = mustExist(model, place); !status) return status;
  model.regions[place].visible = visible;
  return {};
}

Status detachTwin(TissueModel& model, std::size_t place)
{
  if (const Status status = mayEditRegion(model, place); !status) return status;
  Region& region = model.regions[place];
  if (!region.mirror)
    return Error{ErrorCode::InvalidValue,
                 "region " + std::to_string(place + 1) + " '" + region.name + "' has no mirrored twin"};
  if (region.insideOut)
    return Error{ErrorCode::InvalidValue, "region " + std::to_string(place + 1) + " '" + region.name +
                                            "' is what lies outside of both twins and cannot be split"};
  Region twin = region;
  twin.ellipsoid = mirrored(region.ellipsoid, *region.mirror);
  twin.mirror.reset();
  region.mirror.reset();
  model.regions.insert(at(model, place + 1), std::move(twin));
  return {};
}

} // namespace esm
