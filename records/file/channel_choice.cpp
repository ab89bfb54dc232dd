#include "records/file/channel_choice.hpp"

#include "base/error.hpp"

namespace jointid::records {
namespace {

const frf::NumberColumn* times(const frf::Columns& columns) { return columns.find({"time", "t"}, {"rate"}); }

}  // namespace

std::string time_column(const frf::Columns& columns) {
  const frf::NumberColumn* found = times(columns);
  return found == nullptr ? "" : found->name;
}

std::vector<std::size_t> chosen_columns(const frf::Columns& columns, const std::vector<std::string>& wanted) {
  const frf::NumberColumn* first = columns.columns.data();
  std::vector<std::size_t> out;
  for (const std::string& name : wanted) out.push_back(static_cast<std::size_t>(&columns.column(name) - first));
  if (!wanted.empty()) return out;
  const frf::NumberColumn* time = times(columns);
  for (const frf::NumberColumn& column : columns.columns) {
    if (&column != time) out.push_back(static_cast<std::size_t>(&column - first));
  }
  if (!out.empty()) return out;
  throw InputError({ErrorKind::data, columns.file, "", "has no channel beside the time", "name the channels"});
}

}  // namespace jointid::records
