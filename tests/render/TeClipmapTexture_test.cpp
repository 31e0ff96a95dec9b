#include "nodes/clipmap/TeClipmapTexture.h"

#include "generators/base/TeRandom.h"
#include "nodes/clipmap/testPyramid.h"
#include "render/TeRenderTest.h"

#include <gmock/gmock.h>

#include <cstring>
#include <functional>
#include <type_traits>
#include <vector>

namespace {

class TeClipmapTextureTest : public TeRenderTest {
protected:
  void SetUp() override {
    TeRenderTest::SetUp();
    ASSERT_TRUE(context().makeCurrent());
    find(m_isTexture, "glIsTexture");
    find(m_getTexImage, "glGetTexImage");
    find(m_genTextures, "glGenTextures");
    find(m_deleteTextures, "glDeleteTextures");
    find(m_bindTexture, "glBindTexture");
    find(m_genBuffers, "glGenBuffers");
    find(m_deleteBuffers, "glDeleteBuffers");
    find(m_bindBuffer, "glBindBuffer");
    find(m_getIntegerv, "glGetIntegerv");
    find(m_pixelStorei, "glPixelStorei");
    find(m_getError, "glGetError");
  }

  template <class Function> void find(Function& function, const char* name) {
    function = reinterpret_cast<Function>(context().procAddress(name));
    ASSERT_TRUE(function) << name;
  }

  std::unique_ptr<TeClipWindows> makeWindows(const TestPyramid& pyramid, int size) {
    auto windows = TeClipWindows::create(pyramid.tiles(TeClipWindows::wholeLevel(size)), size);
    if (windows)
      return std::move(*windows);
    ADD_FAILURE() << windows.error().message;
    return nullptr;
  }

  int textures() {
    int count = 0;
    for (GLuint name = 1; name < 1000; name++)
      count += m_isTexture(name);
    return count;
  }

  /// All layers of a texture, as they are stored.
  template <class Texel>
  std::vector<Texel> image(const TeClipmapTexture& texture, const TeClipWindows& windows, int channels,
                           GLenum format, GLenum type) {
    std::vector<Texel> texels(std::size_t(windows.side() * windows.side() * windows.levels() * channels));
    m_pixelStorei(GL_PACK_ALIGNMENT, 1);
    m_bindTexture(GL_TEXTURE_2D_ARRAY, texture.name());
    m_getTexImage(GL_TEXTURE_2D_ARRAY, 0, format, type, texels.data());
    m_bindTexture(GL_TEXTURE_2D_ARRAY, 0);
    EXPECT_EQ(m_getError(), GLenum(GL_NO_ERROR));
    return texels;
  }

  /// Resident samples whose texel is not right(texel, level, x, y).
  template <class Texel, class Right>
  static int wrongTexels(const std::vector<Texel>& texels, const TeClipWindows& windows, int channels,
                         Right right) {
    int wrong = 0;
    const TeClipResidency& residency = windows.residency();
    for (std::size_t i = 0; i < residency.windows.size(); i++) {
      const TeClipWindow& window = residency.windows[i];
      for (std::int32_t y = window.y; y < window.y + window.side; y++)
        for (std::int32_t x = window.x; x < window.x + window.side; x++) {
          const int texel =
              (int(i) * windows.side() + y % windows.side()) * windows.side() + x % windows.side();
          wrong += !right(&texels[std::size_t(texel * channels)], residency.base + int(i), x, y);
        }
    }
    return wrong;
  }

  /// Moves the windows about, with small steps and jumps, with and without a budget, and looks at the texture
  /// now and then.
  void walk(TeClipWindows& windows, TeClipmapTexture& texture, const std::function<int()>& wrong) {
    TeRandom random(5, 1, {});
    glm::dvec2 centre(0);
    for (int step = 0; step < 150; step++) {
      if (step % 30 == 0)
        centre = {random.uniform(0, 256), random.uniform(0, 256)};
      centre += glm::dvec2(random.uniform(-6, 6), random.uniform(-6, 6));
      windows.update(centre, 8, step % 3 == 0 ? 0 : 700);
      const TeStatus status = texture.update(windows);
      ASSERT_TRUE(status) << status.error().message;
      EXPECT_TRUE(windows.uploads().empty());
      if (step % 10 == 0 || step == 149) {
        ASSERT_EQ(wrong(), 0) << step;
      }
    }
  }

  GLboolean (*m_isTexture)(GLuint) = nullptr;
  void (*m_getTexImage)(GLenum, GLint, GLenum, GLenum, void*) = nullptr;
  void (*m_genTextures)(GLsizei, GLuint*) = nullptr;
  void (*m_deleteTextures)(GLsizei, const GLuint*) = nullptr;
  void (*m_bindTexture)(GLenum, GLuint) = nullptr;
  void (*m_genBuffers)(GLsizei, GLuint*) = nullptr;
  void (*m_deleteBuffers)(GLsizei, const GLuint*) = nullptr;
  void (*m_bindBuffer)(GLenum, GLuint) = nullptr;
  void (*m_getIntegerv)(GLenum, GLint*) = nullptr;
  void (*m_pixelStorei)(GLenum, GLint) = nullptr;
  GLenum (*m_getError)() = nullptr;
};

} // namespace

TEST_F(TeClipmapTextureTest, ShortsAreTheSamples) {
  const TestPyramid pyramid(8);
  for (const int size : {33, 40}) {
    const auto windows = makeWindows(pyramid, size);
    ASSERT_TRUE(windows);
    TeClipmapTexture texture(context().id(), TeClipFormat::Short);
    walk(*windows, texture, [&] {
      const auto texels = image<std::uint16_t>(texture, *windows, 1, GL_RED_INTEGER, GL_UNSIGNED_SHORT);
      return wrongTexels(texels, *windows, 1, [&](const std::uint16_t* texel, int level, int x, int y) {
        return *texel == pyramid.sample(level, x, y);
      });
    });
    texture.free();
  }
}

TEST_F(TeClipmapTextureTest, HalvesAndFloatsAreThoseOfTheCpu) {
  const TestPyramid pyramid(8);
  {
    const auto windows = makeWindows(pyramid, 33);
    TeClipmapTexture texture(context().id(), TeClipFormat::Half);
    walk(*windows, texture, [&] {
      const auto texels = image<std::uint16_t>(texture, *windows, 1, GL_RED, GL_HALF_FLOAT);
      return wrongTexels(texels, *windows, 1, [&](const std::uint16_t* texel, int level, int x, int y) {
        return *texel == teHalfOfSample(std::uint16_t(pyramid.sample(level, x, y)));
      });
    });
    texture.free();
  }
  const auto windows = makeWindows(pyramid, 33);
  TeClipmapTexture texture(context().id(), TeClipFormat::Float);
  walk(*windows, texture, [&] {
    const auto texels = image<float>(texture, *windows, 1, GL_RED, GL_FLOAT);
    return wrongTexels(texels, *windows, 1, [&](const float* texel, int level, int x, int y) {
      return *texel == teDrawnHeight(std::uint16_t(pyramid.sample(level, x, y)), TeClipFormat::Float);
    });
  });
  texture.free();
}

TEST_F(TeClipmapTextureTest, ColoursOfThreeAndFourBytes) {
  for (const int bytes : {3, 4}) {
    const TestPyramid pyramid(8, bytes);
    const auto windows = makeWindows(pyramid, 33); // rows of 99 bytes are not aligned
    ASSERT_TRUE(windows);
    TeClipmapTexture texture(context().id(), TeClipFormat::Colour);
    walk(*windows, texture, [&] {
      const auto texels = image<unsigned char>(texture, *windows, 4, GL_RGBA, GL_UNSIGNED_BYTE);
      return wrongTexels(texels, *windows, 4, [&](const unsigned char* texel, int level, int x, int y) {
        return pyramid.isSample(texel, level, x, y) && (bytes == 4 || texel[3] == 255);
      });
    });
    texture.free();
  }
}

TEST_F(TeClipmapTextureTest, OneMadeLaterHasAllThatTheWindowsHave) {
  const TestPyramid pyramid(8);
  const auto windows = makeWindows(pyramid, 33);
  ASSERT_TRUE(windows);
  TeClipmapTexture lost(context().id(), TeClipFormat::Short);
  for (int step = 0; step < 20; step++) {
    windows->update({100 + 3 * step, 80}, 8, 0);
    ASSERT_TRUE(lost.update(*windows));
  }
  lost.free();
  EXPECT_EQ(lost.name(), 0u);
  EXPECT_EQ(lost.bytes(), 0u);
  TeClipmapTexture texture(context().id(), TeClipFormat::Short);
  ASSERT_TRUE(texture.update(*windows));
  const auto texels = image<std::uint16_t>(texture, *windows, 1, GL_RED_INTEGER, GL_UNSIGNED_SHORT);
  EXPECT_EQ(wrongTexels(texels, *windows, 1,
                        [&](const std::uint16_t* texel, int level, int x, int y) {
                          return *texel == pyramid.sample(level, x, y);
                        }),
            0);
  EXPECT_EQ(texture.bytesUploaded(), 4 * 33 * 33 * 2);
  texture.free();
}

TEST_F(TeClipmapTextureTest, UploadsOnlyWhatIsNew) {
  const TestPyramid pyramid(8);
  const auto windows = makeWindows(pyramid, 33);
  ASSERT_TRUE(windows);
  TeClipmapTexture texture(context().id(), TeClipFormat::Float);
  windows->update({128, 128}, 8, 0);
  ASSERT_TRUE(texture.update(*windows));
  EXPECT_EQ(texture.bytes(), 4u * 33u * 33u * 4u);
  EXPECT_EQ(texture.bytesUploaded(), std::int64_t(texture.bytes()));
  const std::int64_t before = texture.bytesUploaded();
  windows->update({129, 128}, 8, 0);
  ASSERT_TRUE(texture.update(*windows));
  EXPECT_GE(texture.bytesUploaded() - before, 33 * 4);
  EXPECT_LE(texture.bytesUploaded() - before, 3 * 33 * 4) << "a column a level at most";
  const std::int64_t after = texture.bytesUploaded();
  ASSERT_TRUE(texture.update(*windows));
  EXPECT_EQ(texture.bytesUploaded(), after) << "standing still costs nothing";
  texture.free();
}

TEST_F(TeClipmapTextureTest, LeavesOpenGlAsItFoundIt) {
  const TestPyramid pyramid(8);
  const auto windows = makeWindows(pyramid, 33);
  ASSERT_TRUE(windows);
  TeClipmapTexture texture(context().id(), TeClipFormat::Half);
  GLuint other = 0;
  GLuint buffer = 0;
  m_genTextures(1, &other);
  m_genBuffers(1, &buffer);
  m_bindTexture(GL_TEXTURE_2D_ARRAY, other);
  m_bindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
  const std::pair<GLenum, GLint> parameters[] = {{GL_UNPACK_ALIGNMENT, 8},   {GL_UNPACK_ROW_LENGTH, 77},
                                                 {GL_UNPACK_SKIP_PIXELS, 3}, {GL_UNPACK_SKIP_ROWS, 2},
                                                 {GL_UNPACK_SWAP_BYTES, 1},  {GL_UNPACK_LSB_FIRST, 1},
                                                 {GL_UNPACK_SKIP_IMAGES, 1}, {GL_UNPACK_IMAGE_HEIGHT, 9}};
  for (const auto& [name, value] : parameters)
    m_pixelStorei(name, value);
  for (int step = 0; step < 3; step++) {
    windows->update({100 + step, 100}, 8, 0);
    ASSERT_TRUE(texture.update(*windows));
    GLint found = 0;
    m_getIntegerv(GL_TEXTURE_BINDING_2D_ARRAY, &found);
    EXPECT_EQ(GLuint(found), other);
    m_getIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &found);
    EXPECT_EQ(GLuint(found), buffer);
    for (const auto& [name, value] : parameters) {
      m_getIntegerv(name, &found);
      EXPECT_EQ(found, value) << name;
    }
  }
  for (const auto& [name, value] : parameters)
    m_pixelStorei(name, name == GL_UNPACK_ALIGNMENT ? 4 : 0);
  m_bindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  const auto texels = image<std::uint16_t>(texture, *windows, 1, GL_RED, GL_HALF_FLOAT);
  EXPECT_EQ(wrongTexels(texels, *windows, 1,
                        [&](const std::uint16_t* texel, int level, int x, int y) {
                          return *texel == teHalfOfSample(std::uint16_t(pyramid.sample(level, x, y)));
                        }),
            0)
      << "what others have set has no effect on it";
  m_deleteTextures(1, &other);
  m_deleteBuffers(1, &buffer);
  texture.free();
}

TEST_F(TeClipmapTextureTest, NothingOfItStaysBehind) {
  const TestPyramid pyramid(6);
  const int before = textures();
  for (int round = 0; round < 5; round++) {
    const auto windows = makeWindows(pyramid, 17);
    ASSERT_TRUE(windows);
    TeClipmapTexture heights(context().id(), TeClipFormat::Short);
    TeClipmapTexture again(context().id(), TeClipFormat::Half);
    ASSERT_TRUE(heights.update(*windows));
    ASSERT_TRUE(again.update(*windows));
    EXPECT_EQ(textures(), before + 2);
    heights.free();
    again.free();
    again.free();
  }
  EXPECT_EQ(textures(), before);
}

TEST_F(TeClipmapTextureTest, TwoContextsHaveTexturesOfTheirOwn) {
  const TestPyramid pyramid(8);
  auto other = TeContext::create(s_kind, 64, 64);
  ASSERT_TRUE(other) << other.error().message;
  const auto tiles = pyramid.tiles(5);
  auto here = TeClipWindows::create(tiles, 33);
  auto there = TeClipWindows::create(tiles, 33);
  ASSERT_TRUE(here && there);
  TeClipmapTexture first(context().id(), TeClipFormat::Short);
  TeClipmapTexture second((*other)->id(), TeClipFormat::Short);
  for (int step = 0; step < 40; step++) {
    ASSERT_TRUE(context().makeCurrent());
    (*here)->update({60 + step, 60}, 8, 0);
    ASSERT_TRUE(first.update(**here));
    ASSERT_TRUE((*other)->makeCurrent());
    (*there)->update({200, 200 - 2 * step}, 8, 500);
    ASSERT_TRUE(second.update(**there));
  }
  const auto right = [&](const std::uint16_t* texel, int level, int x, int y) {
    return *texel == pyramid.sample(level, x, y);
  };
  const auto seconds = image<std::uint16_t>(second, **there, 1, GL_RED_INTEGER, GL_UNSIGNED_SHORT);
  EXPECT_EQ(wrongTexels(seconds, **there, 1, right), 0);
  second.free();
  ASSERT_TRUE(context().makeCurrent());
  const auto firsts = image<std::uint16_t>(first, **here, 1, GL_RED_INTEGER, GL_UNSIGNED_SHORT);
  EXPECT_EQ(wrongTexels(firsts, **here, 1, right), 0);
  first.free();
}

TEST_F(TeClipmapTextureTest, ALostContextTakesItsTextureWithIt) {
  const TestPyramid pyramid(6);
  const auto windows = makeWindows(pyramid, 17);
  ASSERT_TRUE(windows);
  auto other = TeContext::create(s_kind, 64, 64);
  ASSERT_TRUE(other);
  ASSERT_TRUE((*other)->makeCurrent());
  TeClipmapTexture texture((*other)->id(), TeClipFormat::Short);
  ASSERT_TRUE(texture.update(*windows));
  other->reset();
  texture.forget();
  EXPECT_EQ(texture.name(), 0u);
}

TEST_F(TeClipmapTextureTest, WhatDoesNotFitIsAnErrorWithoutATexture) {
  const int before = textures();
  const TestPyramid pyramid(6);
  const auto heights = makeWindows(pyramid, 17);
  ASSERT_TRUE(heights);
  TeClipmapTexture colours(context().id(), TeClipFormat::Colour);
  const TeStatus status = colours.update(*heights);
  ASSERT_FALSE(status);
  EXPECT_THAT(status.error().message, testing::HasSubstr("2 bytes"));
  EXPECT_EQ(colours.name(), 0u);
  EXPECT_EQ(textures(), before);
  EXPECT_FALSE(heights->uploads().empty()) << "they wait for a texture that fits";
}
