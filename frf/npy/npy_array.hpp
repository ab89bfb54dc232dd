#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "frf/mat/mat_variable.hpp"
#include "frf/npy/npy_header.hpp"

namespace jointid::frf {

/// An array of numpy as a variable of that name, its dims reversed (MatFile::last_index_fastest()).
MatInfo npy_info(const NpyHeader& header, std::string name);

/// Bytes of an array's elements. Throws InputError (data) where that is beyond all memory.
std::size_t npy_bytes(const NpyHeader& header, const std::string& file);

/// The numbers of a field (not of text) of one record, which is NpyHeader::width bytes long.
std::vector<Complex> npy_numbers(const NpyField& field, std::string_view record);

/// Its content, the last index fastest; `elements` are npy_bytes() long. Texts without what NULs pad them with.
MatVariable npy_variable(const NpyHeader& header, MatInfo info, std::string_view elements);

}  // namespace jointid::frf
