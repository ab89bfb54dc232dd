#include "frf/file/other_format.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "base/error.hpp"

namespace jointid::frf {
namespace {

using namespace std::string_view_literals;

struct Signature {
  std::string_view bytes;
  OtherFormat format;
};

constexpr auto to_arrays = "write its arrays by numpy.savez, scipy.io.savemat or h5py"sv;
constexpr auto to_table = "export its channels as CSV, UFF 58, MATLAB or HDF5"sv;

constexpr std::array signatures = std::to_array<Signature>({
    {"\x1F\x8B"sv, {"packed by gzip", "unpack it: gunzip FILE"}},
    {"BZh"sv, {"packed by bzip2", "unpack it: bunzip2 FILE"}},
    {"\xFD"
     "7zXZ\0"sv,
     {"packed by xz", "unpack it: unxz FILE"}},
    {"\x28\xB5\x2F\xFD"sv, {"packed by zstd", "unpack it: unzstd FILE"}},
    {"7z\xBC\xAF\x27\x1C"sv, {"an archive of 7-Zip", "unpack it: 7z x FILE"}},
    {"Rar!"sv, {"a RAR archive", "unpack it: unrar x FILE"}},
    {"TDSm"sv, {"a TDMS file of National Instruments", "export the channels as LVM or CSV, or save them by npTDMS as HDF5"}},
    {"MDF     "sv, {"a measurement file (MDF)", "export its channels as CSV, MATLAB or HDF5, in Python by asammdf"}},
    {"RIFF"sv, {"a sound file (WAV)", "save its samples as .npz, in Python by scipy.io.wavfile and numpy.savez, or as MATLAB"}},
    {"RF64"sv, {"a sound file (WAV)", "save its samples as .npz, in Python by scipy.io.wavfile and numpy.savez, or as MATLAB"}},
    {"fLaC"sv, {"a sound file (FLAC)", "save its samples as .npz, or as MATLAB"}},
    {"PAR1"sv, {"a Parquet file", "write it as CSV or HDF5, in Python by pandas: read_parquet().to_csv()"}},
    {"ARROW1"sv, {"a Feather (Arrow) file", "write it as CSV, in Python by pandas: read_feather().to_csv()"}},
    {"SQLite format 3"sv, {"a database of SQLite", "export its table as CSV"}},
    {"%PDF-"sv, {"a PDF file", "export the numbers as CSV, UFF 58, MATLAB or HDF5"}},
    {"\x0E\x03\x13\x01"sv, {"an HDF4 file", "convert it to HDF5: h4toh5 FILE"}},
    {"\x80\x02"sv, {"a pickle of Python", to_arrays}},
    {"\x80\x03"sv, {"a pickle of Python", to_arrays}},
    {"\x80\x04"sv, {"a pickle of Python", to_arrays}},
    {"\x80\x05"sv, {"a pickle of Python", to_arrays}},
    {"<!DOCTYPE html"sv, {"a page of HTML", to_table}},
    {"<html"sv, {"a page of HTML", to_table}},
    {"<?xml"sv, {"an XML file", to_table}},
});

bool is_tar(std::string_view head) { return head.size() > 262 && head.substr(257, 5) == "ustar"; }

bool has(std::string_view head, std::string_view words) { return head.find(words) != std::string_view::npos; }

/// Braces of JSON around names in quotes, none of a table.
bool is_json(std::string_view head) {
  const std::size_t begin = std::min(head.find_first_not_of(" \t\r\n\xEF\xBB\xBF"), head.size());
  const std::string_view text = head.substr(begin);
  const auto next = [&](std::size_t at) { return text.substr(std::min(text.find_first_not_of(" \t\r\n", at), text.size())); };
  if (text.starts_with('{')) return next(1).starts_with('"');
  return text.starts_with('[') && next(1).starts_with('{');
}

std::optional<OtherFormat> zip_format(std::string_view head) {
  if (has(head, "xl/") || has(head, "[Content_Types].xml") || has(head, "oasis.opendocument"))
    return OtherFormat{has(head, "opendocument") ? "a workbook of LibreOffice" : "a workbook of Excel", "save its sheet as CSV"};
  if (has(head.substr(0, 200), ".npy")) return std::nullopt;
  return OtherFormat{"a ZIP archive", "unpack it: unzip FILE"};
}

}  // namespace

std::optional<OtherFormat> other_format(std::string_view head) {
  if (head.starts_with("CDF") && head.size() > 3 && (head[3] == 1 || head[3] == 2 || head[3] == 5))
    return OtherFormat{"a NetCDF-3 file",
                       "write NetCDF-4, which is HDF5: nccopy -k nc4 IN OUT, or to_netcdf(format='NETCDF4') of xarray"};
  const bool punched = has(head, "$DISPLACEMENTS") || has(head, "$VELOCITY") || has(head, "$ACCELERATION");
  if (head.starts_with("$TITLE") && punched)
    return OtherFormat{"a file of results that Nastran punched",
                       "write the results as a universal file (UFF 58), or as a table whose titles are e.g. 'Frequency [Hz]', "
                       "'2:+Z/1:+Z re [m/N]', '2:+Z/1:+Z im [m/N]'. Or give the matrices of the model (DMIG, OUTPUT4) as a part"};
  if (head.starts_with("\xD0\xCF\x11\xE0")) return OtherFormat{"a workbook of Excel", "save its sheet as CSV"};
  if (head.starts_with("PK\x03\x04")) return zip_format(head);
  const auto found = std::ranges::find_if(signatures, [&](const Signature& each) { return head.starts_with(each.bytes); });
  if (found != signatures.end()) return found->format;
  if (is_tar(head)) return OtherFormat{"a tar archive", "unpack it: tar -xf FILE"};
  return is_json(head) ? std::optional(OtherFormat{"a JSON file", to_table}) : std::nullopt;
}

void require_read_format(const std::filesystem::path& path, std::string_view head) {
  const auto other = other_format(head);
  if (!other) return;
  throw InputError(
      {ErrorKind::data, path.string(), {}, "is " + std::string(other->name) + ", which is not read", std::string(other->remedy)});
}

}  // namespace jointid::frf
