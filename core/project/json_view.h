// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/types.h"
#include "core/project/json_tree.h"

#include <Eigen/Core>

#include <initializer_list>
#include <span>
#include <vector>

namespace esm::json {

/// Which numbers a field takes; every number must be finite.
enum class Range { Any, NotNegative, Positive, ZeroToOne };

/// The first thing that is wrong with a document. Reading goes on with harmless values after it, so that
/// the code that reads needs no branch per field; who reads asks for it at the end.
struct Faults {
  std::string origin; ///< the file's name
  std::optional<Error> first;
};

/// A value in a document being read and the way to it, such as /net/springs/stiffness/17, which every
/// complaint names. Wrong type, shape or range: a complaint, and an empty or smallest allowed value.
class View {
public:
  View(const Json& root, Faults& faults) : m_value(&root), m_faults(&faults) {}

  // === Objects
  /// An object with all of `required`, perhaps some of `optional`, and nothing else.
  void expectKeys(std::initializer_list<const char*> required,
                  std::initializer_list<const char*> optional = {}) const;
  bool has(const char* key) const { return m_value->is_object() && m_value->contains(key); }
  View operator[](const char* key) const; ///< absent: a complaint, and a view of null
  std::vector<std::string> keys() const;  ///< of an object, else a complaint

  // === Lists
  std::size_t size() const;                 ///< of a list; anything else: a complaint, and 0
  void expectSize(std::size_t items) const; ///< of a list; anything else: a complaint
  View operator[](std::size_t item) const;
  bool isList() const { return m_value->is_array(); }
  bool isObject() const { return m_value->is_object(); }
  bool isText() const { return m_value->is_string(); }

  // === Values
  double number(Range range = Range::Any) const;
  Index integer(Index minimum, Index maximum) const;
  bool boolean() const;
  std::string text() const;
  /// The place of the text in `words`, 0 if it is none of them.
  std::size_t choice(std::span<const char* const> words) const;

  // === Whole arrays
  /// `count` numbers; one number alone stands for all of them.
  Eigen::ArrayXd numbers(Index count, Range range = Range::Any) const;
  std::vector<std::size_t> choices(Index count, std::span<const char* const> words) const;
  std::vector<double> numberList(Range range = Range::Any) const; ///< as many as there are
  std::vector<Index> indexList(Index limit) const;                ///< each in [0, limit)
  Eigen::Matrix3Xd points() const;                                ///< flat x0, y0, z0, x1, ...
  Eigen::Vector3d vector() const;                                 ///< [x, y, z]

  /// Complains: "ORIGIN: PATH <text>". Only the first complaint counts.
  void complain(const std::string& text, ErrorCode code = ErrorCode::InvalidValue) const;
  void mustBe(const char* what) const; ///< "... is -3, it must be <what>"
  bool sound() const { return !m_faults->first.has_value(); }

private:
  View(const Json& value, Faults& faults, std::string path)
    : m_value(&value), m_faults(&faults), m_path(std::move(path))
  {}

  const Json* m_value; ///< not owned
  Faults* m_faults;    ///< not owned
  std::string m_path;
};

} // namespace esm::json
