#include "patchdb/TeMeshCensus.h"
#include "patchdb/TeTestWorlds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

// Patches, seams and corner squares of blocks of any size, spacing and place tile the plane: every cell once,
// every interior edge in exactly two triangles of opposite direction, the rim one closed rectangle, vertices
// bit-equal wherever meshes meet.
TEST(HardCase, NoTJunctionsPatchdb) {
  long edges = 0;
  long cells = 0;
  for (int samples : {5, 7, 9, 17, 33})
    for (double spacing : {1.0, 0.1, 27.3})
      for (TePatchKey place : {TePatchKey{-2, -1, 0}, TePatchKey{1 << 20, -(1 << 24), 0}}) {
        auto database = teTestDatabase(std::make_shared<TeHashSource>(), samples, spacing);
        const int columns = 4;
        const int rows = 3;
        for (int y = 0; y < rows; ++y)
          for (int x = 0; x < columns; ++x)
            ASSERT_TRUE(database->build({place.x + x, place.y + y, 0}));
        TeMeshCensus census;
        for (const TePatchMesh& mesh : teBlockMeshes(*database, place, columns, rows))
          ASSERT_TRUE(census.add(mesh)) << samples << " " << spacing;
        // The outermost row of cells all round waits for patches that are not there.
        const int n = database->lattice().cells();
        const long width = columns * n - 2;
        const long height = rows * n - 2;
        ASSERT_EQ(long(census.triangles().size()), 2 * width * height);
        ASSERT_EQ(census.brokenEdges(), 0);
        ASSERT_EQ(long(census.rim().size()), 2 * (width + height));
        ASSERT_EQ(census.edgesWithTwoTriangles(), 3 * width * height - width - height);
        edges += census.edgesWithTwoTriangles();
        cells += width * height;
      }
  std::printf("NoTJunctionsPatchdb: %ld cells once each, %ld interior edges with two triangles, 0 others\n",
              cells, edges);
}
