#include "frf/hdf5_module/hdf5_handle.hpp"

#include <hdf5.h>

#include <type_traits>

namespace jointid::frf::hdf5 {

static_assert(std::is_same_v<Id, hid_t>);

bool Handle::close() {
  const Id id = std::exchange(id_, -1);
  if (id < 0) return true;
  return (H5Iget_type(id) == H5I_FILE ? H5Fclose(id) : H5Idec_ref(id)) >= 0;
}

Silence::Silence() {
  H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Silence::~Silence() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }

void limit_metadata(const Handle& file, std::size_t most_bytes) {
  H5AC_cache_config_t config{};
  config.version = H5AC__CURR_CACHE_CONFIG_VERSION;
  if (H5Fget_mdc_config(file.get(), &config) < 0) return;
  config.set_initial_size = true;
  config.initial_size = config.min_size = config.max_size = most_bytes;
  config.incr_mode = H5C_incr__off;
  config.flash_incr_mode = H5C_flash_incr__off;
  config.decr_mode = H5C_decr__off;
  H5Fset_mdc_config(file.get(), &config);
}

std::string last_failure() {
  std::string text;
  const auto keep_first = [](unsigned, const H5E_error2_t* error, void* kept) -> herr_t {
    auto& kept_text = *static_cast<std::string*>(kept);
    if (kept_text.empty() && error->desc != nullptr) kept_text = error->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &text);
  return text;
}

}  // namespace jointid::frf::hdf5
