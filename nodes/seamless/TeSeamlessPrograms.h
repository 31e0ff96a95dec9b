#pragma once

#include "generators/base/TeResult.h"
#include "nodes/seamless/TeSeamlessObjects.h"
#include "nodes/seamless/TeSeamlessVariant.h"

#include <map>

/// A linked program and where its uniforms are; -1 for those that it has not.
struct TeSeamlessProgram {
  GLuint name = 0;
  GLint eyeSample = -1, eyeFraction = -1, spacing = -1, heightToZ = -1;
  GLint clipFromRelative = -1, viewFromRelative = -1, viewFromNormal = -1;
  GLint patchLog = -1, sideStepLog = -1, terrainFromSample = -1, material = -1;
  GLint clipWindows = -1, clip = -1, heightUnit = -1, slopeScale = -1, slopeUnit = -1;
  GLint colourWindows = -1, colourClip = -1, detailScale = -1, groundLayers = -1, groundBlend = -1;
};

/// The programs of one context, each compiled when it is first asked for. All calls but compiled() with the
/// context current.
class TeSeamlessPrograms {
public:
  TeSeamlessPrograms(const TeSeamlessGl& gl, TeSeamlessObjects& objects) : m_gl(gl), m_objects(objects) {}

  /// Error: what the compiler says; the program is not tried again. Changes the program in use if it
  /// compiles.
  TeResult<const TeSeamlessProgram*> get(const TeSeamlessVariant& variant);
  int compiled() const { return m_compiled; }
  void clear(); ///< after the objects are gone

private:
  TeResult<TeSeamlessProgram> compile(const TeSeamlessVariant& variant);
  TeStatus attach(GLuint program, GLenum kind, const std::string& text);
  void locate(TeSeamlessProgram& program) const;

  const TeSeamlessGl& m_gl;
  TeSeamlessObjects& m_objects;
  std::map<std::uint32_t, TeResult<TeSeamlessProgram>> m_programs; ///< by TeSeamlessVariant::key()
  int m_compiled = 0;
};
