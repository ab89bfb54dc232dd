#include "python/outputs.hpp"

#include <system_error>

#include "base/error.hpp"

namespace jointid::python {

void refuse_inputs(const std::filesystem::path& target, const std::vector<ident::NamedFile>& inputs) {
  for (const ident::NamedFile& input : inputs) {
    std::error_code not_there;
    if (target.empty() || !std::filesystem::equivalent(target, input.path, not_there)) continue;
    throw InputError(
        {ErrorKind::usage, target.string(), "out", "it would replace what is read (" + input.place + ")", "name another file"});
  }
}

}  // namespace jointid::python
