#include "base/module.hpp"

#include <dlfcn.h>
#include <link.h>

#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace jointid {
namespace {

std::string file_of(const Module& module) { return "jointid_" + std::string(module.name) + ".so"; }

/// What this code is part of, a program or a library, as dlopen() knows it.
void* own_object() {
  Dl_info symbol;
  link_map* object = nullptr;
  if (dladdr1(reinterpret_cast<void*>(&file_of), &symbol, reinterpret_cast<void**>(&object), RTLD_DL_LINKMAP) == 0) return nullptr;
  const bool is_program = object == nullptr || *object->l_name == '\0';
  return dlopen(is_program ? nullptr : object->l_name, RTLD_LAZY | RTLD_NOLOAD);
}

/// Folders in which dlopen() looks for what this code names, in their order.
std::vector<std::filesystem::path> search_path() {
  void* const program = own_object();
  Dl_serinfo size;
  if (program == nullptr || dlinfo(program, RTLD_DI_SERINFOSIZE, &size) != 0) return {};
  std::vector<std::max_align_t> memory(size.dls_size / sizeof(std::max_align_t) + 1);
  auto* const info = reinterpret_cast<Dl_serinfo*>(memory.data());
  std::vector<std::filesystem::path> out;
  if (dlinfo(program, RTLD_DI_SERINFOSIZE, info) != 0 || dlinfo(program, RTLD_DI_SERINFO, info) != 0) return {};
  for (unsigned i = 0; i < info->dls_cnt; ++i) out.emplace_back(info->dls_serpath[i].dls_name);
  return out;
}

[[noreturn]] void fail(const Module& module, const std::string& problem, const std::string& remedy) {
  throw InputError({.kind = ErrorKind::usage,
                    .file = {},
                    .place = "module " + file_of(module),
                    .problem = std::string(module.purpose) + " needs it: " + problem,
                    .remedy = remedy});
}

void* open(const Module& module) {
  void* const library = dlopen(file_of(module).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    const std::string reason = dlerror();
    if (!is_there(module)) fail(module, "this build lacks it", "build jointid with " + std::string(module.package));
    fail(module, reason, "install the libraries of " + std::string(module.package) + ", or build jointid anew");
  }
  const auto address = reinterpret_cast<void* (*)()>(dlsym(library, "jointid_module"));
  if (address == nullptr) fail(module, "it has no function jointid_module", "build jointid anew");
  return address();
}

}  // namespace

bool is_there(const Module& module) {
  for (const std::filesystem::path& folder : search_path()) {
    std::error_code unreadable;
    if (std::filesystem::is_regular_file(folder / file_of(module), unreadable)) return true;
  }
  return false;
}

void* load(const Module& module) {
  static std::mutex mutex;
  static std::map<std::string, void*, std::less<>> loaded;
  const std::lock_guard lock(mutex);
  if (const auto found = loaded.find(module.name); found != loaded.end()) return found->second;
  return loaded[std::string(module.name)] = open(module);
}

}  // namespace jointid
