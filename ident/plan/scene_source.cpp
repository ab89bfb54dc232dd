#include "ident/plan/scene_source.hpp"

#include <string>

#include "base/error.hpp"
#include "frf/file/node_table.hpp"
#include "frf/set/corrections.hpp"
#include "models/model_file.hpp"
#include "virtualpoint/virtual_source.hpp"

namespace jointid::ident {
namespace {

void require_no_measurement(const DataFile& model) {
  const frf::OpenOptions& options = model.options;
  const char* key = options.quantity                      ? "quantity"
                    : !options.unit.empty()               ? "unit"
                    : !options.response.empty()           ? "dofs"
                    : !options.variable.empty()           ? "variable"
                    : !options.frequency_variable.empty() ? "frequency_variable"
                    : !options.frequency_unit.empty()     ? "frequency_unit"
                                                          : nullptr;
  if (key == nullptr) return;
  throw InputError({.kind = ErrorKind::usage,
                    .file = model.path.string(),
                    .place = "[data.files]",
                    .problem = std::string(key) + " is given for a model",
                    .remedy = "remove it; a model's file states what it is"});
}

}  // namespace

std::unique_ptr<frf::FrfSource> as_in_scene(std::unique_ptr<frf::FrfSource> source, const DataFile& file) {
  source = frf::corrected(std::move(source), file.corrections);
  if (file.nodes) source->place_nodes(frf::read_node_table(*file.nodes));
  if (file.virtual_points.empty()) return source;
  return virtualpoint::virtual_source(std::move(source), file.virtual_points, file.virtual_noise);
}

ModelFrfs::ModelFrfs(const DataFile& file) : file_(file) {
  require_no_measurement(file);
  named_ = models::read_model(file.path);
}

std::unique_ptr<frf::FrfSource> ModelFrfs::at(std::vector<double> frequency_hz) const {
  for (double& frequency : frequency_hz) frequency /= file_.corrections.frequency_scale;
  return as_in_scene(std::make_unique<models::ModelSource>(named_, std::move(frequency_hz)), file_);
}

}  // namespace jointid::ident
