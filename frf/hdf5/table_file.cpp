#include "frf/hdf5/table_file.hpp"

#include "frf/hdf5/file_origin.hpp"

namespace jointid::frf {
namespace {

TableHeader with_origin(TableHeader header) {
  if (const std::string origin = header.texts.contains("provenance") ? "" : file_origin(); !origin.empty())
    header.texts["provenance"] = origin;
  return header;
}

}  // namespace

TableWriter::TableWriter(const std::filesystem::path& path, const TableHeader& header, std::size_t rows)
    : temporary_(path), file_(hdf5_module().create_table(temporary_, with_origin(header), rows)) {}

void TableWriter::append(std::span<const double> rows) { file_->append(rows); }

void TableWriter::finish() {
  file_->finish();
  temporary_.commit();
}

TableReader::TableReader(const std::filesystem::path& path) : file_(hdf5_module().open_table(path)) {}

const TableHeader& TableReader::header() const { return file_->header(); }
std::size_t TableReader::rows() const { return file_->rows(); }
void TableReader::read(std::size_t column, std::size_t first, std::span<double> out) const { file_->read(column, first, out); }

}  // namespace jointid::frf
