#include "nodes/seamless/TeSeamlessPrograms.h"

#include "nodes/seamless/TeSeamlessShader.h"

#include <string>
#include <vector>

namespace {

/// First line of what a compiler says.
template <class Get> std::string firstLine(GLint length, const Get& get) {
  std::vector<char> text(std::size_t(length) + 1, '\0');
  get(length, text.data());
  const std::string all(text.data());
  return all.substr(0, all.find('\n'));
}

} // namespace

TeResult<const TeSeamlessProgram*> TeSeamlessPrograms::get(const TeSeamlessVariant& variant) {
  auto found = m_programs.find(variant.key());
  if (found == m_programs.end()) {
    m_compiled++;
    found = m_programs.emplace(variant.key(), compile(variant)).first;
  }
  if (!found->second)
    return found->second.error();
  return &*found->second;
}

void TeSeamlessPrograms::clear() {
  m_programs.clear();
  m_compiled = 0;
}

TeResult<TeSeamlessProgram> TeSeamlessPrograms::compile(const TeSeamlessVariant& variant) {
  TeSeamlessProgram program;
  program.name = m_objects.addProgram();
  TeStatus status = program.name ? attach(program.name, GL_VERTEX_SHADER, TeSeamlessShader::vertex(variant))
                                 : TeStatus(TeError{"seamless patches: OpenGL makes no program"});
  if (status)
    status = attach(program.name, GL_FRAGMENT_SHADER, TeSeamlessShader::fragment(variant));
  if (!status) {
    m_objects.removeProgram(program.name);
    return status.error();
  }
  if (variant.capturesVertices) {
    const char* const varyings[] = {"drawnPosition", "drawnSample", "drawnHeight"};
    m_gl.transformFeedbackVaryings(program.name, 3, varyings, GL_INTERLEAVED_ATTRIBS);
  }
  m_gl.linkProgram(program.name);
  GLint linked = 0;
  m_gl.getProgramiv(program.name, GL_LINK_STATUS, &linked);
  if (!linked) {
    GLint length = 0;
    m_gl.getProgramiv(program.name, GL_INFO_LOG_LENGTH, &length);
    const std::string log = firstLine(
        length, [&](GLint size, char* text) { m_gl.getProgramInfoLog(program.name, size, nullptr, text); });
    m_objects.removeProgram(program.name);
    return TeError{"seamless patches: a program does not link: " + log};
  }
  locate(program);
  return program;
}

TeStatus TeSeamlessPrograms::attach(GLuint program, GLenum kind, const std::string& text) {
  const GLuint shader = m_gl.createShader(kind);
  const char* const source = text.c_str();
  m_gl.shaderSource(shader, 1, &source, nullptr);
  m_gl.compileShader(shader);
  GLint compiled = 0;
  m_gl.getShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  std::string log;
  if (compiled) {
    m_gl.attachShader(program, shader);
  } else {
    GLint length = 0;
    m_gl.getShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    log = firstLine(length, [&](GLint size, char* to) { m_gl.getShaderInfoLog(shader, size, nullptr, to); });
  }
  m_gl.deleteShader(shader); // goes with the program
  if (!compiled)
    return TeError{"seamless patches: a shader does not compile: " + log};
  return {};
}

void TeSeamlessPrograms::locate(TeSeamlessProgram& program) const {
  const auto find = [&](const char* uniform) { return m_gl.getUniformLocation(program.name, uniform); };
  program.eyeSample = find("eyeSample");
  program.eyeFraction = find("eyeFraction");
  program.spacing = find("spacing");
  program.heightToZ = find("heightToZ");
  program.clipFromRelative = find("clipFromRelative");
  program.viewFromRelative = find("viewFromRelative");
  program.viewFromNormal = find("viewFromNormal");
  program.patchLog = find("patchLog");
  program.sideStepLog = find("sideStepLog");
  program.terrainFromSample = find("terrainFromSample");
  program.material = find("material");
  program.clipWindows = find("clipWindows");
  program.clip = find("clip");
  program.heightUnit = find("heightUnit");
  program.slopeScale = find("slopeScale");
  program.slopeUnit = find("slopeUnit");
  program.colourWindows = find("colourWindows");
  program.colourClip = find("colourClip");
  program.detailScale = find("detailScale");
  program.groundLayers = find("groundLayers");
  program.groundBlend = find("groundBlend");

  m_gl.useProgram(program.name);
  m_gl.uniform1i(find("heights"), TeSeamlessShader::kHeightsUnit);
  m_gl.uniform1i(find("colours"), TeSeamlessShader::kColoursUnit);
  const char* const details[] = {"detail0", "detail1", "detail2", "detail3"};
  for (int i = 0; i < 4; i++)
    m_gl.uniform1i(find(details[i]), TeSeamlessShader::kFirstDetailUnit + i);
}
