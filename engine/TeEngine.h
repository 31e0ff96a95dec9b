#pragma once

#include "engine/TePatch.h"
#include "generators/TeGenerator.h"
#include "nodes/TePatchGraphBuilder.h"
#include "patchdb/TePatchDatabase.h"

#include <Inventor/SbVec2d.h>
#include <Inventor/SbVec2f.h>
#include <Inventor/SbVec2s.h>

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

/// An endless terrain for an Inventor program, with the calls of document 002.
///
///     TeEngine* engine = new TeEngine(SbVec2s(65, 65), SbVec2f(64.0f, 64.0f));
///     TePatch* patch = engine->getPatch(SbVec2f(0.0f, 0.0f));
///     patch->prepareBuildMaps();
///     patch->buildHMapFromBuildMaps();
///     root->addChild(patch->getPatchGraph());
///
/// Calls that fail return NULL or FALSE, change nothing, leave one line in lastError() and send it to TeLog.
/// Ownership: the caller deletes the engine; the engine deletes its patches; graphs are Coin nodes, which
/// live on in the scenes that hold them. For the thread that makes all Coin calls, after SoDB::init().
class TeEngine {
public:
  /// `samples`: of a source map, both sides equal and odd, 5 .. 16385. `area`: metres that a source map
  /// covers, both sides equal; a patch covers half a side, here 32×32 m. Bad arguments: isValid() is FALSE
  /// and every other call fails.
  TeEngine(const SbVec2s& samples, const SbVec2f& area);
  ~TeEngine();
  TeEngine(const TeEngine&) = delete;
  TeEngine& operator=(const TeEngine&) = delete;

  SbBool isValid() const { return m_database != nullptr; }
  /// The last failed call's error; empty if none has failed.
  const std::string& lastError() const { return m_lastError; }

  /// The world's seed, 0 by default. FALSE once a patch exists.
  SbBool setSeed(std::uint64_t seed);
  /// The weights of the four source maps of a patch, smooth by default. FALSE once a patch exists.
  SbBool setBlending(TeBlendProfile profile);
  /// The generator by specification (TeGeneratorRegistry), with filters over it; its
  /// kDefaultGenerator alone by default.
  /// Maps made before keep theirs, and blending joins the two. FALSE, and the generator as before: unknown
  /// names or unusable parameters.
  SbBool setGenerator(const std::string& specification, const std::vector<std::string>& filters = {});
  /// A generator of the program's own.
  SbBool setGenerator(std::unique_ptr<TeGenerator> generator);
  /// Its public parameters may be changed at any time: they hold for the maps made from then on. Only if
  /// valid.
  TeGenerator& getGenerator() { return *m_generator; }

  /// The point of the world that graphs have at their (0, 0, 0); (0, 0) by default. Coin's coordinates are
  /// float, so choose it near what is shown. Moves the graphs made before, too.
  SbBool setOrigin(const SbVec2d& point);
  /// How graphs made from now on look: colours, a draped image. NULL if not valid.
  TePatchGraphBuilder* getGraphBuilder();

  /// The patch that contains a point, metres; usually its centre is given. Made if it was not known, without
  /// heights. NULL: the point is not finite or beyond the range of keys.
  TePatch* getPatch(const SbVec2f& point);
  TePatch* getPatch(const SbVec2d& point);
  TePatch* getPatch(const TePatchKey& key);

  /// All known terrain, for queries: heights, normals, rays. NULL if not valid. setSeed() and setBlending()
  /// make a new one.
  const TePatchDatabase* getDatabase() const { return m_database.get(); }

private:
  friend class TePatch;
  SbBool fail(const TeError& error);
  /// Hands the generator's present parameters to the database.
  SbBool updateParams();
  SbBool createDatabase();
  /// Null before SoDB::init().
  TeNodePtr<SoSeparator> makeGraph(const TePatchMesh& mesh);

  bool m_usable = false; ///< the constructor's arguments were good
  TeLattice m_lattice;
  std::uint64_t m_seed = 0;
  TeBlendProfile m_blending = TeBlendProfile::Smooth;
  std::unique_ptr<TeGenerator> m_generator;
  TeHeightSourcePtr m_source;
  std::unique_ptr<TePatchDatabase> m_database;
  SbVec2d m_origin{0, 0};
  std::unique_ptr<TePatchGraphBuilder> m_graphs; ///< made when first needed
  std::unordered_map<TePatchKey, std::unique_ptr<TePatch>, TePatchKeyHash> m_patches;
  std::string m_lastError;
};
