#include "frf/mat_module/mat_v5_sparse.hpp"

#include <matio.h>

#include <cstdint>
#include <span>

namespace jointid::frf::mat {
namespace {

template <class T>
std::vector<Complex> elements(const matvar_t& variable, const mat_sparse_t& sparse) {
  const auto part = [&](const void* data) { return std::span(static_cast<const T*>(data), data != nullptr ? sparse.ndata : 0); };
  std::vector<Complex> out;
  if (variable.isComplex == 0) {
    for (const T value : part(sparse.data)) out.emplace_back(static_cast<double>(value));
    return out;
  }
  const auto* split = static_cast<const mat_complex_split_t*>(sparse.data);
  if (split == nullptr || split->Re == nullptr || split->Im == nullptr) return {};
  const auto re = part(split->Re), im = part(split->Im);
  for (std::size_t i = 0; i < re.size(); ++i) out.emplace_back(static_cast<double>(re[i]), static_cast<double>(im[i]));
  return out;
}

std::vector<Complex> elements(const matvar_t& variable, const mat_sparse_t& sparse) {
  switch (variable.data_type) {
    case MAT_T_SINGLE:
      return elements<float>(variable, sparse);
    case MAT_T_INT8:
      return elements<std::int8_t>(variable, sparse);
    case MAT_T_UINT8:
      return elements<std::uint8_t>(variable, sparse);
    case MAT_T_INT16:
      return elements<std::int16_t>(variable, sparse);
    case MAT_T_UINT16:
      return elements<std::uint16_t>(variable, sparse);
    case MAT_T_INT32:
      return elements<std::int32_t>(variable, sparse);
    case MAT_T_UINT32:
      return elements<std::uint32_t>(variable, sparse);
    case MAT_T_INT64:
      return elements<std::int64_t>(variable, sparse);
    case MAT_T_UINT64:
      return elements<std::uint64_t>(variable, sparse);
    default:
      return elements<double>(variable, sparse);
  }
}

std::vector<Complex> places(const mat_uint32_t* from, std::size_t count) {
  return from != nullptr ? std::vector<Complex>(from, from + count) : std::vector<Complex>();
}

}  // namespace

std::vector<MatInfo> sparse_infos(const matvar_t& variable, const std::string& name) {
  const std::size_t room = variable.nbytes, columns = variable.rank == 2 && variable.dims != nullptr ? variable.dims[1] : 0;
  return {{.name = name + ".data", .kind = MatKind::sparse, .dims = {room, 1}},
          {.name = name + ".ir", .kind = MatKind::sparse, .dims = {room, 1}, .integers = true},
          {.name = name + ".jc", .kind = MatKind::sparse, .dims = {columns + 1, 1}, .integers = true},
          {.name = name + ".shape", .kind = MatKind::sparse, .dims = {2, 1}, .integers = true}};
}

std::vector<Complex> sparse_numbers(const matvar_t& variable, std::string_view part) {
  if (part == "shape") return {variable.dims, variable.dims + variable.rank};
  const auto* sparse = static_cast<const mat_sparse_t*>(variable.data);
  if (sparse == nullptr) return {};
  if (part == "data") return elements(variable, *sparse);
  return part == "ir" ? places(sparse->ir, sparse->nir) : places(sparse->jc, sparse->njc);
}

}  // namespace jointid::frf::mat
