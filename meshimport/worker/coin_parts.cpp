// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/worker/coin_parts.h"

#include "meshimport/worker/limits.h"

#include <Inventor/SbImage.h>
#include <Inventor/SoDB.h>
#include <Inventor/VRMLnodes/SoVRMLInline.h>
#include <Inventor/actions/SoSearchAction.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoWWWInline.h>

#include <algorithm>

namespace esm {

namespace {

constexpr std::size_t kMostParts = 1000; ///< two files that name each other twice would make 2^n of them

void fetchInline(const SbString&, void* to, SoWWWInline* node)
{
  auto& parts = *static_cast<CoinParts*>(to);
  PartInput input(parts);
  const std::size_t depth = parts.open.size();
  if (!input.pushFile(node->name.getValue().getString())) {
    if (SoNode* const other = node->alternateRep.getValue()) node->setChildData(other);
    return;
  }
  if (SoSeparator* const part = SoDB::readAll(&input)) node->setChildData(part);
  parts.open.resize(depth); // the last file of an input is never popped
}

std::vector<SoVRMLInline*> inlinesIn(SoNode* scene)
{
  SoSearchAction search;
  search.setType(SoVRMLInline::getClassTypeId());
  search.setInterest(SoSearchAction::ALL);
  search.setSearchingAll(TRUE);
  search.apply(scene);
  std::vector<SoVRMLInline*> found;
  for (int i = 0; i < search.getPaths().getLength(); ++i)
    found.push_back(static_cast<SoVRMLInline*>(search.getPaths()[i]->getTail()));
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end()); // one node may hang in many places
  return found;
}

/// The part at the first place but the foremost, which Coin has tried; null if there is none.
SoSeparator* partElsewhere(CoinParts& parts, const SoMFString& places)
{
  for (int i = 1; i < places.getNum(); ++i) {
    PartInput input(parts);
    if (!input.pushFile(places[i].getString())) continue;
    SoSeparator* const part = SoDB::readAll(&input);
    for (int earlier = 0; part && earlier < i; ++earlier) parts.folder.forget(places[earlier].getString());
    return part;
  }
  return nullptr;
}

/// No picture is wanted, so none is opened.
SbBool ignorePicture(const SbString&, SbImage*, void*)
{
  return TRUE;
}

} // namespace

CoinParts::CoinParts(const std::filesystem::path& model)
  : folder(model), open{std::filesystem::weakly_canonical(folder.path() / model.filename())}
{}

std::filesystem::path CoinParts::enter(std::string_view name)
{
  std::filesystem::path part = folder.find(name, open.back().parent_path());
  if (part.empty()) return part;
  if (std::find(open.begin(), open.end(), part) != open.end()) {
    folder.lose(name, "it would be a part of itself");
  } else if (count == kMostParts) {
    folder.lose(name, "the scene has more than " + std::to_string(kMostParts) + " parts");
  } else {
    ++count;
    std::error_code code;
    if (const std::uintmax_t size = std::filesystem::file_size(part, code); !code) allowFor(size);
    open.push_back(part);
    return part;
  }
  return {};
}

SbBool PartInput::pushFile(const char* name)
{
  const std::filesystem::path part = m_parts.enter(name);
  if (part.empty()) return FALSE;
  if (SoInput::pushFile(part.c_str())) return TRUE;
  m_parts.open.pop_back();
  m_parts.folder.lose(name, "it cannot be read");
  return FALSE;
}

SbBool PartInput::popFile()
{
  const SbBool popped = SoInput::popFile();
  if (popped && m_parts.open.size() > 1) m_parts.open.pop_back();
  return popped;
}

void readInlinesFrom(CoinParts& parts)
{
  SoInput::clearDirectories();
  SbImage::addReadImageCB(ignorePicture, nullptr);
  SoVRMLInline::setReadAsSoFile(TRUE);
  SoWWWInline::setReadAsSoFile(FALSE);
  SoWWWInline::setFetchURLCallBack(fetchInline, &parts);
}

void readOtherPlaces(CoinParts& parts, SoNode* scene)
{
  const std::size_t depth = parts.open.size();
  for (SoVRMLInline* const node : inlinesIn(scene)) {
    if (node->url.getNum() == 0) continue;
    if (node->getChildData())
      parts.enter(node->url[0].getString()); // once more, for what it names itself
    else if (SoSeparator* const part = partElsewhere(parts, node->url))
      node->setChildData(part);
    if (SoNode* const part = node->getChildData()) readOtherPlaces(parts, part);
    parts.open.resize(depth);
  }
}

} // namespace esm
