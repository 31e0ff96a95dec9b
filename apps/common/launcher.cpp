// The executable of every application. It links neither OpenGL nor Coin: it first loads whoever shall provide
// OpenGL, then the application's own library, and calls its teMain().

#include "apps/common/TeContextChoice.h"

#include <dlfcn.h>
#include <unistd.h>

#include <climits>
#include <cstdio>
#include <string>

namespace {

std::string folderOfProgram() {
  char path[PATH_MAX];
  const ssize_t length = readlink("/proc/self/exe", path, sizeof path - 1);
  if (length <= 0)
    return ".";
  path[length] = 0;
  const std::string text = path;
  return text.substr(0, text.rfind('/'));
}

/// The modules' folder: installed, or in the build tree.
std::string moduleFolder() {
  const std::string program = folderOfProgram();
  const std::string installed = program + "/" TERRANE_BIN_TO_LIB "/terrane";
  return access((installed + "/app-" TERRANE_APP ".so").c_str(), F_OK) == 0 ? installed
                                                                            : program + "/../lib/terrane";
}

int fail() {
  const char* reason = dlerror();
  std::fprintf(stderr, TERRANE_APP ": %s\n", reason ? reason : "a library cannot be loaded");
  return 1;
}

} // namespace

int main(int argc, char** argv) {
  const std::string folder = moduleFolder();
  const bool osMesa = std::strcmp(teContextChoice(argc, argv), "osmesa") == 0;
  if (osMesa && !dlopen((folder + "/osmesa-shim.so").c_str(), RTLD_NOW | RTLD_GLOBAL))
    return fail();
  void* application = dlopen((folder + "/app-" TERRANE_APP ".so").c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (!application)
    return fail();
  void* entry = dlsym(application, "teMain");
  if (!entry)
    return fail();
  return reinterpret_cast<int (*)(int, char**)>(entry)(argc, argv);
}
