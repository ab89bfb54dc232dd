#include "records/file/channel_choice.hpp"

#include <algorithm>
#include <map>

#include "base/error.hpp"
#include "records/file/time_title.hpp"

namespace jointid::records {
std::string time_column(const frf::Columns& columns) {
  const frf::NumberColumn* found = find_times(columns);
  return found == nullptr ? "" : found->name;
}

std::vector<std::size_t> chosen_columns(const frf::Columns& columns, const std::vector<std::string>& wanted) {
  const frf::NumberColumn* first = columns.columns.data();
  std::vector<std::size_t> out;
  std::map<std::size_t, std::string> used;
  for (const std::string& name : wanted) {
    out.push_back(columns.place(name));
    const auto [before, is_new] = used.emplace(out.back(), name);
    if (!is_new) {
      throw InputError({ErrorKind::data, columns.file, "", "'" + before->second + "' and '" + name + "' are one column",
                        "name every column once; the columns are " + columns.names()});
    }
  }
  if (!wanted.empty()) return out;
  const frf::NumberColumn* time = find_times(columns);
  const auto is_long = [](const frf::NumberColumn& column) { return column.values.size() > 1; };
  const bool some_long = std::ranges::any_of(columns.columns, is_long);  // a number beside them is no channel
  for (const frf::NumberColumn& column : columns.columns) {
    if (&column != time && (!some_long || is_long(column))) out.push_back(static_cast<std::size_t>(&column - first));
  }
  if (!out.empty()) return out;
  throw InputError({ErrorKind::data, columns.file, "", "has no channel beside the time", "name the channels"});
}

}  // namespace jointid::records
