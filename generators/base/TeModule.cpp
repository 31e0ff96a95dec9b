#include "generators/base/TeModule.h"

#include <dlfcn.h>

#include <map>
#include <mutex>

namespace {

std::string folderOfThisLibrary() {
  Dl_info info;
  if (!dladdr(reinterpret_cast<void*>(&teModuleSymbol), &info) || !info.dli_fname)
    return ".";
  const std::string path = info.dli_fname;
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "." : path.substr(0, slash);
}

} // namespace

TeResult<void*> teModuleSymbol(const std::string& name, const std::string& symbol) {
  static std::mutex mutex;
  static std::map<std::string, void*> modules;
  std::lock_guard<std::mutex> lock(mutex);

  auto found = modules.find(name);
  if (found == modules.end()) {
    const std::string path = folderOfThisLibrary() + "/terrane/" + name + ".so";
    void* handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!handle) {
      const char* reason = dlerror();
      return TeError{"module " + name + ": " + (reason ? reason : path + " cannot be loaded")};
    }
    found = modules.emplace(name, handle).first;
  }
  void* address = dlsym(found->second, symbol.c_str());
  if (!address)
    return TeError{"module " + name + " has no symbol " + symbol};
  return address;
}
