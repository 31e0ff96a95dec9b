#pragma once

/// How triangles come to OpenGL: the ways that document 003 names.
enum class TeLodSubmission {
  Immediate,     ///< call by call
  VertexArrays,  ///< three vertices a triangle from main memory, each time
  IndexedArrays, ///< shared vertices and indices from main memory, each time
  VboStatic,     ///< buffers of OpenGL, meant to stay
  VboDynamic,    ///< meant to be changed
  VboStream,     ///< sent anew for every frame
  DisplayLists   ///< compiled by OpenGL
};
