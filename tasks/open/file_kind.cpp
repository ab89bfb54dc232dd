#include "tasks/open/file_kind.hpp"

#include "frf/set/frf_source.hpp"
#include "frf/uff/uff_lines.hpp"
#include "records/file/open_samples.hpp"
#include "scene/if_readable.hpp"
#include "tasks/loading_curve/loading_curve_data.hpp"

namespace jointid::tasks {
namespace {

bool is_record(const std::filesystem::path& file) {
  const auto samples = records::open_samples(file);
  return !samples->time_column().empty() || samples->rate_hz().has_value();
}

}  // namespace

FileKind kind_of_file(const std::filesystem::path& file) {
  if (scene::if_readable([&] { frf::open(file); })) return FileKind::frfs;
  LoadingCurveTask curve;
  curve.files = {file};
  if (scene::if_readable([&] { return !read_curves(curve).curves.empty(); })) return FileKind::loading_curve;
  if (scene::if_readable([&] { return is_record(file); })) return FileKind::time_record;
  return scene::if_readable([&] { return !frf::read_uff_nodes(file).empty(); }) ? FileKind::geometry : FileKind::other;
}

}  // namespace jointid::tasks
