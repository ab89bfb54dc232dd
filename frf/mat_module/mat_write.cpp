#include <matio.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/stop_scope.hpp"
#include "base/temporary_file.hpp"
#include "frf/mat_module/files.hpp"
#include "frf/mat_module/mat_v5_check.hpp"
#include "frf/set/line_scale.hpp"

namespace jointid::frf {
namespace {

constexpr std::size_t largest_variable = std::size_t{1} << 31;  ///< bytes, of the v5 format

/// Writes variables one after the other and remembers whether all went well.
class MatWriter {
 public:
  explicit MatWriter(const std::filesystem::path& path)
      : mat_(Mat_CreateVer(path.c_str(), "MATLAB 5.0 MAT-file, written by jointid", MAT_FT_MAT5)),
        ok_(mat_ != nullptr) {}
  ~MatWriter() { close(); }
  MatWriter(const MatWriter&) = delete;
  MatWriter& operator=(const MatWriter&) = delete;

  bool close() {
    if (mat_ != nullptr) ok_ = Mat_Close(mat_) == 0 && ok_;
    mat_ = nullptr;
    return ok_;
  }

  const std::vector<std::string>& names() const { return names_; }

  void write_reals(const char* name, std::vector<std::size_t> dims, const std::vector<double>& values) {
    std::vector<double> copy = values;
    write(Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, static_cast<int>(dims.size()), dims.data(),
                        copy.data(), 0));
  }

  void write_complex(const char* name, std::vector<std::size_t> dims, std::vector<double> re,
                     std::vector<double> im) {
    mat_complex_split_t split{re.data(), im.data()};
    write(Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, static_cast<int>(dims.size()), dims.data(), &split,
                        MAT_F_COMPLEX));
  }

  void write_text(const char* name, const std::string& text) { write(character_row(name, text)); }

  void write_dofs(const char* name, const std::vector<Dof>& dofs) {
    std::array<std::size_t, 2> dims = {dofs.size(), 1};
    std::vector<matvar_t*> cells;
    for (const Dof& dof : dofs) cells.push_back(character_row(nullptr, dof.name()));
    write(Mat_VarCreate(name, MAT_C_CELL, MAT_T_CELL, 2, dims.data(), cells.data(), 0));
  }

 private:
  static matvar_t* character_row(const char* name, std::string text) {
    std::array<std::size_t, 2> dims = {1, text.size()};
    return Mat_VarCreate(name, MAT_C_CHAR, MAT_T_UTF8, 2, dims.data(), text.data(), 0);
  }

  void write(matvar_t* variable) {
    ok_ = ok_ && variable != nullptr && Mat_VarWrite(mat_, variable, MAT_COMPRESSION_NONE) == 0;
    if (ok_) names_.emplace_back(variable->name);
    Mat_VarFree(variable);
  }

  mat_t* mat_;
  bool ok_;
  std::vector<std::string> names_;
};

/// Values [F,R,C] of a set in MATLAB's order, each through `of(line, index in the set)`.
template <class T>
std::vector<T> first_index_fastest(const FrfSet& set, const std::function<T(std::size_t, std::size_t)>& of) {
  std::vector<T> out;
  for (std::size_t c = 0; c < set.header.reference.size(); ++c) {
    for (std::size_t r = 0; r < set.header.response.size(); ++r) {
      stop_point();
      for (std::size_t line = 0; line < set.header.lines(); ++line)
        out.push_back(of(line, set.index(line, r, c)));
    }
  }
  return out;
}

template <class Scaled>
void write_scaled(MatWriter& writer, const char* name, const FrfSet& set, Scaled scaled) {
  const FrfHeader& header = set.header;
  const auto part = [&](double (*of)(const Complex&)) {
    return first_index_fastest<double>(set, [&, of](std::size_t line, std::size_t i) {
      return of(scaled(LineScale::from_receptance(header.quantity, header.frequency_hz[line]), i));
    });
  };
  writer.write_complex(name, {header.lines(), header.response.size(), header.reference.size()},
                       part(std::real<double>), part(std::imag<double>));
}

void write_all(MatWriter& writer, const FrfSet& set) {
  const FrfHeader& header = set.header;
  writer.write_reals("frequency", {header.lines(), 1}, header.frequency_hz);
  writer.write_text("quantity", name(header.quantity));
  writer.write_text("unit", unit(header.quantity));
  writer.write_text("axes", "FRC");
  writer.write_dofs("response_dof", header.response);
  writer.write_dofs("reference_dof", header.reference);
  write_scaled(writer, "frf", set, [&](const LineScale& s, std::size_t i) { return s.value(set.values[i]); });
  if (!set.variance.empty()) {
    write_scaled(writer, "variance", set,
                 [&](const LineScale& s, std::size_t i) { return s.variance(set.variance[i]); });
  }
  if (!set.coherence.empty()) {
    if (header.averages > 0.0) writer.write_reals("averages", {1, 1}, {header.averages});
    writer.write_reals(
        "coherence", {header.lines(), header.response.size(), header.reference.size()},
        first_index_fastest<double>(set, [&](std::size_t, std::size_t i) { return set.coherence[i]; }));
  }
}

/// Whether the variables are there, each with as many numbers as its dimensions declare: matio does not notice a disk that is full, and
/// gives a variable that was cut off the size of what is there.
bool holds(const std::filesystem::path& path, const std::vector<std::string>& names) {
  try {
    mat::V5Check check(path);
    for (const std::string& name : names) check.require_whole(name);
    return check.names() == names;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

void mat::write_file(const FrfSet& set, const TemporaryFile& temporary) {
  if (set.values.size() >= largest_variable / sizeof(Complex)) {
    temporary.fail("MATLAB v5 variables end at 2 GB; write HDF5 instead");
  }
  MatWriter writer(temporary.path());
  write_all(writer, set);
  if (!writer.close() || !holds(temporary.path(), writer.names())) {
    temporary.fail("matio did not write all of it");
  }
}

}  // namespace jointid::frf
