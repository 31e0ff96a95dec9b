#pragma once

#include "nodes/lod/TeLodField.h"
#include "nodes/lod/TeLodMesh.h"
#include "nodes/lod/geomipmap/TeGeoMipErrors.h"
#include "nodes/lod/geomipmap/TeGeoMipPart.h"

/// Triangles of patches, and how far they are from the samples.
///
/// A vertex that the next coarser level lacks stands at own·w + coarser·(1 - w), `coarser` being the middle
/// of the edge of that level: w is the patch's weight, on a border the border's, 1 being kWhole. Between two
/// levels a regular patch deviates by the mixture of their errors. For any weights, a triangle deviates by no
/// more than with all vertices at their own heights, plus the farthest that one of them is moved; how far
/// vertices are is TeGeoMipErrors' midpoint error of the next level.
///
/// Thread-safe. Cost: a few ns a triangle.
class TeGeoMipMesh {
public:
  /// All must outlive it.
  TeGeoMipMesh(const TeLodField& field, const TeGeoMipPatterns& patterns, const TeGeoMipErrors& errors);

  /// What rounding adds to the error of parts that are morphed.
  double rounding() const { return m_rounding; }
  /// Largest deviation, in the unit of the samples.
  double error(const TeGeoMipPart& part) const;
  void append(const TeGeoMipPart& part, TeLodMesh& mesh) const;

private:
  TeLodVertex vertex(const TeGeoMipPart& part, int x, int y) const;

  const TeLodField& m_field;
  const TeGeoMipPatterns& m_patterns;
  const TeGeoMipErrors& m_errors;
  double m_rounding;
};
