// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/project/journal_history.h"

#include "core/project/json_view.h"
#include "core/project/project_tree.h"

#include <algorithm>
#include <limits>

namespace esm::json {

JournalHistory::JournalHistory(Json tree, std::string copy, bool derived, int model, int index, bool isSaved)
  : m_now{std::move(tree), std::move(copy), derived, model, {}}, m_index(index)
{
  if (isSaved) m_saved = index;
  m_states[index] = m_now;
}

void JournalHistory::take(const Json& line)
{
  if (const auto patch = line.find("patch"); patch != line.end()) m_now.tree.patch_inplace(*patch);
  if (line.contains("net")) {
    m_now.copy = line["net"].get<std::string>();
    m_now.fixed.reset();
  }
  if (line.contains("fixed")) m_now.fixed = line["fixed"];
  if (line.contains("model")) m_now.model = line["model"].get<int>();
  if (line.contains("derived")) m_now.derived = line["derived"].get<bool>();
  if (const auto undo = line.find("undo"); undo != line.end()) {
    m_index = undo->at("index").get<int>();
    const int count = undo->at("count").get<int>();
    m_states.erase(m_states.upper_bound(count), m_states.end()); // a new step where others had been undone
    m_texts.erase(m_texts.upper_bound(count), m_texts.end());
    if (m_saved && *m_saved > count) m_saved.reset();
    m_states[m_index] = m_now;
    m_texts[m_index] = undo->at("text").get<std::string>();
    if (m_index < count) m_texts[m_index + 1] = undo->at("next").get<std::string>();
  }
  if (const auto file = line.find("file"); file != line.end()) {
    m_saved.reset();
    if (!file->is_null()) m_saved = m_index;
  }
}

std::optional<RecoveredState> JournalHistory::read(const State& state, const NetReader& netOf,
                                                   const std::string& origin) const
{
  RecoveredState read;
  read.net = netOf(state.copy);
  if (!read.net) return {};
  read.copy = state.copy;
  read.netDerived = state.derived;
  read.model = state.model;
  if (state.fixed) {
    Faults faults{origin, {}};
    auto held = std::make_shared<SpringNet>(*read.net);
    std::fill(held->fixed.begin(), held->fixed.end(), std::uint8_t{0});
    for (const Index node : View(*state.fixed, faults).indexList(held->nodeCount()))
      held->fixed[static_cast<std::size_t>(node)] = 1;
    if (faults.first) return {};
    read.net = std::move(held);
  }
  Result<Project> project = readWithoutNet(state.tree, read.net->nodeCount(), origin);
  if (!project) return {};
  read.project = std::move(project).value();
  return read;
}

RecoveredHistory JournalHistory::states(const NetReader& netOf, const std::string& origin) const
{
  int first = m_index, last = m_index;
  while (m_states.contains(first - 1) && m_texts.contains(first)) --first;
  while (m_states.contains(last + 1) && m_texts.contains(last + 1)) ++last;
  RecoveredHistory history;
  for (int i = first; i <= last; ++i) {
    auto state = read(m_states.at(i), netOf, origin);
    if (!state) return {};
    if (i > first) {
      const State &before = m_states.at(i - 1), &after = m_states.at(i);
      const auto isSame = [&](const char* key) { return before.tree.at(key) == after.tree.at(key); };
      state->text = m_texts.at(i);
      state->netStays =
        before.copy == after.copy && before.fixed == after.fixed && isSame("loads") && isSame("simulation");
    }
    history.states.push_back(std::move(*state));
  }
  history.first = first;
  history.present = m_index - first;
  if (m_saved && *m_saved >= first && *m_saved <= last) history.saved = *m_saved - first;
  return history;
}

} // namespace esm::json
