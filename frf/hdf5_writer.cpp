#include "frf/hdf5_writer.hpp"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <string>
#include <vector>

#include "frf/error.hpp"
#include "frf/hdf5_disk.hpp"
#include "frf/hdf5_object.hpp"
#include "frf/line_scale.hpp"
#include "frf/temporary_file.hpp"

namespace jointid::frf {
namespace {

using hdf5::Handle;

constexpr std::size_t chunk_bytes = std::size_t{512} << 10;

std::size_t choose_lines_per_chunk(const FrfHeader& header, std::size_t asked) {
  const std::size_t line_bytes = header.entries() * sizeof(Complex);
  const std::size_t lines = asked != 0 ? asked : (chunk_bytes + line_bytes / 2) / line_bytes;
  return std::clamp<std::size_t>(lines, 1, header.lines());
}

Handle text_type() {
  Handle type(H5Tcopy(H5T_C_S1));
  H5Tset_size(type.get(), H5T_VARIABLE);
  H5Tset_cset(type.get(), H5T_CSET_UTF8);
  return type;
}

bool write_attribute(const Handle& object, const char* name, const Handle& type, const void* value) {
  const Handle scalar(H5Screate(H5S_SCALAR));
  const Handle attribute(H5Acreate2(object.get(), name, type.get(), scalar.get(), H5P_DEFAULT, H5P_DEFAULT));
  return attribute.is_open() && H5Awrite(attribute.get(), type.get(), value) >= 0;
}

bool write_text_attribute(const Handle& object, const char* name, const std::string& text) {
  const char* value = text.c_str();
  return write_attribute(object, name, text_type(), &value);
}

/// Writes a small dataset whole and returns it open.
Handle write_dataset(const Handle& file, const char* name, const Handle& type, std::vector<hsize_t> dims,
                     const void* data) {
  const Handle space(H5Screate_simple(static_cast<int>(dims.size()), dims.data(), nullptr));
  Handle dataset(
      H5Dcreate2(file.get(), name, type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  const bool ok =
      dataset.is_open() && H5Dwrite(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, data) >= 0;
  return ok ? std::move(dataset) : Handle();
}

bool write_dofs(const Handle& file, const char* name, const std::vector<Dof>& dofs) {
  std::vector<std::string> names;
  for (const Dof& dof : dofs) names.push_back(dof.name());
  std::vector<const char*> pointers;
  for (const std::string& text : names) pointers.push_back(text.c_str());
  return write_dataset(file, name, text_type(), {dofs.size()}, pointers.data()).is_open();
}

bool write_nodes(const Handle& file, const std::vector<Node>& nodes) {
  if (nodes.empty()) return true;
  std::vector<std::int64_t> ids;
  std::vector<double> positions;
  for (const Node& node : nodes) {
    ids.push_back(node.id);
    positions.insert(positions.end(), node.position.begin(), node.position.end());
  }
  const Handle integer(H5Tcopy(H5T_NATIVE_INT64));
  const Handle real(H5Tcopy(H5T_NATIVE_DOUBLE));
  return write_dataset(file, "node_id", integer, {ids.size()}, ids.data()).is_open() &&
         write_dataset(file, "node_position", real, {ids.size(), 3}, positions.data()).is_open();
}

/// Creates an empty dataset [F,R,C] chunked by whole lines.
Handle create_lines(const Handle& file, const char* name, const Handle& type,
                    const std::array<hsize_t, 3>& dims, std::size_t lines_per_chunk, int compression) {
  const std::array<hsize_t, 3> chunk = {lines_per_chunk, dims[1], dims[2]};
  const Handle create(H5Pcreate(H5P_DATASET_CREATE));
  const Handle access(H5Pcreate(H5P_DATASET_ACCESS));
  const Handle space(H5Screate_simple(3, dims.data(), nullptr));
  H5Pset_chunk(create.get(), 3, chunk.data());
  H5Pset_fill_time(create.get(), H5D_FILL_TIME_NEVER);
  // A chunk begun by one call and completed by the next must stay in memory, or it is compressed twice.
  H5Pset_chunk_cache(access.get(), 101, 2 * chunk[0] * chunk[1] * chunk[2] * sizeof(Complex), 1.0);
  if (compression > 0) {
    H5Pset_shuffle(create.get());
    H5Pset_deflate(create.get(), static_cast<unsigned>(compression));
  }
  return Handle(
      H5Dcreate2(file.get(), name, type.get(), space.get(), H5P_DEFAULT, create.get(), access.get()));
}

void validate(const Hdf5WriteOptions& options) {
  if (options.compression >= 0 && options.compression <= 9) return;
  throw InputError({.kind = ErrorKind::usage,
                    .file = {},
                    .place = "compression",
                    .problem = std::to_string(options.compression) + " is not a deflate level",
                    .remedy = "use 0 to 9"});
}

}  // namespace

class Hdf5Writer::File {
 public:
  File(const std::filesystem::path& path, const FrfHeader& header, const Hdf5WriteOptions& options)
      : temporary_(path),
        header_(header),
        quantity_(options.quantity.value_or(header.quantity)),
        lines_per_chunk_(choose_lines_per_chunk(header, options.lines_per_chunk)),
        written_(header.lines(), false) {
    file_ = hdf5::create_file(temporary_.path(), disk_error_);
    require(file_.is_open() && write_header() && create_datasets(options.compression));
  }

  std::size_t lines_per_chunk() const { return lines_per_chunk_; }

  void write_lines(std::size_t first, std::size_t count, std::span<const Complex> values,
                   std::span<const Complex> variance, std::span<const double> coherence) {
    assert(first + count <= header_.lines() && values.size() == count * header_.entries());
    assert(variance.size() == (header_.noise == NoiseRecord::variance ? values.size() : 0));
    assert(coherence.size() == (header_.noise == NoiseRecord::coherence ? values.size() : 0));
    write_scaled(frf_, first, count, values, [](const LineScale& s, Complex h) { return s.value(h); });
    if (!variance.empty()) {
      write_scaled(noise_, first, count, variance,
                   [](const LineScale& s, Complex v) { return s.variance(v); });
    }
    if (!coherence.empty()) {
      require(write_slab(noise_, Handle(H5Tcopy(H5T_NATIVE_DOUBLE)), first, count, coherence.data()));
    }
    std::fill_n(written_.begin() + static_cast<std::ptrdiff_t>(first), count, true);
  }

  void finish() {
    const auto missing = std::find(written_.begin(), written_.end(), false);
    if (missing != written_.end()) {
      temporary_.fail("line " + std::to_string(missing - written_.begin() + 1) + " was never written");
    }
    const bool closed = frf_.close() && noise_.close() && file_.close();
    require(closed);
    temporary_.commit();
  }

 private:
  void require(bool ok) const {
    if (disk_error_ != 0) temporary_.fail(std::strerror(disk_error_));
    if (!ok) temporary_.fail(hdf5::last_failure());
  }

  bool write_header() const {
    const Handle integer(H5Tcopy(H5T_NATIVE_INT64));
    const Handle real(H5Tcopy(H5T_NATIVE_DOUBLE));
    const std::int64_t version = 1;
    const Handle axis =
        write_dataset(file_, "frequency", real, {header_.lines()}, header_.frequency_hz.data());
    return axis.is_open() && write_text_attribute(axis, "unit", "Hz") &&
           write_text_attribute(file_, "format", "jointid-frf") &&
           write_attribute(file_, "version", integer, &version) &&
           write_dofs(file_, "response_dof", header_.response) &&
           write_dofs(file_, "reference_dof", header_.reference) && write_nodes(file_, header_.nodes);
  }

  bool create_datasets(int compression) {
    const std::array<hsize_t, 3> dims = {header_.lines(), header_.response.size(), header_.reference.size()};
    const Handle complex = hdf5::complex_type();
    const Handle real(H5Tcopy(H5T_NATIVE_DOUBLE));
    frf_ = create_lines(file_, "frf", complex, dims, lines_per_chunk_, compression);
    bool ok = frf_.is_open() && write_text_attribute(frf_, "quantity", name(quantity_)) &&
              write_text_attribute(frf_, "unit", unit(quantity_));
    if (ok && header_.noise == NoiseRecord::variance) {
      noise_ = create_lines(file_, "variance", complex, dims, lines_per_chunk_, compression);
      ok = noise_.is_open();
    } else if (ok && header_.noise == NoiseRecord::coherence) {
      noise_ = create_lines(file_, "coherence", real, dims, lines_per_chunk_, compression);
      ok = noise_.is_open() && write_attribute(noise_, "averages", real, &header_.averages);
    }
    return ok;
  }

  /// Writes receptances (or their variances) in the stored quantity; `scale(line scale, value)` converts one.
  template <class Scale>
  void write_scaled(const Handle& dataset, std::size_t first, std::size_t count,
                    std::span<const Complex> values, Scale scale) {
    const Complex* data = values.data();
    if (quantity_ != Quantity::receptance) {
      scaled_.clear();
      for (std::size_t line = 0; line < count; ++line) {
        const LineScale of_line = LineScale::from_receptance(quantity_, header_.frequency_hz[first + line]);
        for (const Complex& value : values.subspan(line * header_.entries(), header_.entries())) {
          scaled_.push_back(scale(of_line, value));
        }
      }
      data = scaled_.data();
    }
    require(write_slab(dataset, hdf5::complex_type(), first, count, data));
  }

  bool write_slab(const Handle& dataset, const Handle& type, std::size_t first, std::size_t count,
                  const void* data) const {
    const std::array<hsize_t, 3> start = {first, 0, 0};
    const std::array<hsize_t, 3> extent = {count, header_.response.size(), header_.reference.size()};
    const Handle in_file(H5Dget_space(dataset.get()));
    const Handle in_memory(H5Screate_simple(3, extent.data(), nullptr));
    return H5Sselect_hyperslab(in_file.get(), H5S_SELECT_SET, start.data(), nullptr, extent.data(),
                               nullptr) >= 0 &&
           H5Dwrite(dataset.get(), type.get(), in_memory.get(), in_file.get(), H5P_DEFAULT, data) >= 0;
  }

  TemporaryFile temporary_;
  FrfHeader header_;
  Quantity quantity_;
  std::size_t lines_per_chunk_;
  std::vector<bool> written_;
  int disk_error_ = 0;  ///< before the file, which reports to it until closed
  Handle file_;
  Handle frf_;
  Handle noise_;
  std::vector<Complex> scaled_;
};

Hdf5Writer::Hdf5Writer(const std::filesystem::path& path, const FrfHeader& header,
                       const Hdf5WriteOptions& options) {
  validate(header);
  validate(options);
  const hdf5::Silence silence;
  file_ = std::make_unique<File>(path, header, options);
}

Hdf5Writer::~Hdf5Writer() {
  const hdf5::Silence silence;
  file_.reset();
}

void Hdf5Writer::write_lines(std::size_t first, std::size_t count, std::span<const Complex> values,
                             std::span<const Complex> variance, std::span<const double> coherence) {
  const hdf5::Silence silence;
  if (count > 0) file_->write_lines(first, count, values, variance, coherence);
}

void Hdf5Writer::finish() {
  const hdf5::Silence silence;
  file_->finish();
}

std::size_t Hdf5Writer::lines_per_chunk() const { return file_->lines_per_chunk(); }

void write_hdf5(const FrfSet& set, const std::filesystem::path& path, const Hdf5WriteOptions& options) {
  Hdf5Writer writer(path, set.header, options);
  writer.write_lines(0, set.header.lines(), set.values, set.variance, set.coherence);
  writer.finish();
}

}  // namespace jointid::frf
