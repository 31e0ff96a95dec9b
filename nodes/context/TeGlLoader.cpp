#include "nodes/context/TeGlLoader.h"

#include "generators/base/TeLog.h"

#include <Inventor/C/glue/gl.h>

#include <string>

TeGlLoader::TeGlLoader(std::uint32_t context)
    : TeGlLoader([glue = cc_glglue_instance(int(context))](const char* name) {
        return cc_glglue_getprocaddress(glue, name);
      }) {}

bool TeGlLoader::isComplete(const char* consequence) const {
  if (m_missing)
    TeLog::error(std::string(consequence) + ": OpenGL lacks " + m_missing);
  return !m_missing;
}
