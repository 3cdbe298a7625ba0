#include "core/process/module.h"

#include "core/process/error.h"

#include <filesystem>
#include <system_error>

#include <dlfcn.h>
#include <fmt/format.h>

namespace mrsim {
namespace {

// A place within the library, or within the program that holds its stages.
const char kHere = 0;

}  // namespace

Module::Module(const Description& about) : about_(about), path_(find()) {
  handle_ = dlopen(path_.c_str(), RTLD_LAZY | RTLD_LOCAL);
  if (!handle_) fail_to_open(dlerror());
}

// Beside the library, wherever that was moved to.
std::string Module::find() const {
  Dl_info self{};
  if (dladdr(&kHere, &self) == 0 || !self.dli_fname)
    fail("the system does not tell where the library lies");
  std::error_code ignored;
  const std::filesystem::path library = std::filesystem::weakly_canonical(self.dli_fname, ignored);
  return (library.parent_path() / "mrsim" / about_.name).string() + ".so";
}

// Only the text of the loader shows that memory ran out.
void Module::fail_to_open(const std::string& why) const {
  for (const char* words : {"failed to map", "cannot map", "cannot allocate", "Cannot allocate"})
    if (why.find(words) != why.npos)
      throw Error("memory", fmt::format("the module that {} finds too little address space to be "
                                        "opened: raise its limit (ulimit -v); {}",
                                        about_.task, why));
  fail(why);
}

void* Module::symbol(const char* name) const {
  void* found = dlsym(handle_, name);
  if (!found) fail(path_ + " belongs to another version of mrsim");
  return found;
}

void Module::fail(const std::string& why) const {
  throw Error(about_.code, fmt::format("the module that {} cannot be opened: {}; {}", about_.task,
                                       why, about_.remedy));
}

}  // namespace mrsim
