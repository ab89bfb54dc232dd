#include <charconv>
#include <cmath>

#include "base/error.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/text/number_text.hpp"
#include "records/file/record.hpp"
#include "records/file/record_options.hpp"

namespace jointid::records {
namespace {

[[noreturn]] void refuse(const std::string& text, std::string problem) {
  throw InputError({ErrorKind::usage,
                    {},
                    "--channel '" + text + "'",
                    std::move(problem),
                    "write COLUMN=DOF UNIT, e.g. 2=1:+Z N or a=4:+Z 9.81 m/s^2; without a unit it is that of the file"});
}

}  // namespace

GivenChannel parse_channel(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) refuse(text, "has no column before =");
  const std::vector<std::string_view> words = frf::split(std::string_view(text).substr(equals + 1), ' ');
  if (words.empty() || words.size() > 3)
    refuse(text, "has " + std::to_string(words.size()) + " words after =, not DOF and unit");
  GivenChannel channel{text.substr(0, equals), frf::Dof::parse(words.front()), 1.0, {}};
  if (words.size() == 1) return channel;
  channel.unit = words.back();
  if (words.size() == 3 &&
      (!frf::parse_cell(words[1], false, channel.factor) || !std::isfinite(channel.factor) || channel.factor == 0.0)) {
    refuse(text, "'" + std::string(words[1]) + "' is no factor");
  }
  const auto unit = frf::parse_unit(channel.unit);
  if (!unit || !kind_of(*unit, channel.dof.is_rotation())) {
    refuse(text,
           "'" + channel.unit + "' is no unit of a force or a motion at " + channel.dof.name() + " (" + frf::unit_names() + ")");
  }
  return channel;
}

}  // namespace jointid::records
