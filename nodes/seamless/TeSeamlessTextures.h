#pragma once

#include "nodes/seamless/TeSeamlessFrame.h"
#include "nodes/seamless/TeSeamlessLook.h"
#include "nodes/seamless/TeSeamlessObjects.h"

#include <array>
#include <cstdint>
#include <memory>

/// Heights and pictures of one TeSeamlessRenderer as textures, uploaded when they change. All calls with the
/// context current; they change the texture of the active unit.
class TeSeamlessTextures {
public:
  enum Use { Colours, FirstDetail, Count = FirstDetail + 4 };

  TeSeamlessTextures(const TeSeamlessGl& gl, TeSeamlessObjects& objects) : m_gl(gl), m_objects(objects) {}

  /// Binds what a technique needs to the units of TeSeamlessShader, uploading what is not there yet; unit 0
  /// is active after it. Error: what heights() and picture() say.
  TeStatus bind(const TeSeamlessLook& look, const TeSeamlessFrame& frame);

  /// RG32UI, row 0 in the south: the bits of a float height; slopes to the east and north in units of height
  /// a sample, 16 signed bits each, times slopeUnit(). Error: more samples a side than OpenGL allows, a
  /// missing sample, no memory.
  TeResult<GLuint> heights(const std::shared_ptr<const TeHeightMap>& heights);
  float slopeUnit() const { return m_slopeUnit; }

  /// RGBA8 with mipmaps, filtered; details repeat. Error: no pixels, too large, no memory.
  TeResult<GLuint> picture(Use use, const std::shared_ptr<const TePicture>& picture);

  std::int64_t bytesUploaded() const { return m_bytesUploaded; } ///< since it was made
  void clear();                                                  ///< after the objects are gone

private:
  struct Picture {
    std::shared_ptr<const TePicture> source;
    GLuint texture = 0;
  };

  void makeSamplers();
  TeStatus bindColours(const TeSeamlessLook& look, const TeSeamlessFrame& frame);
  TeStatus bindPicture(int unit, Use use, const std::shared_ptr<const TePicture>& picture);
  TeStatus checkSize(const char* what, int width, int height, const char* advice) const;
  TeStatus uploadHeights(const TeHeightMap& heights);
  TeStatus outOfMemory(const char* what) const;

  const TeSeamlessGl& m_gl;
  TeSeamlessObjects& m_objects;
  std::shared_ptr<const TeHeightMap> m_heightSource;
  GLuint m_heights = 0;
  float m_slopeUnit = 1;
  std::array<Picture, Count> m_pictures;
  GLuint m_texelSampler = 0;  ///< for clipmaps of heights
  GLuint m_colourSampler = 0; ///< for those of colours
  std::int64_t m_bytesUploaded = 0;
};
