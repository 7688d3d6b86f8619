// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "meshimport/number_source.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace esm {

/// How a VTK XML file stores its arrays: attributes of VTKFile and AppendedData.
struct VtuStorage {
  std::endian order = std::endian::little;
  Scalar headerType = Scalar::UInt32; ///< of the sizes before binary data
  bool isZipped = false;              ///< vtkZLibDataCompressor
  std::string_view appended;          ///< behind the '_'
  bool isAppendedBase64 = false;
};

/// One DataArray, not decoded yet.
struct VtuArray {
  enum class Format { Ascii, Binary, Appended };
  std::string_view section; ///< Points, Cells, Lines, ...
  std::string_view name;
  Scalar type = Scalar::Float64;
  Format format = Format::Ascii;
  std::uint64_t offset = 0; ///< in the appended data
  std::string_view content; ///< between its tags
};

std::optional<Scalar> vtuScalar(std::string_view name) noexcept; ///< "Float64", "UInt8", ...

/// All values of an array, in place of its bytes. A file that promises more than its bytes can unfold to is
/// refused before anything is allocated. Errors: BadFormat; the sentence has no file name yet.
Result<std::vector<double>> vtuNumbers(const VtuArray& array, const VtuStorage& storage);
Result<std::vector<long long>> vtuIntegers(const VtuArray& array, const VtuStorage& storage);

} // namespace esm
