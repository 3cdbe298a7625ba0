// Modules: parts of the library that are opened when they are first needed, because the libraries
// that they link take long to bind. A module is the file mrsim/<name>.so beside the library.
#pragma once

#include <string>

namespace mrsim {

class Module {
 public:
  struct Description {
    const char* name;    ///< of the file, without .so
    const char* code;    ///< of the Error where it cannot be opened
    const char* task;    ///< "reads STEP files", for the error's text
    const char* remedy;  ///< what else to do about it, for the error's text
  };

  /// Opens the module, which stays open until the program ends, since its libraries may leave
  /// pointers into themselves behind. Throws Error `about.code`.
  explicit Module(const Description& about);

  /// The function of that name, with C linkage. Throws Error where the module, being of another
  /// version of mrsim, has none.
  template <typename Function>
  Function* function(const char* name) const {
    return reinterpret_cast<Function*>(symbol(name));
  }

 private:
  void* symbol(const char* name) const;
  [[noreturn]] void fail(const std::string& why) const;
  [[noreturn]] void fail_to_open(const std::string& why) const;
  std::string find() const;

  Description about_;
  std::string path_;
  void* handle_ = nullptr;
};

}  // namespace mrsim
