#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "frf/set/frf_source.hpp"

namespace jointid::frf {

/// Opens a universal file (UFF 58 and 58b). The file is read once for its headers, which are kept; values of a record are
/// read on request. Of binary records that is only the span of the requested lines; if a record continues at its last line,
/// up to 32 MB of all FRFs are read ahead. Text records are read whole and kept, in memory up to 16 MB in all, else in a
/// temporary file. Every record has its own quantity and units; header().quantity is that of the first FRF. For DOFs, signs,
/// axes, units and coherences see uff::build_catalogue and uff::interpret_ordinate. Throws InputError if the file has no
/// FRFs.
std::unique_ptr<FrfSource> open_uff(const std::filesystem::path& path, const OpenOptions& options = {});

/// Whether a file that begins with these bytes (about 200 are enough) is a universal file: '    -1', then a
/// dataset number.
bool looks_like_uff(std::span<const char> first_bytes);

struct UffWriteOptions {
  bool binary = true;  ///< 58b with little-endian doubles, else 58 with E20.12
  Quantity quantity = Quantity::receptance;
};

/// Writes the set to a temporary name and renames it. It has datasets 151, 164 (SI), 2411 if node positions are
/// known, one 58 for each FRF, and one for each coherence. An FRF that is NaN on all lines is left out. One that
/// is NaN on some throws InputError, except at 0 Hz of a mobility or accelerance: there 0 is written and NaN
/// will be read. The format has no place for variances. The axis is written as first + i·step if that gives
/// every line within 1e-6 of a spacing with the ten or so digits of the header's columns. Else every point has
/// its abscissa (in binary as doubles). Values are those of the axis as written, so a receptance comes back
/// unchanged.
void write_uff(const FrfSet& set, const std::filesystem::path& path, const UffWriteOptions& options = {});

/// Content of a universal file. Only headers are read.
struct UffSummary {
  struct Count {
    std::string dataset;  ///< e.g. "58b"
    std::size_t count = 0;
  };
  struct Function {
    std::string dataset;            ///< "58" or "58b"
    std::array<std::string, 5> id;  ///< ID lines, UTF-8
    int function_type = 0;
    std::string function;  ///< e.g. "frequency response function"
    std::string response;  ///< e.g. "4:+Y" or "4:scalar"
    std::string reference;
    std::uint64_t points = 0;  ///< as declared
    std::string quantity;      ///< e.g. "acceleration / excitation force"
    std::string unit;          ///< labels as in the file, or empty
    std::string abscissa_unit;
  };
  std::vector<Count> datasets;      ///< in order of first appearance
  std::vector<Function> functions;  ///< every 58 and 58b, in the order of the file
};
UffSummary summarize_uff(const std::filesystem::path& path);

/// One record 58 or 58b with its values as in the file, whatever its function type and units.
struct Uff58 {
  UffSummary::Function description;
  std::vector<double> abscissa;
  std::vector<Complex> values;  ///< imaginary part 0 for real data
};

/// Reads the `index`-th (from 0) record 58 or 58b. Throws InputError when there are fewer.
Uff58 read_uff58(const std::filesystem::path& path, std::size_t index);

}  // namespace jointid::frf
