// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/library_words.h"

#include "core/base/ascii_case.h"
#include "core/base/text_number.h"
#include "meshimport/byte_order.h"
#include "meshimport/raw_mesh.h"
#include "meshimport/xml_tags.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace esm {

namespace {

constexpr std::size_t kMostName = 30, kMostQuoted = 200; // bytes of foreign words in a message
constexpr std::size_t kMostHeader = 4096;                // bytes that are searched for a version
constexpr std::size_t kDeepestTags = 1'000'000;          // tags within each other that are remembered

const char* const kXmlDamaged = "its XML is damaged";
const char* const kWayOut = "; save it as OBJ, PLY or STL in the program it comes from";
const char* const kMend = "; mend it, or save it as OBJ, PLY or STL in the program it comes from";
const char* const kFetch =
  "; fetch it again, it may be cut short, or save it as OBJ, PLY or STL in the program it comes from";

enum class Cause {
  Memory,
  Silent,
  Number,
  Value,
  Xml,
  Section,
  Version,
  Item,
  Circle,
  Word,
  Start,
  Nothing,
  End,
  Index,
  Packed,
  Archive,
  Syntax
};

struct Sign {
  std::string_view words; ///< in lower case
  Cause cause;
};

/// What assimp 5 and Coin 4 say, gathered from damaged files; the first that fits counts.
constexpr Sign kSigns[] = {
  {"bad_alloc", Cause::Memory},
  {"unknown error", Cause::Silent},
  {"cannot parse string", Cause::Number},
  {"number expected", Cause::Number},
  {"failed to parse", Cause::Number},
  {"expected a floating point number", Cause::Number},
  {"failed to convert attribute", Cause::Value},
  {"couldn't read value", Cause::Value},
  {"was not of type", Cause::Value},
  {"format version", Cause::Version},
  {"array index", Cause::Item},
  {"recursive reference", Cause::Circle},
  {"malformed xml", Cause::Xml},
  {"xml reader", Cause::Xml},
  {"parse xml", Cause::Xml},
  {"error parsing", Cause::Xml},
  {"missing section", Cause::Section},
  {"dictionary found", Cause::Section},
  {"must contain not empty", Cause::Section},
  {"did not find required element", Cause::Section},
  {"root node", Cause::Section},
  {"component type", Cause::Word},
  {"not recognized", Cause::Word},
  {"unknown field", Cause::Word},
  {"no suitable reader", Cause::Start},
  {"unable to read gltf", Cause::Start},
  {"unable to read the file header", Cause::Start},
  {"json parse error", Cause::Start},
  {"magic", Cause::Start},
  {"not an iff", Cause::Start},
  {"unknown lwo", Cause::Start},
  {"either empty or corrupt", Cause::Start},
  {"no mesh", Cause::Nothing},
  {"has no faces", Cause::Nothing},
  {"scene root", Cause::Nothing},
  {"data is null", Cause::Nothing},
  {"end of file", Cause::End},
  {"eof", Cause::End},
  {"unexpected end", Cause::End},
  {"premature end", Cause::End},
  {"unexpected eol", Cause::End},
  {"too small", Cause::End},
  {"too short", Cause::End},
  {"differs from what the file claims", Cause::End},
  {"truncated", Cause::End},
  {"chunk is too large", Cause::End},
  {"stream limit", Cause::End},
  {"block offset is out of range", Cause::End},
  {"length out of bounds", Cause::End},
  {"points behind the file", Cause::End},
  {"bin chunk", Cause::End},
  {"exceeds size", Cause::End},
  {"compressionfailure", Cause::Packed},
  {"out of range", Cause::Index},
  {"_m_range_check", Cause::Index},
  {"invalid face index", Cause::Index},
  {"invalid vertex index", Cause::Index},
  {"invalid index", Cause::Index},
  {"invalid data index", Cause::Index},
  {"not found node", Cause::Index},
  {"without valid buffer", Cause::Index},
  {"failed to open file", Cause::Archive},
  {"expected", Cause::Syntax},
};

/// What is wrong, and where; line 0 if that is not known.
struct Finding {
  std::string text;
  long line = 0;
  bool mayBeCut = false;
  bool isSound = false; ///< of a version that is not read: there is nothing to mend
};

long lineAt(std::string_view bytes, std::size_t place)
{
  const std::string_view before = bytes.substr(0, place);
  return 1 + static_cast<long>(std::count(before.begin(), before.end(), '\n'));
}

std::string shown(std::string_view name)
{
  std::string text(name.substr(0, kMostName));
  std::replace_if(
    text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 32 || c == 127; }, '?');
  return text;
}

/// The number behind a word of the complaint: "Line 12: ...", "(offset 0x1ef)".
std::optional<long long> numberBehind(std::string_view complaint, std::string_view word)
{
  const std::size_t place = asciiLower(complaint).find(word);
  if (place == complaint.npos) return {};
  std::string_view rest = complaint.substr(place + word.size());
  rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
  const bool isHex = rest.substr(0, 2) == "0x";
  constexpr std::string_view kDigits = "0123456789abcdef";
  long long value = 0;
  std::size_t at = isHex ? 2 : 0;
  const std::size_t first = at;
  for (; at < rest.size() && at < first + 12; ++at) {
    const std::size_t digit = kDigits.substr(0, isHex ? 16 : 10).find(rest[at]);
    if (digit == kDigits.npos) break;
    value = (isHex ? 16 : 10) * value + static_cast<long long>(digit);
  }
  if (at == first) return {};
  return value;
}

/// What the complaint has in quotes: "a", ``a'', or of FBX "no Objects dictionary".
std::string_view quoted(std::string_view complaint)
{
  constexpr std::pair<std::string_view, std::string_view> kQuotes[] = {
    {"\"", "\""}, {"``", "''"}, {" no ", " dictionary"}};
  for (const auto& [open, close] : kQuotes) {
    const std::size_t begin = complaint.find(open);
    if (begin == complaint.npos) continue;
    const std::size_t end = complaint.find(close, begin + open.size());
    if (end == complaint.npos) continue;
    return complaint.substr(begin + open.size(), end - begin - open.size());
  }
  return {};
}

/// The first tag that does not fit those before it.
Finding xmlFault(std::string_view text)
{
  struct Open {
    std::string_view name;
    std::size_t place;
  };
  std::vector<Open> open;
  XmlTags tags(text);
  std::size_t behind = 0;
  for (XmlTag tag; tags.next(tag); behind = tags.position()) {
    const auto place = static_cast<std::size_t>(tag.name.data() - text.data());
    if (!tag.isEnd) {
      if (!tag.isEmpty) open.push_back({tag.name, place});
      if (open.size() > kDeepestTags) return {kXmlDamaged};
      continue;
    }
    if (open.empty()) return {"</" + shown(tag.name) + "> ends what nothing has begun", lineAt(text, place)};
    const Open last = open.back();
    if (last.name != tag.name)
      return {"</" + shown(tag.name) + "> stands where </" + shown(last.name) + "> should, begun in line " +
                std::to_string(lineAt(text, last.place)),
              lineAt(text, place)};
    open.pop_back();
  }
  const std::size_t cut = text.rfind('<');
  if (cut != text.npos && cut >= behind && text.find('>', cut) == text.npos)
    return {"a tag begins here and does not end", lineAt(text, cut), true};
  if (!open.empty())
    return {"it ends within <" + shown(open.back().name) + ">, begun in line " +
              std::to_string(lineAt(text, open.back().place)),
            0, true};
  return {kXmlDamaged};
}

/// The first bracket of a JSON text that does not fit those before it.
Finding jsonFault(std::string_view text)
{
  std::string open;
  bool inText = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (inText) {
      if (c == '\\')
        ++i;
      else if (c == '"')
        inText = false;
    } else if (c == '"') {
      inText = true;
    } else if (c == '{' || c == '[') {
      open += c;
    } else if (c == '}' || c == ']') {
      if (open.empty() || open.back() != (c == '}' ? '{' : '['))
        return {"something else stands there than the format asks for", lineAt(text, i)};
      open.pop_back();
    }
  }
  if (inText || !open.empty()) return {"it ends too early, or a length in it is wrong", 0, true};
  if (text.find("\"asset\"") == text.npos) return {"its section 'asset' is missing"};
  if (text.find("\"2.0\"") == text.npos) return {"its glTF version is not read, 2.0 is", 0, false, true};
  return {"its JSON is damaged"};
}

/// glTF names the object whose member is wrong: "... when reading accessors[0]".
Finding valueFault(const std::string& name, std::string_view complaint)
{
  constexpr std::string_view kWhere = "when reading ";
  const std::size_t place = complaint.find(kWhere);
  const std::string where =
    place == complaint.npos
      ? ""
      : shown(complaint.substr(place + kWhere.size(), complaint.find(" (", place) - place - kWhere.size()));
  if (where.empty() || where == "the document") return {"'" + name + "' holds something else than it should"};
  return {"'" + name + "' of " + where + " holds something else than it should"};
}

/// Of an FBX, whose number stands at a fixed place in binary files.
Finding versionFault(std::string_view bytes)
{
  constexpr std::size_t kPlace = 23;
  const bool isBinary = bytes.substr(0, 7) == "Kaydara" && bytes.size() >= kPlace + 4;
  const long long version = isBinary ? loadLittle<std::uint32_t>(bytes.data() + kPlace)
                                     : numberBehind(bytes.substr(0, kMostHeader), "fbxversion:").value_or(0);
  return {"its FBX version, " + std::to_string(version) + ", is not read, those from 7100 (FBX 2011) on are",
          0, false, true};
}

Finding startFault(std::string_view bytes, std::string_view ending)
{
  constexpr std::size_t kHeader = 12; ///< of a .glb
  if (ending == "gltf") return jsonFault(bytes);
  if (ending == "glb" && bytes.substr(0, 4) == "glTF" && bytes.size() >= kHeader) {
    const auto promised = loadLittle<std::uint32_t>(bytes.data() + 8);
    if (promised > bytes.size())
      return {"its header promises " + std::to_string(promised) + " bytes, but it has " +
                std::to_string(bytes.size()),
              0, true};
  }
  return {"its beginning is damaged, or it is of another format than its name says"};
}

/// The word that the library has in its hand, and the line if it stands at one place only.
Finding numberFault(std::string_view complaint, std::string_view bytes)
{
  const std::size_t begin = complaint.find('"');
  const std::size_t end = complaint.find("\" as a real number");
  if (begin == complaint.npos || end == complaint.npos || end <= begin + 1)
    return {"something else stands where a number should be"};
  const std::string_view rest = complaint.substr(begin + 1, end - begin - 1);
  Finding finding{"'" + shown(rest.substr(0, rest.find_first_of(" \t\r\n"))) +
                  "' stands where a number should be"};
  const std::size_t place = bytes.find(rest);
  if (rest.size() > 2 && place != bytes.npos && bytes.find(rest, place + 1) == bytes.npos)
    finding.line = lineAt(bytes, place);
  return finding;
}

Finding findingOf(Cause cause, std::string_view complaint, std::string_view bytes, std::string_view ending)
{
  const std::string name = shown(quoted(complaint));
  switch (cause) {
  case Cause::Memory:
    return {"there is not enough memory to read it"};
  case Cause::Silent:
    return {"the reading library cannot read it and does not say why"};
  case Cause::Number:
    return numberFault(complaint, bytes);
  case Cause::Value:
    return valueFault(name, complaint);
  case Cause::Xml:
    return xmlFault(bytes);
  case Cause::Section:
    return {"its section '" + name + "' is missing"};
  case Cause::Version:
    return versionFault(bytes);
  case Cause::Item:
    return {"it names " + name + "[" + std::to_string(numberBehind(complaint, "index ").value_or(-1)) +
            "], but holds " + std::to_string(numberBehind(complaint, "bounds (").value_or(0)) + " of these"};
  case Cause::Circle:
    return {"something in it is a part of itself"};
  case Cause::Word:
    return {"'" + (name.empty() ? shown(complaint.substr(complaint.rfind(' ') + 1)) : name) +
            "' is no word of this format"};
  case Cause::Start:
    return startFault(bytes, ending);
  case Cause::Nothing:
    return {"it holds no mesh that can be read"};
  case Cause::End:
    return {"it ends too early, or a length in it is wrong", 0, true};
  case Cause::Index:
    return {"it points to data that it does not hold"};
  case Cause::Packed:
    return {"data that are packed in it cannot be unpacked", 0, true};
  case Cause::Archive:
    return {"its ZIP archive is damaged", 0, true};
  case Cause::Syntax:
    break;
  }
  return {"something else stands there than the format asks for"};
}

std::optional<Cause> causeOf(std::string_view complaint, std::string_view ending)
{
  const std::string words = asciiLower(complaint);
  for (const Sign& sign : kSigns) {
    if (words.find(sign.words) == words.npos) continue;
    if (sign.cause == Cause::Archive && ending != "3mf" && ending != "zae") continue;
    if (sign.cause == Cause::Xml && (ending == "3mf" || ending == "zae")) continue; // the bytes are packed
    return sign.cause;
  }
  return {};
}

/// The finding with its place before it: "line 3: ...", "byte 17: ...".
Finding placed(Cause cause, std::string_view complaint, std::string_view bytes, std::string_view ending)
{
  Finding finding = findingOf(cause, complaint, bytes, ending);
  if (finding.line == 0) finding.line = static_cast<long>(numberBehind(complaint, "line ").value_or(0));
  const auto byte = finding.line == 0 ? numberBehind(complaint, "offset ") : std::nullopt;
  if (finding.line > 0) finding.text = "line " + std::to_string(finding.line) + ": " + finding.text;
  if (byte) finding.text = "byte " + std::to_string(*byte) + ": " + finding.text;
  return finding;
}

std::string quoteOf(std::string_view complaint)
{
  const std::string_view first = complaint.substr(0, complaint.find('\n'));
  return kWayOut + ("; the reading library says: " + std::string(first.substr(0, kMostQuoted))) +
         (first.size() > kMostQuoted ? " ..." : "");
}

} // namespace

bool hasTornTags(std::string_view xml)
{
  return xmlFault(xml).text != kXmlDamaged;
}

Error damagedFile(const std::string& what, bool mayBeCut, const std::string& origin)
{
  return fault(ErrorCode::BadFormat, origin, 0, what + (mayBeCut ? kFetch : kMend));
}

std::string libraryFinding(std::string_view complaint, std::string_view bytes, std::string_view ending)
{
  const std::optional<Cause> cause = causeOf(complaint, ending);
  return cause ? placed(*cause, complaint, bytes, ending).text : std::string();
}

Error libraryRefusal(std::string_view complaint, std::string_view bytes, std::string_view ending,
                     const std::string& origin)
{
  const std::optional<Cause> cause = causeOf(complaint, ending);
  if (!cause) return fault(ErrorCode::BadFormat, origin, 0, "the file cannot be read" + quoteOf(complaint));
  if (cause == Cause::Memory)
    return fault(ErrorCode::BadFormat, origin, 0,
                 "there is not enough memory to read it; the file may be damaged");
  const Finding finding = placed(*cause, complaint, bytes, ending);
  const char* const way = finding.isSound ? kWayOut : finding.mayBeCut ? kFetch : kMend;
  return fault(cause == Cause::Nothing ? ErrorCode::EmptyResult : ErrorCode::BadFormat, origin, 0,
               finding.text + way);
}

} // namespace esm
