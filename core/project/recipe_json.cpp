// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/project/recipe_json.h"

#include "core/base/text_number.h"
#include "core/project/option_fields.h"
#include "core/project/tissue_json.h"

#include <algorithm>
#include <charconv>

namespace esm::json {

namespace {

constexpr const char* kUnits[] = {"mm", "cm", "m", "inch"}; // in the order of LengthUnit
constexpr const char* kUp[] = {"y", "z"};
constexpr const char* kPatientAxes[] = {"none", "lps", "ras"};
constexpr const char* kPolygons[] = {"triangulated", "edges"};

template <class Enum, std::size_t count>
const char* wordOf(Enum value, const char* const (&words)[count])
{
  return words[static_cast<std::size_t>(value)];
}

/// Writes what differs from the default.
struct FieldWriter {
  Json& object;
  const Json* usual = nullptr;
  void put(const char* key, Json value)
  {
    if (!usual || (*usual)[key] != value) object[key] = std::move(value);
  }
  void flag(const char* key, bool value, const char*) { put(key, value); }
  void count(const char* key, Index value, const char*) { put(key, value); }
  void number(const char* key, double value, const char*, const char*) { put(key, value); }
  template <class Enum>
  void choice(const char* key, Enum value, std::span<const char* const> words, const char*)
  {
    put(key, words[static_cast<std::size_t>(value)]);
  }
  void text(const char* key, const std::string& value, const char*) { put(key, validUtf8(value)); }
  void ellipsoid(const char* key, const Ellipsoid& value, const char*) { put(key, ellipsoidOf(value)); }
};

struct FieldReader {
  const View& object;
  std::vector<std::string> known{};
  bool knows(const char* key)
  {
    known.emplace_back(key);
    return object.has(key);
  }
  void flag(const char* key, bool& value, const char*)
  {
    if (knows(key)) value = object[key].boolean();
  }
  void count(const char* key, Index& value, const char*)
  {
    if (knows(key)) value = object[key].integer(0, std::numeric_limits<Index>::max());
  }
  void number(const char* key, double& value, const char*, const char*)
  {
    if (knows(key)) value = object[key].number(Range::NotNegative);
  }
  template <class Enum>
  void choice(const char* key, Enum& value, std::span<const char* const> words, const char*)
  {
    if (knows(key)) value = Enum(object[key].choice(words));
  }
  void text(const char* key, std::string& value, const char*)
  {
    if (knows(key)) value = object[key].text();
  }
  void ellipsoid(const char* key, Ellipsoid& value, const char*)
  {
    if (!knows(key)) return;
    object[key].expectKeys({"centre", "semi_axes", "rotation"});
    value = readEllipsoid(object[key]);
  }
};

/// One group of options under `key`, if it is not the default.
template <class Options, class Visit>
void addGroup(Json& source, const char* key, const Options& options, const Visit& visit)
{
  const Options usual;
  if (options == usual) return;
  Json usualFields = Json::object(), fields = Json::object();
  visit(usual, FieldWriter{usualFields});
  visit(options, FieldWriter{fields, &usualFields});
  source[key] = std::move(fields);
}

template <class Options, class Visit>
void readGroup(const View& source, const char* key, Options& options, const Visit& visit)
{
  if (!source.has(key)) return;
  const View group = source[key];
  FieldReader reader{group};
  visit(options, reader);
  for (const std::string& present : group.keys())
    if (std::find(reader.known.begin(), reader.known.end(), present) == reader.known.end())
      group.complain("has the unknown key " + Json(present).dump());
}

constexpr auto kVisitRepair = [](auto& options, auto&& visitor) { visitRepairOptions(options, visitor); };
constexpr auto kVisitSupport = [](auto& options, auto&& visitor) { visitSupportOptions(options, visitor); };
constexpr auto kVisitMaterial = [](auto& options, auto&& visitor) { visitMaterialOptions(options, visitor); };

// JSON numbers are doubles to many readers, so 64 bits go as text.
std::string hexOf(std::uint64_t value)
{
  char digits[17] = {};
  std::to_chars(digits, digits + 16, value, 16);
  return digits;
}

std::uint64_t readFingerprint(const View& value)
{
  const std::string text = value.text();
  std::uint64_t number = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number, 16);
  if (value.sound() && (fault != std::errc{} || end != text.data() + text.size() || number == 0))
    value.mustBe("a fingerprint: 1 to 16 hexadecimal digits, not all of them 0");
  return number;
}

Json fileOf(const SourceFile& file)
{
  Json object = {{"file", validUtf8(file.name)}};
  if (file.fingerprint != 0) object["fingerprint"] = hexOf(file.fingerprint);
  return object;
}

SourceFile readFile(const View& object)
{
  SourceFile file;
  file.name = object["file"].text();
  if (object.has("fingerprint")) file.fingerprint = readFingerprint(object["fingerprint"]);
  return file;
}

} // namespace

Json sourceOf(const ImportRecipe& recipe)
{
  Json source = fileOf(recipe.files.empty() ? SourceFile{} : recipe.files.front());
  if (recipe.files.size() > 1) {
    Json more = Json::array();
    for (std::size_t i = 1; i < recipe.files.size(); ++i) more.push_back(fileOf(recipe.files[i]));
    source["more_files"] = std::move(more);
  }
  source["unit"] = wordOf(recipe.unit, kUnits);
  source["up"] = wordOf(recipe.up, kUp);
  if (recipe.patientAxes != PatientAxes::None)
    source["patient_axes"] = wordOf(recipe.patientAxes, kPatientAxes);
  if (recipe.ignoreStated) source["ignore_stated"] = true;
  source["weld_tolerance"] = recipe.weldTolerance;
  if (recipe.polygons != PolygonSprings::Triangulated)
    source["polygons"] = wordOf(recipe.polygons, kPolygons);
  addGroup(source, "repair", recipe.repair, kVisitRepair);
  addGroup(source, "support", recipe.support, kVisitSupport);
  addGroup(source, "material", recipe.material, kVisitMaterial);
  return source;
}

ImportRecipe readSource(const View& object, bool alone)
{
  if (alone)
    object.expectKeys({"format"},
                      {"file", "fingerprint", "more_files", "unit", "up", "patient_axes", "ignore_stated",
                       "weld_tolerance", "polygons", "repair", "support", "material"});
  else
    object.expectKeys({"file", "unit", "up", "weld_tolerance"},
                      {"fingerprint", "more_files", "patient_axes", "ignore_stated", "polygons", "repair",
                       "support", "material"});
  ImportRecipe recipe;
  if (object.has("file"))
    if (SourceFile first = readFile(object); !first.name.empty()) recipe.files.push_back(std::move(first));
  if (object.has("more_files")) {
    const View more = object["more_files"];
    for (std::size_t i = 0; i < more.size() && more.sound(); ++i) {
      more[i].expectKeys({"file"}, {"fingerprint"});
      recipe.files.push_back(readFile(more[i]));
    }
  }
  if (object.has("unit")) recipe.unit = LengthUnit(object["unit"].choice(kUnits));
  if (object.has("up")) recipe.up = UpAxis(object["up"].choice(kUp));
  if (object.has("patient_axes"))
    recipe.patientAxes = PatientAxes(object["patient_axes"].choice(kPatientAxes));
  if (object.has("ignore_stated")) recipe.ignoreStated = object["ignore_stated"].boolean();
  if (object.has("weld_tolerance")) recipe.weldTolerance = object["weld_tolerance"].number();
  if (object.has("polygons")) recipe.polygons = PolygonSprings(object["polygons"].choice(kPolygons));
  readGroup(object, "repair", recipe.repair, kVisitRepair);
  readGroup(object, "support", recipe.support, kVisitSupport);
  readGroup(object, "material", recipe.material, kVisitMaterial);
  return recipe;
}

} // namespace esm::json
