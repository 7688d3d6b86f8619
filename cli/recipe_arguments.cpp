// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/recipe_arguments.h"

#include "cli/arguments.h"
#include "core/base/file_io.h"
#include "core/base/text_number.h"
#include "core/project/option_fields.h"

#include <algorithm>
#include <limits>
#include <span>
#include <variant>

namespace esm::cli {

namespace {

using Value = std::variant<bool, Index, double, std::size_t, std::string, Ellipsoid>;

/// Puts a value into the option of that key.
struct Setter {
  std::string_view wanted;
  const Value& value;

  template <class T, class Kind = T>
  void set(const char* key, T& option) const
  {
    if (wanted == key) option = static_cast<T>(std::get<Kind>(value));
  }
  void flag(const char* key, bool& option, const char*) const { set(key, option); }
  void count(const char* key, Index& option, const char*) const { set(key, option); }
  void number(const char* key, double& option, const char*, const char*) const { set(key, option); }
  template <class Enum>
  void choice(const char* key, Enum& option, std::span<const char* const>, const char*) const
  {
    set<Enum, std::size_t>(key, option);
  }
  void text(const char* key, std::string& option, const char*) const { set(key, option); }
  void ellipsoid(const char* key, Ellipsoid& option, const char*) const { set(key, option); }
};

/// Makes one argument of each option.
class ArgumentMaker {
public:
  ArgumentMaker(CLI::App& command, RecipeArguments& arguments) : m_command(command), m_arguments(arguments) {}

  std::string group;

  void flag(const char* key, const bool&, const char* help)
  {
    m_command
      .add_flag_callback(
        argumentOf(key), [arguments = &m_arguments, key] { add(*arguments, key, true); }, help)
      ->group(group);
  }
  void count(const char* key, const Index& usual, const char* help)
  {
    option(key, "INTEGER", withUsual(help, std::to_string(usual), usual == 0),
           [](const std::string& name, const std::string& text) {
             return Value(
               static_cast<Index>(integerArgument(name, text, 0, std::numeric_limits<Index>::max())));
           });
  }
  void number(const char* key, const double& usual, const char* unit, const char* help)
  {
    const std::string what = *unit == '\0' ? help : std::string(help) + " [" + unit + "]";
    option(key, "NUMBER", withUsual(what, formatDouble(usual), usual == 0.0),
           [](const std::string& name, const std::string& text) {
             return Value(numberArgument(name, text, NumberRange::NotNegative));
           });
  }
  template <class Enum>
  void choice(const char* key, const Enum&, std::span<const char* const> words, const char* help)
  {
    const std::vector<std::string> names(words.begin(), words.end());
    option(key, "WORD", help, [names](const std::string&, const std::string& text) {
      return Value(static_cast<std::size_t>(std::find(names.begin(), names.end(), text) - names.begin()));
    })->check(CLI::IsMember(names));
  }
  void text(const char* key, const std::string&, const char* help)
  {
    option(key, "TEXT", help, [](const std::string&, const std::string& text) { return Value(text); });
  }
  void ellipsoid(const char* key, const Ellipsoid&, const char* help)
  {
    option(
      key, "CX,CY,CZ,RX,RY,RZ", std::string(help) + " [m]",
      [](const std::string& name, const std::string& text) { return Value(ellipsoidArgument(name, text)); });
  }

private:
  static std::string argumentOf(std::string_view key)
  {
    std::string name = "--" + std::string(key);
    std::replace(name.begin(), name.end(), '_', '-');
    return name;
  }
  static std::string withUsual(const std::string& help, const std::string& usual, bool isNothing)
  {
    return isNothing ? help : help + " (default " + usual + ")";
  }
  static Ellipsoid ellipsoidArgument(const std::string& name, const std::string& text)
  {
    const std::vector<double> numbers = numbersArgument(name, text, 6, 6);
    Ellipsoid ellipsoid;
    ellipsoid.centre = {numbers[0], numbers[1], numbers[2]};
    ellipsoid.semiAxes = {numbers[3], numbers[4], numbers[5]};
    if (!(ellipsoid.semiAxes.minCoeff() > 0.0))
      throw CLI::ValidationError(name, "\"" + text + "\": the semi-axes must be > 0");
    return ellipsoid;
  }
  static void add(RecipeArguments& arguments, const char* key, Value value)
  {
    arguments.changes.push_back([key, value = std::move(value)](ImportRecipe& recipe) {
      visitRecipeOptions(recipe, Setter{key, value});
    });
  }
  template <class Read>
  CLI::Option* option(const char* key, const char* type, const std::string& help, const Read& read)
  {
    const std::string name = argumentOf(key);
    return m_command
      .add_option_function<std::string>(
        name,
        [arguments = &m_arguments, key, name, read](const std::string& text) {
          add(*arguments, key, read(name, text));
        },
        help)
      ->type_name(type)
      ->group(group);
  }

  CLI::App& m_command;
  RecipeArguments& m_arguments;
};

/// An argument whose word is one of an enumeration's names.
template <class Set>
void addWord(CLI::App& command, RecipeArguments& arguments, const char* name,
             const std::vector<std::string>& words, const char* help, const Set& set)
{
  command
    .add_option_function<std::string>(
      name,
      [&arguments, words, set](const std::string& text) {
        const auto place =
          static_cast<std::size_t>(std::find(words.begin(), words.end(), text) - words.begin());
        arguments.changes.push_back([set, place](ImportRecipe& recipe) { set(recipe, place); });
      },
      help)
    ->check(CLI::IsMember(words));
}

void addWeld(CLI::App& command, RecipeArguments& arguments)
{
  const auto setTolerance = [&arguments](double tolerance) {
    arguments.changes.push_back([tolerance](ImportRecipe& recipe) { recipe.weldTolerance = tolerance; });
  };
  CLI::Option* tolerance = command.add_option_function<std::string>(
    "--weld-tolerance",
    [setTolerance](const std::string& text) {
      setTolerance(numberArgument("--weld-tolerance", text, NumberRange::NotNegative));
    },
    "join vertices within this distance, in the file's unit (default 0: only those at equal places)");
  tolerance->type_name("NUMBER");
  command
    .add_flag_callback(
      "--no-weld", [setTolerance] { setTolerance(-1.0); }, "keep vertices at the same place apart")
    ->excludes(tolerance);
}

} // namespace

Result<ImportRecipe> RecipeArguments::recipe(ImportRecipe usual) const
{
  ImportRecipe recipe = std::move(usual);
  if (!recipeFile.empty()) {
    const Result<std::string> bytes = readFile(recipeFile);
    if (!bytes) return bytes.error();
    Result<ImportRecipe> read = parseRecipe(*bytes, recipeFile);
    if (!read) return read.error();
    recipe = std::move(*read);
  }
  for (const auto& change : changes) change(recipe);
  return recipe;
}

void addRecipeOptions(CLI::App& command, RecipeArguments& arguments)
{
  command.add_option("--recipe", arguments.recipeFile,
                     "start from the choices in this recipe (of --save-recipe) or project; flags go over it");
  addWord(command, arguments, "--unit", {"mm", "cm", "m", "inch"},
          "length unit of meshes that state none themselves (default m)",
          [](ImportRecipe& recipe, std::size_t word) { recipe.unit = LengthUnit(word); });
  addWord(command, arguments, "--up", {"y", "z"}, "axis that points up in meshes that do not say (default z)",
          [](ImportRecipe& recipe, std::size_t word) { recipe.up = UpAxis(word); });
  addWord(command, arguments, "--patient-axes", {"none", "lps", "ras"},
          "the axes are a patient's, in meshes that do not say: lps (DICOM) or ras (NIfTI)",
          [](ImportRecipe& recipe, std::size_t word) { recipe.patientAxes = PatientAxes(word); });
  command.add_flag_callback(
    "--ignore-stated",
    [&arguments] { arguments.changes.push_back([](ImportRecipe& recipe) { recipe.ignoreStated = true; }); },
    "use --unit, --up and --patient-axes for meshes, too, that state their own (COLLADA, glTF, 3MF, DXF, "
    "...)");
  addWeld(command, arguments);
  addWord(command, arguments, "--polygons", {"triangulated", "edges"},
          "springs along the cuts through polygons too (default), or along their edges only",
          [](ImportRecipe& recipe, std::size_t word) { recipe.polygons = PolygonSprings(word); });
  const ImportRecipe usual;
  ArgumentMaker maker(command, arguments);
  maker.group = "Repair";
  visitRepairOptions(usual.repair, maker);
  maker.group = "Support";
  visitSupportOptions(usual.support, maker);
  maker.group = "Material";
  visitMaterialOptions(usual.material, maker);
}

} // namespace esm::cli
