#include "frf/hdf5_module/hdf5_line_reader.hpp"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <type_traits>

namespace jointid::frf::hdf5 {
namespace {

constexpr std::size_t slab_bytes = std::size_t{4} << 20;       ///< read by one call of H5Dread, about
constexpr std::size_t largest_cache = std::size_t{256} << 20;  ///< for decompressed chunks
constexpr std::size_t smallest_gap = std::size_t{16} << 10;    ///< bytes that are faster skipped than read

bool counts_up(std::span<const std::size_t> indices, std::size_t first) {
  for (const std::size_t index : indices) {
    if (index != first++) return false;
  }
  return true;
}

template <class T>
Handle memory_type() {
  if constexpr (std::is_same_v<T, double>) return Handle(H5Tcopy(H5T_NATIVE_DOUBLE));
  return complex_type();
}

/// Reopens with a chunk cache that holds what is decompressed for one line, so that reading line by line does
/// not decompress a chunk twice; with none where nothing is decompressed, so that HDF5 reads only what is
/// asked for.
void set_cache(const Object& file, const std::string& name, Dataset& dataset, std::size_t element_bytes) {
  const Handle create(H5Dget_create_plist(dataset.id.get()));
  std::array<hsize_t, 3> chunk{};
  if (H5Pget_layout(create.get()) != H5D_CHUNKED || H5Pget_chunk(create.get(), 3, chunk.data()) != 3) return;
  std::size_t bytes = chunk[0] * element_bytes;
  std::size_t chunks = 1;
  for (const std::size_t axis : {1u, 2u}) {
    const std::size_t along = (dataset.dims[axis] - 1) / chunk[axis] + 1;
    chunks *= along;
    bytes *= along * chunk[axis];
  }
  const Handle access(H5Pcreate(H5P_DATASET_ACCESS));
  H5Pset_chunk_cache(access.get(), 10 * chunks + 1, is_filtered(dataset) ? std::min(bytes, largest_cache) : 0,
                     1.0);
  dataset.id = Handle(H5Dopen2(file.id.get(), name.c_str(), access.get()));
  if (!dataset.id.is_open()) fail(dataset, "cannot be opened: " + last_failure());
}

void require_shape(const Dataset& dataset, const std::array<std::size_t, 3>& dims) {
  const std::vector<std::size_t> expected(dims.begin(), dims.end());
  if (dataset.dims == expected) return;
  const auto shown = [](const std::vector<std::size_t>& dims) {
    std::string text = "[";
    for (const std::size_t extent : dims) text += (text.size() > 1 ? "," : "") + std::to_string(extent);
    return text + "]";
  };
  fail(dataset, "has dimensions " + shown(dataset.dims) +
                    " where frequency, response_dof and reference_dof make " + shown(expected),
       "store it as [lines, responses, references]; a covariance has responses · (responses + 1) / 2 pairs in their "
       "place, its factor responses · columns");
}

/// Chunks that were never written would read as zero, a value that nobody measured.
void require_complete(const Dataset& dataset) {
  const Handle create(H5Dget_create_plist(dataset.id.get()));
  std::array<hsize_t, 3> chunk{};
  if (H5Pget_layout(create.get()) != H5D_CHUNKED || H5Pget_chunk(create.get(), 3, chunk.data()) != 3) return;
  hsize_t expected = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) expected *= (dataset.dims[axis] - 1) / chunk[axis] + 1;
  const Handle space(H5Dget_space(dataset.id.get()));
  hsize_t stored = 0;
  if (H5Dget_num_chunks(dataset.id.get(), space.get(), &stored) >= 0 && stored == expected) return;
  fail(dataset, "holds " + std::to_string(stored) + " of " + std::to_string(expected) + " chunks",
       "the file was not written to its end");
}

/// Runs of consecutive rows that cover `rows`, joined across gaps too small to be worth a system call.
struct Run {
  std::size_t first = 0;
  std::size_t count = 0;
};

std::vector<Run> cover(std::span<const std::size_t> rows, std::size_t row_bytes) {
  std::vector<std::size_t> sorted(rows.begin(), rows.end());
  std::ranges::sort(sorted);
  std::vector<Run> runs;
  for (const std::size_t row : sorted) {
    if (runs.empty() ||
        (row - runs.back().first) * row_bytes > runs.back().count * row_bytes + smallest_gap) {
      runs.push_back({row, 1});
    } else {
      runs.back().count = row - runs.back().first + 1;
    }
  }
  return runs;
}

}  // namespace

/// The part of each line that is fetched, and how a block is gathered from it.
template <class T>
struct LineReader<T>::Window {
  std::vector<std::size_t> rows;     ///< start of each response's row within the fetched part, elements
  std::vector<std::size_t> columns;  ///< of each reference within a fetched row
  std::array<std::size_t, 2> first{};
  std::array<std::size_t, 2> count{};
  bool exact = false;  ///< the fetched part is the block's, in its order

  /// Bounding box of the block.
  explicit Window(const Block& block) {
    const std::array<std::span<const std::size_t>, 2> axes = {block.responses, block.references};
    for (const std::size_t axis : {0u, 1u}) {
      const auto [low, high] = std::ranges::minmax(axes[axis]);
      first[axis] = low;
      count[axis] = high - low + 1;
    }
    for (const std::size_t r : block.responses) rows.push_back((r - first[0]) * count[1]);
    for (const std::size_t c : block.references) columns.push_back(c - first[1]);
    exact = counts_up(block.responses, first[0]) && counts_up(block.references, first[1]);
  }

  std::size_t size() const { return count[0] * count[1]; }

  T* gather(const T* fetched, T* out) const {
    for (const std::size_t row : rows) {
      for (const std::size_t column : columns) *out++ = fetched[row + column];
    }
    return out;
  }
};

template <class T>
LineReader<T>::LineReader(const Object& file, const std::string& name, const FrfHeader& header)
    : LineReader(file, name, std::array{header.lines(), header.response.size(), header.reference.size()}) {}

template <class T>
LineReader<T>::LineReader(const Object& file, const std::string& name, const std::array<std::size_t, 3>& dims)
    : dataset_(open_dataset(file, name)), memory_type_(memory_type<T>()) {
  if constexpr (std::is_same_v<T, double>) {
    if (!is_real(dataset_)) fail(dataset_, "does not hold real numbers");
  } else {
    if (!is_complex(dataset_))
      fail(dataset_, "does not hold complex numbers, compounds {r,i} of floating point");
  }
  require_shape(dataset_, dims);
  require_complete(dataset_);
  set_cache(file, name, dataset_, sizeof(T));
  map_ = LineMap::of(file, dataset_, memory_type_);
}

template <class T>
bool LineReader<T>::stand_alone() {
  return map_ && map_->stand_alone(dataset_) && dataset_.id.close();
}

template <class T>
void LineReader<T>::read(const Block& block, std::span<T> out) {
  const Silence silence;
  if (map_) {
    read_mapped(block, out);
  } else {
    read_slabs(block, out);
  }
}

template <class T>
void LineReader<T>::read_mapped(const Block& block, std::span<T> out) {
  const std::size_t columns = dataset_.dims[2];
  const auto fetch = [&](std::size_t line, std::size_t first, std::size_t count, T* to) {
    map_->read(dataset_, line, first * sizeof(T), std::as_writable_bytes(std::span(to, count)));
  };
  Window window(block);
  T* next = out.data();
  if (window.exact && window.count[1] == columns) {
    for (const std::size_t line : block.lines) {
      fetch(line, window.first[0] * columns, window.size(), next);
      next += window.size();
    }
    return;
  }
  // Whole rows lie in scratch at their place in the line, so the window is the whole line.
  for (std::size_t i = 0; i < window.rows.size(); ++i) window.rows[i] = block.responses[i] * columns;
  window.columns.assign(block.references.begin(), block.references.end());
  const std::vector<Run> runs = cover(block.responses, columns * sizeof(T));
  scratch_.resize(dataset_.dims[1] * columns);
  for (const std::size_t line : block.lines) {
    for (const Run& run : runs) {
      fetch(line, run.first * columns, run.count * columns, scratch_.data() + run.first * columns);
    }
    next = window.gather(scratch_.data(), next);
  }
}

template <class T>
void LineReader<T>::read_slabs(const Block& block, std::span<T> out) {
  const Window window(block);
  const std::size_t most_lines = std::max<std::size_t>(1, slab_bytes / (window.size() * sizeof(T)));
  T* next = out.data();
  for (std::size_t at = 0; at < block.lines.size();) {
    std::size_t end = at + 1;
    while (end < block.lines.size() && end - at < most_lines && block.lines[end] == block.lines[end - 1] + 1)
      ++end;
    if (window.exact) {
      read_slab(window, block.lines[at], end - at, next);
      next += (end - at) * window.size();
    } else {
      scratch_.resize((end - at) * window.size());
      read_slab(window, block.lines[at], end - at, scratch_.data());
      for (std::size_t i = 0; i < end - at; ++i)
        next = window.gather(scratch_.data() + i * window.size(), next);
    }
    at = end;
  }
}

template <class T>
void LineReader<T>::read_slab(const Window& window, std::size_t first_line, std::size_t lines, T* to) {
  const std::array<hsize_t, 3> start = {first_line, window.first[0], window.first[1]};
  const std::array<hsize_t, 3> count = {lines, window.count[0], window.count[1]};
  const Handle in_file(H5Dget_space(dataset_.id.get()));
  const Handle in_memory(H5Screate_simple(3, count.data(), nullptr));
  H5Sselect_hyperslab(in_file.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
  if (H5Dread(dataset_.id.get(), memory_type_.get(), in_memory.get(), in_file.get(), H5P_DEFAULT, to) < 0) {
    fail(dataset_, "line " + std::to_string(first_line + 1) + " cannot be read: " + last_failure());
  }
}

template class LineReader<Complex>;
template class LineReader<double>;

}  // namespace jointid::frf::hdf5
