#include <matio.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <functional>
#include <iterator>
#include <numeric>
#include <span>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "frf/mat_module/files.hpp"
#include "frf/mat_module/mat_v5_check.hpp"
#include "frf/mat_module/mat_v5_sparse.hpp"
#include "frf/text/label_text.hpp"

namespace jointid::frf {
namespace {

struct CloseMat {
  void operator()(mat_t* mat) const { Mat_Close(mat); }
};
struct FreeVariable {
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using Mat = std::unique_ptr<mat_t, CloseMat>;
using Variable = std::unique_ptr<matvar_t, FreeVariable>;

std::vector<std::size_t> dims_of(const matvar_t& variable) {
  if (variable.rank <= 0 || variable.dims == nullptr) return {};
  return {variable.dims, variable.dims + variable.rank};
}

std::size_t size(const matvar_t& variable) {
  const std::vector<std::size_t> dims = dims_of(variable);
  return std::accumulate(dims.begin(), dims.end(), std::size_t{1}, std::multiplies<>());
}

MatKind kind_of(const matvar_t& variable) {
  switch (variable.class_type) {
    case MAT_C_CHAR:
    case MAT_C_CELL:
      return MatKind::text;
    case MAT_C_DOUBLE:
    case MAT_C_SINGLE:
    case MAT_C_INT8:
    case MAT_C_UINT8:
    case MAT_C_INT16:
    case MAT_C_UINT16:
    case MAT_C_INT32:
    case MAT_C_UINT32:
    case MAT_C_INT64:
    case MAT_C_UINT64:
      return variable.isComplex != 0 ? MatKind::complex : MatKind::real;
    default:
      return MatKind::other;
  }
}

bool has_integers(const matvar_t& variable) {
  const bool number = kind_of(variable) == MatKind::real || kind_of(variable) == MatKind::complex;
  return number && variable.class_type != MAT_C_DOUBLE && variable.class_type != MAT_C_SINGLE;
}

template <class T>
std::vector<Complex> convert(const matvar_t& variable) {
  std::vector<Complex> values(size(variable));
  const auto part = [&](const void* data) { return std::span(static_cast<const T*>(data), values.size()); };
  if (variable.isComplex != 0) {
    const auto* split = static_cast<const mat_complex_split_t*>(variable.data);
    const auto re = part(split->Re);
    const auto im = part(split->Im);
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = {static_cast<double>(re[i]), static_cast<double>(im[i])};
    }
  } else {
    const auto re = part(variable.data);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(re[i]);
  }
  return values;
}

std::vector<Complex> numbers(const matvar_t& variable) {
  switch (variable.class_type) {
    case MAT_C_SINGLE:
      return convert<float>(variable);
    case MAT_C_INT8:
      return convert<std::int8_t>(variable);
    case MAT_C_UINT8:
      return convert<std::uint8_t>(variable);
    case MAT_C_INT16:
      return convert<std::int16_t>(variable);
    case MAT_C_UINT16:
      return convert<std::uint16_t>(variable);
    case MAT_C_INT32:
      return convert<std::int32_t>(variable);
    case MAT_C_UINT32:
      return convert<std::uint32_t>(variable);
    case MAT_C_INT64:
      return convert<std::int64_t>(variable);
    case MAT_C_UINT64:
      return convert<std::uint64_t>(variable);
    default:
      return convert<double>(variable);
  }
}

/// Rows of a character array in UTF-8; without NULs, which fill some.
std::vector<std::string> characters(const matvar_t& variable) {
  const std::vector<std::size_t> dims = dims_of(variable);
  const auto width = static_cast<std::size_t>(variable.data_size);
  if (variable.data == nullptr || width == 0) return {""};
  const std::size_t count = std::min(size(variable), variable.nbytes / width);
  const std::size_t rows = dims.empty() ? 0 : dims[0];
  if (rows == 0 || rows > count) return {""};
  const auto* bytes = static_cast<const unsigned char*>(variable.data);
  std::vector<std::string> texts(rows);
  if (rows == 1 && variable.data_type == MAT_T_UTF8) {
    texts[0].assign(reinterpret_cast<const char*>(bytes), variable.nbytes);
    std::erase(texts[0], '\0');
    return texts;
  }
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t code = bytes[i * width];
    if (width > 1) code += 256u * bytes[i * width + 1];
    if (code > 0) append_utf8(texts[i % rows], code);
  }
  return texts;
}

constexpr int deepest_struct = 8;

/// A struct, or an array of complex numbers.
bool may_hold_frfs(const matvar_t* cell) {
  if (cell == nullptr) return false;
  return cell->class_type == MAT_C_STRUCT ? size(*cell) == 1 : kind_of(*cell) == MatKind::complex && size(*cell) > 1;
}

/// The variable, of a struct its fields under S.field, of an array of structs (or a cell array of them) under S(2).field, of a cell array
/// of complex arrays these under H(2), of a sparse matrix its arrays.
void list(matvar_t& variable, const std::string& name, int depth, std::vector<MatInfo>& out) {
  if (variable.class_type == MAT_C_SPARSE) {
    std::ranges::move(mat::sparse_infos(variable, name), std::back_inserter(out));
    return;
  }
  out.push_back({.name = name, .kind = kind_of(variable), .dims = dims_of(variable), .integers = has_integers(variable)});
  if (depth == deepest_struct) return;
  if (variable.class_type == MAT_C_CELL) {
    for (std::size_t i = 0; i < size(variable); ++i) {
      if (!may_hold_frfs(Mat_VarGetCell(&variable, static_cast<int>(i)))) return;  // of texts and numbers
    }
    for (std::size_t i = 0; i < size(variable); ++i) {
      matvar_t* cell = Mat_VarGetCell(&variable, static_cast<int>(i));
      list(*cell, name + "(" + std::to_string(i + 1) + ")", depth + 1, out);
    }
  }
  if (variable.class_type != MAT_C_STRUCT) return;
  char* const* fields = Mat_VarGetStructFieldnames(&variable);
  const std::size_t elements = size(variable);
  for (std::size_t element = 0; element < elements; ++element) {
    const std::string own = elements == 1 ? name : name + "(" + std::to_string(element + 1) + ")";
    for (unsigned i = 0; i < Mat_VarGetNumberOfFields(&variable); ++i) {
      matvar_t* field = Mat_VarGetStructFieldByIndex(&variable, i, element);
      if (field != nullptr && fields[i] != nullptr) list(*field, own + "." + fields[i], depth + 1, out);
    }
  }
}

/// Of a name without a number.
constexpr std::size_t whole = std::string::npos;

/// "S", "S(2)" or "" before the next dot of a name, which is taken off with it: the name and the number of the element, from 0, or whole.
std::pair<std::string, std::size_t> take_part(std::string_view& rest) {
  const std::string_view part = rest.substr(0, std::min(rest.find('.'), rest.size()));
  rest.remove_prefix(std::min(part.size() + 1, rest.size()));
  const std::size_t open = part.find('(');
  std::size_t number = 0;
  const bool has_number = open != std::string_view::npos &&
                          std::from_chars(part.data() + open + 1, part.data() + part.size(), number).ec == std::errc() && number > 0;
  return {std::string(part.substr(0, open)), has_number ? number - 1 : whole};
}

/// A field by its name in list(), or null. `variable` is what stands before the first dot.
matvar_t* field_of(matvar_t* variable, std::string_view name) {
  std::size_t element = take_part(name).second;
  while (variable != nullptr && variable->class_type != MAT_C_SPARSE && (!name.empty() || variable->class_type == MAT_C_CELL)) {
    if (variable->class_type == MAT_C_CELL) {
      if (name.empty() && element == whole) return variable;
      if (element == whole) element = 0;
      if (element >= size(*variable)) return nullptr;
      variable = Mat_VarGetCell(variable, static_cast<int>(element));
      element = whole;
      continue;
    }
    if (element == whole) element = 0;
    if (variable->class_type != MAT_C_STRUCT || element >= size(*variable)) return nullptr;
    const auto [field, next] = take_part(name);
    variable = Mat_VarGetStructFieldByName(variable, field.c_str(), element);
    element = next;
  }
  return variable;
}

class MatV5 final : public MatFile {
 public:
  explicit MatV5(const std::filesystem::path& path)
      : MatFile(path.string()), check_(path), mat_(Mat_Open(file_.c_str(), MAT_ACC_RDONLY)) {
    if (!mat_) fail({}, "cannot be opened as a MATLAB file; it is damaged or truncated");
    while (const Variable next{Mat_VarReadNextInfo(mat_.get())}) {
      if (next->name != nullptr) list(*next, next->name, 0, variables_);
    }
    require_distinct_names();
  }

  MatVariable read_variable(const MatInfo& info) override {
    const std::size_t end = std::min(info.name.find_first_of(".("), info.name.size());
    load(info.name.substr(0, end));
    matvar_t* variable = field_of(loaded_.get(), info.name);
    MatVariable out{.info = info, .values = {}, .texts = {}};
    if (variable != nullptr && variable->class_type == MAT_C_SPARSE) {
      out.values = mat::sparse_numbers(*variable, std::string_view(info.name).substr(info.name.rfind('.') + 1));
      return out;
    }
    if (variable == nullptr || kind_of(*variable) != info.kind || dims_of(*variable) != info.dims) {
      fail(info.name, "cannot be read; the file is damaged or truncated");
    }
    if (info.kind == MatKind::text) {
      out.texts = texts(info, *variable);
    } else {
      require_data(info, *variable);
      out.values = numbers(*variable);
    }
    if (end == info.name.size()) loaded_.reset();
    return out;
  }

 private:
  /// The variable as a whole, in memory until another is wanted: fields of a struct are read with it, once.
  void load(const std::string& name) {
    if (loaded_ && name == loaded_->name) return;
    check_.require_whole(name);
    loaded_.reset(Mat_VarRead(mat_.get(), name.c_str()));
  }

  void require_data(const MatInfo& info, const matvar_t& variable) const {
    const auto* split = static_cast<const mat_complex_split_t*>(variable.data);
    const bool complete = variable.data != nullptr &&
                          (variable.isComplex == 0 || (split->Re != nullptr && split->Im != nullptr)) &&
                          variable.nbytes >= size(variable) * Mat_SizeOfClass(variable.class_type);
    if (!complete) fail(info.name, "holds fewer numbers than it declares; the file is damaged or truncated");
  }

  std::vector<std::string> texts(const MatInfo& info, matvar_t& variable) const {
    if (variable.class_type == MAT_C_CHAR) return characters(variable);
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < size(variable); ++i) {
      const matvar_t* cell = Mat_VarGetCell(&variable, static_cast<int>(i));
      if (cell == nullptr || cell->class_type != MAT_C_CHAR) {
        fail(info.name, "cell " + std::to_string(i + 1) + " is not text",
             "store texts in cells, such as {'4:+Y'; '5:+Y'}, and FRFs as arrays or arrays of structs");
      }
      texts.push_back(characters(*cell).front());
    }
    return texts;
  }

  mat::V5Check check_;
  Mat mat_;
  Variable loaded_;
};

}  // namespace

std::unique_ptr<MatFile> mat::open_file(const std::filesystem::path& path) { return std::make_unique<MatV5>(path); }

}  // namespace jointid::frf
