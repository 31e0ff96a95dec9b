#include "nodes/TePatchGraphBuilder.h"
#include "nodes/testWorld.h"
#include "patchdb/TeSurfaceNormals.h"
#include "render/TeRenderTest.h"
#include "render/topView.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstdio>

namespace {

constexpr int kPixels = 4; ///< a cell
constexpr int kCells = 94; ///< drawn, a side, of 3×3 patches of 32 cells
constexpr int kPatchCells = 32;

/// Changes of brightness between neighbouring pixels on both sides of lattice lines.
struct Steps {
  int largest = 0;
  double sum = 0;
  std::int64_t count = 0;
  double mean() const { return sum / double(count); }
  void add(int step) {
    largest = std::max(largest, step);
    sum += step;
    count++;
  }
};

struct Visibility {
  Steps seams;  ///< across the border between two patches and the lines one cell to either side of it
  Steps inside; ///< across all other lattice lines
};

int brightness(const TePicture& picture, int x, int y) {
  const TePicture::Pixel p = picture.pixel(x, y);
  return p[0] + p[1] + p[2];
}

/// Is a lattice line (in cells from the drawn rectangle's first line, which is sample 1 of a patch) a seam's?
bool isSeamLine(int line) {
  const int sample = (line + 1) % kPatchCells;
  return sample <= 1 || sample == kPatchCells - 1;
}

Visibility measure(const TePicture& picture) {
  Visibility visibility;
  for (int line = 1; line < kCells; line++) {
    Steps& steps = isSeamLine(line) ? visibility.seams : visibility.inside;
    const int edge = line * kPixels;
    for (int along = 0; along < kCells * kPixels; along++) {
      steps.add(std::abs(brightness(picture, edge, along) - brightness(picture, edge - 1, along)));
      steps.add(std::abs(brightness(picture, along, edge) - brightness(picture, along, edge - 1)));
    }
  }
  return visibility;
}

/// The block's drawn rectangle as one mesh, without patches or seams, from the heights alone.
TePatchMesh oneMesh(const TeStaticBlock& block) {
  const TeLattice& lattice = block.lattice();
  const int n = lattice.cells();
  const int side = block.patches() * n;
  const auto sample = [&](std::int64_t first, int index) { return lattice.position(first * n + index); };
  TeHeightMap heights = *TeHeightMap::create(side + 1, side + 1);
  for (int y = 0; y <= side; y++) {
    for (int x = 0; x <= side; x++)
      heights.at(x, y) =
          float(*block.database().heightAt({sample(block.firstKey().x, x), sample(block.firstKey().y, y)}));
  }
  TePatchMesh mesh;
  mesh.columns = mesh.rows = side - 1;
  mesh.origin = {sample(block.firstKey().x, 1), sample(block.firstKey().y, 1), 0};
  for (int y = 1; y < side; y++) {
    for (int x = 1; x < side; x++) {
      mesh.positions.emplace_back((x - 1) * lattice.spacing(), (y - 1) * lattice.spacing(), heights.at(x, y));
      mesh.normals.push_back(teSampleNormal(heights.at(x, y), heights.at(x - 1, y), heights.at(x + 1, y),
                                            heights.at(x, y - 1), heights.at(x, y + 1), lattice.spacing()));
    }
  }
  for (int y = 0; y + 1 < mesh.rows; y++) {
    for (int x = 0; x < mesh.columns; x++)
      mesh.strips.insert(mesh.strips.end(), {(y + 1) * mesh.columns + x, y * mesh.columns + x});
    mesh.strips.push_back(-1);
  }
  return mesh;
}

struct World {
  const char* generator;
  std::vector<std::string> filters;
};

class SeamVisibilityTest : public TeRenderTest {
protected:
  Visibility measureBlended(const World& world, std::uint64_t seed, TeBlendProfile blending) {
    TeWorld made = worldOf(world.generator, world.filters, 65, seed);
    made.blending = blending;
    const TeResult<TeStaticBlock> block = TeStaticBlock::build(made, {0, 0}, 3);
    EXPECT_TRUE(block) << block.error().message;
    return measure(drawPieces(*block, 0, "raking-blended"));
  }

  TePicture drawWhite(const TeStaticBlock& block, const std::vector<TePatchMesh>& meshes,
                      const std::string& name) {
    TePatchGraphBuilder builder(block.centre());
    TeSurfaceColours white;
    white.grass = white.rock = white.snow = {1, 1, 1};
    builder.setColours(white);
    TeNodePtr<SoSeparator> root(new SoSeparator);
    for (const TePatchMesh& mesh : meshes)
      root->addChild(builder.build(mesh).get());
    const auto view = topView(root.get(), kCells, SbVec3f(1, 0.35f, -0.25f)); // raking light
    return draw(view.get(), kCells * kPixels, kCells * kPixels, name);
  }

  /// The block in patches, seams and corners; the normals of seams and corners turned by `tilt`.
  TePicture drawPieces(const TeStaticBlock& block, float tilt, const std::string& name) {
    std::vector<TePatchMesh> pieces;
    const TeStatus status = block.forEachPiece([&](const TePatchMesh& mesh) {
      pieces.push_back(mesh);
      if (mesh.part != TeSurfacePart::Patch) {
        for (glm::vec3& normal : pieces.back().normals)
          normal = glm::normalize(normal + glm::vec3(tilt, 0, 0));
      }
    });
    EXPECT_TRUE(status);
    return drawWhite(block, pieces, name);
  }
};

void print(const World& world, std::uint64_t seed, const Visibility& visibility) {
  std::printf("%s%s, seed %d: largest step across seams %d, inside %d; mean %.2f and %.2f (of 765)\n",
              world.generator, world.filters.empty() ? "" : " filtered", int(seed), visibility.seams.largest,
              visibility.inside.largest, visibility.seams.mean(), visibility.inside.mean());
}

} // namespace

// Where maps agree, a border is a line like any other.
TEST_F(SeamVisibilityTest, NoLineUnderRakingLight) {
  const World worlds[] = {
      {"noise", {}}, {"noise", {"matrix"}}, {"function:z=\"6*sin(x/7)*cos(y/9)+2*sin(x*y/90)\"", {}}};
  for (const World& world : worlds) {
    for (std::uint64_t seed : {1, 2}) {
      auto block = TeStaticBlock::build(worldOf(world.generator, world.filters, 65, seed), {0, 0}, 3);
      ASSERT_TRUE(block) << block.error().message;
      const Visibility seen = measure(drawPieces(*block, 0, "raking-fitting"));
      print(world, seed, seen);
      EXPECT_GT(seen.inside.largest, 10) << "the light shows nothing";
      EXPECT_LE(seen.seams.largest, seen.inside.largest);
      EXPECT_LE(seen.seams.mean(), 1.2 * seen.inside.mean());
    }
  }
}

// Nor does a border show where independent maps are blended: smooth weights leave it without slope, where the
// linear ones of the document crease it. (Circles are only printed: near borders one map has most of the
// weight, and a small hill of it that lies there keeps its full curvature, in 1 of these 6 worlds more than
// any hill inside.)
TEST_F(SeamVisibilityTest, NoLineWhereMapsAreBlended) {
  const World worlds[] = {{"faults:profile=smooth", {}},
                          {"faults", {"band"}},
                          {"faults", {"matrix"}},
                          {"midpoint", {}},
                          {"circles", {}}};
  for (const World& world : worlds)
    for (std::uint64_t seed = 1; seed <= 6; seed++) {
      const Visibility seen = measureBlended(world, seed, TeBlendProfile::Smooth);
      print(world, seed, seen);
      EXPECT_GT(seen.inside.largest, 10) << "the light shows nothing";
      if (world.generator != std::string("circles")) {
        EXPECT_LE(seen.seams.largest, seen.inside.largest) << world.generator << " " << seed;
      }
    }
}

// The test above would find a crease: linear weights make one.
TEST_F(SeamVisibilityTest, LinearWeightsShowBorders) {
  const World world = {"faults:profile=smooth", {}};
  int worlds = 0;
  for (std::uint64_t seed = 1; seed <= 6; seed++) {
    const Visibility linear = measureBlended(world, seed, TeBlendProfile::Linear);
    const Visibility smooth = measureBlended(world, seed, TeBlendProfile::Smooth);
    std::printf("linear weights: ");
    print(world, seed, linear);
    worlds += linear.seams.largest > linear.inside.largest;
    EXPECT_GT(linear.seams.mean() / linear.inside.mean(), smooth.seams.mean() / smooth.inside.mean()) << seed;
  }
  EXPECT_GT(worlds, 0);
}

// Drawing in pieces adds nothing to the picture, whatever the heights.
TEST_F(SeamVisibilityTest, PiecesDrawLikeOneMesh) {
  const World worlds[] = {
      {"faults", {}}, {"faults", {"matrix"}}, {"circles", {}}, {"midpoint", {}}, {"noise", {}}};
  for (const World& world : worlds) {
    auto block = TeStaticBlock::build(worldOf(world.generator, world.filters, 65, 1), {0, 0}, 3);
    ASSERT_TRUE(block) << block.error().message;
    const TePicture pieces = drawPieces(*block, 0, std::string("raking-") + world.generator);
    const TePicture whole = drawWhite(*block, {oneMesh(*block)}, "raking-whole");
    ASSERT_FALSE(pieces.rgba.empty() || whole.rgba.empty());
    int different = 0;
    int largest = 0;
    for (std::size_t i = 0; i < pieces.rgba.size(); i++) {
      const int difference = std::abs(int(pieces.rgba[i]) - int(whole.rgba[i]));
      different += difference > 0;
      largest = std::max(largest, difference);
    }
    // A renderer may interpolate along a triangle from another corner, and round the other way.
    EXPECT_LE(largest, 1) << world.generator;
    std::printf("pieces and one mesh: %d of %zu values differ, by at most %d\n", different,
                pieces.rgba.size(), largest);
    print(world, 1, measure(pieces));
  }
}

// Normals that are wrong by three degrees along the seams are found.
TEST_F(SeamVisibilityTest, WrongNormalsWouldBeSeen) {
  auto block = TeStaticBlock::build(worldOf("noise", {}, 65, 1), {0, 0}, 3);
  ASSERT_TRUE(block) << block.error().message;
  const Visibility exact = measure(drawPieces(*block, 0, "raking-exact"));
  const Visibility wrong = measure(drawPieces(*block, 0.05f, "raking-wrong"));
  std::printf("tilted by 3 degrees: mean step across seams %.2f instead of %.2f\n", wrong.seams.mean(),
              exact.seams.mean());
  EXPECT_GT(wrong.seams.mean(), 1.2 * wrong.inside.mean());
  EXPECT_GT(wrong.seams.largest, wrong.inside.largest);
}
