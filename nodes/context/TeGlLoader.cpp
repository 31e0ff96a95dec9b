#include "nodes/context/TeGlLoader.h"

#include <Inventor/C/glue/gl.h>

TeGlLoader::TeGlLoader(std::uint32_t context)
    : TeGlLoader([glue = cc_glglue_instance(int(context))](const char* name) {
        return cc_glglue_getprocaddress(glue, name);
      }) {}
