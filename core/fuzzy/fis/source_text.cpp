// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/fis/source_text.h"

#include "core/base/text_number.h"

#include <algorithm>
#include <cmath>

namespace esm::fis {

namespace {

constexpr std::string_view kBlanks = " \t\v\f\r\n";

} // namespace

bool SourceText::nextLine(std::string_view& line)
{
  if (m_next >= m_text.size()) return false;
  const std::size_t end = std::min(m_text.find_first_of("\r\n", m_next), m_text.size());
  line = m_text.substr(m_next, end - m_next);
  m_next = end + (m_text.substr(end, 2) == "\r\n" ? 2 : 1);
  return true;
}

Error SourceText::error(const Fault& fault) const
{
  const char* start = m_text.data();
  const char* end = std::clamp(fault.at, start, start + m_text.size());
  int line = 1, column = 1;
  for (const char* c = start; c != end; ++c) {
    const bool ends = *c == '\n' || (*c == '\r' && !(c + 1 != start + m_text.size() && c[1] == '\n'));
    if (ends)
      ++line, column = 1;
    else if ((static_cast<unsigned char>(*c) & 0xC0U) != 0x80U) // the first byte of a character
      ++column;
  }
  return {ErrorCode::BadFormat, std::string(m_fileName) + ':' + std::to_string(line) + ':' +
                                  std::to_string(column) + ": " + fault.message};
}

void Notes::add(const char* at, const std::string& what)
{
  if (!m_list) return;
  m_list->push_back(at ? m_source.error({at, what}).detail : std::string(m_source.fileName()) + ": " + what);
}

void OnceKeys::give(std::string_view key, const std::string& owner, std::string_view value)
{
  std::string_view& given = m_given.try_emplace({std::string(key), owner}, value).first->second;
  if (given != value)
    m_notes.add(value.data(), std::string(key) + (owner.empty() ? "" : " of " + owner) + " is given again: " +
                                shown(value) + " holds, " + shown(given) + " is passed over");
  given = value;
}

std::string_view trimmed(std::string_view text)
{
  const std::size_t from = text.find_first_not_of(kBlanks);
  if (from == std::string_view::npos) return text.substr(text.size());
  return text.substr(from, text.find_last_not_of(kBlanks) - from + 1);
}

std::string_view takeWord(std::string_view& text)
{
  text = trimmed(text);
  const std::size_t end = std::min(text.find_first_of(kBlanks), text.size());
  const std::string_view word = text.substr(0, end);
  text = trimmed(text.substr(end));
  return word;
}

std::string shown(std::string_view text)
{
  std::string result = "'";
  for (const char c : text.substr(0, 60)) result += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
  return result + (text.size() > 60 ? "...'" : "'");
}

double readNumber(std::string_view word)
{
  const auto value = parseDouble(word);
  if (!value)
    throw Fault{word.data(), word.empty() ? "here a number is missing" : shown(word) + " is no number"};
  return *value;
}

int readCount(std::string_view word)
{
  const double value = readNumber(word);
  if (!(value >= 0.0 && value <= 1e6) || value != std::floor(value))
    throw Fault{word.data(), shown(word) + " is no whole number from 0 to 1000000"};
  return static_cast<int>(value);
}

double readExpression(std::string_view text)
{
  if (const auto value = parseDouble(text)) return *value;
  const auto parsed = Formula::parse(text, {});
  if (const auto* error = std::get_if<FormulaError>(&parsed))
    throw Fault{text.data() + error->offset, shown(text) + " is no number: " + error->message};
  return std::get<Formula>(parsed).evaluate(0.0, {});
}

namespace {

class RuleReader {
public:
  RuleReader(std::string_view text, const System& system, bool asFcl)
    : m_text(text), m_system(system), m_asFcl(asFcl)
  {
    next();
  }

  Rule read()
  {
    Rule rule;
    expect("if");
    flatten(readAny(0), rule.antecedent);
    expect("then");
    readConclusions(rule, 0);
    if (accept("with")) {
      rule.weight = readNumber(m_word);
      next();
    }
    if (!m_word.empty())
      throw Fault{m_word.data(), "nothing more may follow here, but " + shown(m_word) + " does"};
    return rule;
  }

  const char* mixed() const { return m_mixed; }

private:
  using Kind = Antecedent::Kind;
  /// A condition while it grows; turned into the flat tree, parents first, at the end.
  struct Branch {
    Kind kind = Kind::Proposition;
    Proposition proposition;
    std::vector<Branch> children;
    const char* bare = nullptr; ///< of a chain without brackets: its first "and" or "or"
  };

  void next()
  {
    const std::size_t from = std::min(m_text.find_first_not_of(kBlanks), m_text.size());
    m_text.remove_prefix(from);
    std::size_t size = 0;
    if (!m_text.empty() && (m_text[0] == '(' || m_text[0] == ')' || m_text[0] == ','))
      size = 1;
    else
      size = std::min(m_text.find_first_of(" \t\v\f\r\n(),"), m_text.size());
    m_word = m_text.substr(0, size);
    m_text.remove_prefix(size);
  }

  bool is(std::string_view word) const { return m_asFcl ? equalIgnoringCase(m_word, word) : m_word == word; }
  bool accept(std::string_view word)
  {
    if (!is(word)) return false;
    next();
    return true;
  }
  void expect(std::string_view word)
  {
    if (accept(word)) return;
    throw Fault{m_word.data(), "here '" + std::string(word) + "' was expected" +
                                 (m_word.empty() ? std::string() : ", not " + shown(m_word))};
  }

  /// Many FCL writers put brackets around them.
  void readConclusions(Rule& rule, int depth)
  {
    do {
      if (m_asFcl && depth < kDepth && accept("(")) {
        readConclusions(rule, depth + 1);
        expect(")");
      } else {
        rule.consequents.push_back(readProposition(true));
      }
    } while (accept("and") || (m_asFcl && accept(",")));
  }

  Branch readAny(int depth) { return readChain(Kind::Or, depth); }
  Branch readChain(Kind kind, int depth)
  {
    const auto readPart = [&] { return kind == Kind::Or ? readChain(Kind::And, depth) : readOne(depth); };
    Branch first = readPart();
    const std::string_view keyword = kind == Kind::Or ? "or" : "and";
    if (!is(keyword)) return first;
    Branch chain;
    chain.kind = kind;
    chain.bare = m_word.data();
    chain.children.push_back(std::move(first));
    while (accept(keyword)) {
      chain.children.push_back(readPart());
      if (kind == Kind::Or && !m_mixed) m_mixed = chain.children.back().bare;
    }
    return chain;
  }

  Branch readOne(int depth)
  {
    if (depth > kDepth) throw Fault{m_word.data(), "the condition is nested too deeply"};
    if (accept("(")) {
      Branch group = readAny(depth + 1);
      group.bare = nullptr;
      expect(")");
      return group;
    }
    if (!is("not")) return {Kind::Proposition, readProposition(false), {}, nullptr};
    next();
    if (is("(") || is("not")) {
      Branch inverse;
      inverse.kind = Kind::Not;
      inverse.children.push_back(readOne(depth + 1));
      return inverse;
    }
    Proposition proposition = readProposition(false);
    proposition.hedges.insert(proposition.hedges.begin(), Hedge::Not);
    return {Kind::Proposition, std::move(proposition), {}, nullptr};
  }

  template <class Named>
  int find(const std::vector<Named>& things) const
  {
    for (std::size_t i = 0; i < things.size(); ++i)
      if (things[i].name == m_word) return static_cast<int>(i);
    for (std::size_t i = 0; i < things.size() && m_asFcl; ++i)
      if (equalIgnoringCase(things[i].name, m_word)) return static_cast<int>(i);
    return -1;
  }

  std::optional<Hedge> hedge() const
  {
    if (!m_asFcl) return hedgeNamed(m_word);
    for (int i = 0; i < kHedgeCount; ++i)
      if (equalIgnoringCase(nameOf(static_cast<Hedge>(i)), m_word)) return static_cast<Hedge>(i);
    return std::nullopt;
  }

  Proposition readProposition(bool concludes)
  {
    Proposition proposition;
    if (!concludes) proposition.variable = find(m_system.inputs);
    if (proposition.variable < 0) {
      proposition.variable = find(m_system.outputs);
      proposition.onOutput = true;
    }
    if (proposition.variable < 0)
      throw Fault{m_word.data(), m_word.empty() ? "here the name of a variable is missing"
                                                : shown(m_word) + (concludes ? " is no known output"
                                                                             : " is no known variable")};
    next();
    expect("is");
    const auto place = static_cast<std::size_t>(proposition.variable);
    const auto& terms = proposition.onOutput ? m_system.outputs[place].terms : m_system.inputs[place].terms;
    while (const auto found = hedge()) {
      if (find(terms) >= 0 && *found != Hedge::Any) break; // a term of that name
      proposition.hedges.push_back(*found);
      next();
      if (*found == Hedge::Any) return proposition;
      if (proposition.hedges.size() > 16) throw Fault{m_word.data(), "there are more than 16 hedges here"};
    }
    proposition.term = find(terms);
    if (proposition.term < 0 && !proposition.hedges.empty()) { // a term called "very" is read as "very_"
      const std::string usable = usableName(nameOf(proposition.hedges.back()));
      const auto same =
        std::find_if(terms.begin(), terms.end(), [&](const Term& t) { return t.name == usable; });
      if (same != terms.end()) {
        proposition.hedges.pop_back();
        proposition.term = static_cast<int>(same - terms.begin());
        return proposition;
      }
    }
    if (proposition.term < 0)
      throw Fault{m_word.data(), m_word.empty()
                                   ? "here the name of a term is missing"
                                   : shown(m_word) + " is neither a hedge nor a term of that variable"};
    next();
    return proposition;
  }

  static int flatten(const Branch& branch, Antecedent& antecedent)
  {
    const std::size_t place = antecedent.nodes.size();
    antecedent.nodes.push_back({branch.kind, branch.proposition, {}});
    std::vector<int> children;
    for (const Branch& child : branch.children) children.push_back(flatten(child, antecedent));
    antecedent.nodes[place].children = std::move(children);
    return static_cast<int>(place);
  }

  /// A group makes two levels (or, and) of the tree at most.
  static constexpr int kDepth = Antecedent::kMaximumDepth / 2 - 2;
  std::string_view m_text, m_word;
  const System& m_system;
  bool m_asFcl;
  const char* m_mixed = nullptr;
};

} // namespace

Rule readRule(std::string_view text, const System& system, bool asFcl, const char** mixed)
{
  RuleReader reader(text, system, asFcl);
  Rule rule = reader.read();
  if (mixed) *mixed = reader.mixed();
  return rule;
}

} // namespace esm::fis
