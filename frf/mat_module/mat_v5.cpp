#include <matio.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <numeric>
#include <span>
#include <string_view>

#include "base/error.hpp"
#include "frf/mat_module/files.hpp"
#include "frf/mat_module/mat_v5_check.hpp"

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

/// Rows of a character array; codes beyond ASCII become '?'.
std::vector<std::string> characters(const matvar_t& variable) {
  const std::vector<std::size_t> dims = dims_of(variable);
  const auto width = static_cast<std::size_t>(variable.data_size);
  if (variable.data == nullptr || width == 0) return {""};
  const std::size_t count = std::min(size(variable), variable.nbytes / width);
  const std::size_t rows = dims.empty() ? 0 : dims[0];
  if (rows == 0 || rows > count) return {""};
  const auto* bytes = static_cast<const unsigned char*>(variable.data);
  std::vector<std::string> texts(rows);
  for (std::size_t i = 0; i < count; ++i) {
    unsigned code = bytes[i * width];
    if (width > 1) code += 256u * bytes[i * width + 1];
    texts[i % rows] += code > 0 && code < 128 ? static_cast<char>(code) : '?';
  }
  return texts;
}

constexpr int deepest_struct = 8;

/// The variable, and of a struct that stands alone its fields under S.field.
void list(matvar_t& variable, const std::string& name, int depth, std::vector<MatInfo>& out) {
  out.push_back({name, kind_of(variable), dims_of(variable)});
  if (variable.class_type != MAT_C_STRUCT || size(variable) != 1 || depth == deepest_struct) return;
  char* const* fields = Mat_VarGetStructFieldnames(&variable);
  for (unsigned i = 0; i < Mat_VarGetNumberOfFields(&variable); ++i) {
    matvar_t* field = Mat_VarGetStructFieldByIndex(&variable, i, 0);
    if (field != nullptr && fields[i] != nullptr) list(*field, name + "." + fields[i], depth + 1, out);
  }
}

/// A field by the rest of its name, "inner.field", or null.
matvar_t* field_of(matvar_t* variable, std::string_view rest) {
  while (variable != nullptr && !rest.empty()) {
    const std::size_t dot = std::min(rest.find('.'), rest.size());
    if (variable->class_type != MAT_C_STRUCT) return nullptr;
    variable = Mat_VarGetStructFieldByName(variable, std::string(rest.substr(0, dot)).c_str(), 0);
    rest.remove_prefix(std::min(dot + 1, rest.size()));
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
  }

  MatVariable read(const MatInfo& info) override {
    const std::size_t dot = std::min(info.name.find('.'), info.name.size());
    load(info.name.substr(0, dot));
    matvar_t* variable = field_of(loaded_.get(), std::string_view(info.name).substr(std::min(dot + 1, info.name.size())));
    if (variable == nullptr || kind_of(*variable) != info.kind || dims_of(*variable) != info.dims) {
      fail(info.name, "cannot be read; the file is damaged or truncated");
    }
    MatVariable out{.info = info, .values = {}, .texts = {}};
    if (info.kind == MatKind::text) {
      out.texts = texts(info, *variable);
    } else {
      require_data(info, *variable);
      out.values = numbers(*variable);
    }
    if (dot == info.name.size()) loaded_.reset();
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
        fail(info.name, "cell " + std::to_string(i + 1) + " is not text");
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

std::unique_ptr<MatFile> mat::open_file(const std::filesystem::path& path) {
  return std::make_unique<MatV5>(path);
}

}  // namespace jointid::frf
