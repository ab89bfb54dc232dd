#include "frf/npy/npy_file.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "frf/mat/mat_reader.hpp"
#include "frf/npy/npy_array.hpp"
#include "frf/npy/npy_records.hpp"
#include "frf/npy/npz_archive.hpp"
#include "frf/text/number_text.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t most_bytes = std::uint64_t{2} << 30;
constexpr std::uint64_t usual_header = 512;
constexpr std::string_view ending = ".npy";

[[noreturn]] void fail_file(const std::string& file, std::string problem, std::string remedy) {
  throw InputError(
      {.kind = ErrorKind::data, .file = file, .place = {}, .problem = std::move(problem), .remedy = std::move(remedy)});
}

std::string read_whole(const fs::path& path) {
  if (const std::uint64_t size = fs::file_size(path); size > most_bytes)
    fail_file(path.string(), std::to_string(size >> 20) + " MiB are more than the 2048 MiB that are read into memory",
              "store the FRFs as jointid-frf HDF5");
  return read_text(path);
}

/// Arrays whose last index is the fastest.
class NumpyFile : public MatFile {
 public:
  using MatFile::MatFile;
  bool last_index_fastest() const override { return true; }
};

/// `count` elements of an array after its header, of which the file must hold just so many.
std::string_view elements_of(const NpyHeader& header, std::string_view bytes, const std::string& file) {
  const std::size_t size = npy_bytes(header, file);
  if (bytes.size() - header.begin != size) {
    fail_npy(file,
             "declares " + std::to_string(size) + " bytes of numbers and the file holds " +
                 std::to_string(bytes.size() - header.begin),
             "copy the file again");
  }
  return bytes.substr(header.begin);
}

class NpzFile final : public NumpyFile {
 public:
  explicit NpzFile(const fs::path& path) : NumpyFile(path.string()), bytes_(read_whole(path)) {
    for (NpzEntry& entry : npz_entries(bytes_, file_)) {
      if (!entry.name.ends_with(ending)) continue;
      const std::string own = file_ + ": " + entry.name;
      std::string head = npz_bytes(entry, usual_header, file_);
      NpyHeader header;
      if (head.size() < usual_header || head.find('}') != std::string::npos) {
        header = parse_npy_header(head, own);
      } else {
        header = parse_npy_header(npz_bytes(entry, longest_npy_header, file_), own);
      }
      if (!header.fields.empty() && !are_functions(header)) fail_records(own);
      variables_.push_back(npy_info(header, entry.name.substr(0, entry.name.size() - ending.size())));
      arrays_.push_back({std::move(header), std::move(entry)});
    }
    require_distinct_names();
    if (variables_.empty())
      fail_file(file_, "is a zip archive without arrays of numpy", "give one that numpy.savez() wrote; save a workbook as CSV");
  }

  MatVariable read_variable(const MatInfo& info) override {
    const auto found = std::ranges::find(variables_, info.name, &MatInfo::name);
    const auto& [header, entry] = arrays_[static_cast<std::size_t>(found - variables_.begin())];
    const std::string bytes = npz_bytes(entry, file_);
    return npy_variable(header, info, elements_of(header, bytes, file_ + ": " + entry.name));
  }

  /// Of functions that one of the arrays holds as records; nothing where none does. Beside it SDynPy says of which type they are.
  std::optional<FrfSet> functions(const OpenOptions& options) {
    constexpr double frf = 4.0;
    const auto found = std::ranges::find_if(arrays_, [](const auto& array) { return !array.first.fields.empty(); });
    if (found == arrays_.end()) return std::nullopt;
    for (const MatInfo& info : variables_) {
      if (info.name != "function_type" || info.kind != MatKind::real) continue;
      const std::vector<Complex> values = read(info).values;
      if (!values.empty() && values.front() != frf)
        fail_file(file_, "holds functions of type " + std::to_string(static_cast<int>(values.front().real())) + ", and an FRF is of type 4",
                  "save frequency response functions");
    }
    const std::string bytes = npz_bytes(found->second, file_);
    return read_functions(found->first, elements_of(found->first, bytes, file_ + ": " + found->second.name), file_, options);
  }

 private:
  std::string bytes_;
  std::vector<std::pair<NpyHeader, NpzEntry>> arrays_;  ///< as variables_
};

/// The array of one file; of FRFs besides the frequencies of another.
class NpyFile final : public NumpyFile {
 public:
  NpyFile(const std::string& name, const fs::path& path) : NumpyFile(path.string()) { add(name, path); }

  void add(const std::string& name, const fs::path& path) {
    std::string bytes = read_whole(path);
    NpyHeader header = parse_npy_header(bytes, path.string());
    elements_of(header, bytes, path.string());
    variables_.push_back(npy_info(header, name));
    arrays_.emplace_back(std::move(header), std::move(bytes));
  }

  std::optional<FrfSet> functions(const OpenOptions& options) const {
    const auto& [header, bytes] = arrays_.front();
    if (header.fields.empty()) return std::nullopt;
    if (!are_functions(header)) fail_records(file_);
    return read_functions(header, std::string_view(bytes).substr(header.begin), file_, options);
  }

  MatVariable read_variable(const MatInfo& info) override {
    const auto& [header, bytes] = arrays_[info.name == variables_.front().name ? 0 : 1];
    return npy_variable(header, info, std::string_view(bytes).substr(header.begin));
  }

 private:
  std::vector<std::pair<NpyHeader, std::string>> arrays_;
};

/// A file that is named beside another one.
fs::path beside(const fs::path& path, const std::string& name) {
  const fs::path near = path.parent_path() / name;
  return fs::exists(near) ? near : fs::path(name);
}

}  // namespace

bool looks_like_npz(std::string_view head) {
  constexpr std::size_t name_at = 30;
  if (!head.starts_with("PK\x03\x04") || head.size() < name_at) return false;
  const std::size_t length = static_cast<unsigned char>(head[26]) + 256U * static_cast<unsigned char>(head[27]);
  return head.substr(name_at, length).ends_with(ending);
}

std::unique_ptr<FrfSource> open_npz(const fs::path& path, const OpenOptions& options) {
  NpzFile file(path);
  if (auto functions = file.functions(options)) return from_memory(std::move(*functions));
  return from_memory(read_mat_frfs(file, options));
}

std::unique_ptr<FrfSource> open_npy(const fs::path& path, const OpenOptions& options) {
  NpyFile file("frf", path);
  if (auto functions = file.functions(options)) return from_memory(std::move(*functions));
  if (!options.variable.empty())
    fail_file(path.string(), "a variable is named, and the file holds one array", "leave out --variable, in a scene variable");
  if (file.variables().front().kind != MatKind::complex) {
    fail_file(path.string(), "holds no complex numbers, and an FRF without a phase is none",
              "save complex FRFs; of time records `jointid frf` makes them");
  }
  if (options.frequency_variable.empty()) {
    fail_file(path.string(), "holds one array and no frequencies",
              "name the .npy file of these, --frequency-variable frequency.npy, in a scene frequency_variable; or save both with "
              "numpy.savez()");
  }
  const fs::path axis = beside(path, options.frequency_variable);
  if (!fs::is_regular_file(axis)) fail_file(axis.string(), "there is no such file of frequencies", "check its path");
  const std::string stem = axis.stem().string();  // may state the unit, as "omega" and "freq_khz" do
  OpenOptions own = options;
  own.frequency_variable = stem.empty() || lower_case(stem) == "frf" ? "frequency" : stem;
  file.add(own.frequency_variable, axis);
  return from_memory(read_mat_frfs(file, own));
}

std::unique_ptr<MatFile> open_npz_variables(const fs::path& path) { return std::make_unique<NpzFile>(path); }

std::unique_ptr<MatFile> open_npy_variable(const fs::path& path) { return std::make_unique<NpyFile>(path.stem().string(), path); }

}  // namespace jointid::frf
