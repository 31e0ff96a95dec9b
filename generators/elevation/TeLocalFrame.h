#pragma once

#include "generators/base/TeResult.h"

/// A position in a plane: metres east and north, or coordinates of a file.
struct TePlanePoint {
  double x = 0;
  double y = 0;
};

/// The plane in which a file's terrain lies: local metres, x east and y north, around one fixed point of the
/// file's own coordinate system. Fixed when the file is opened; every height of the file rests on it.
///
/// *Linear*: coordinates in a unit of length; local = (coordinate - centre) · unit.
///
/// *Tangent* (longitude and latitude, up to kTangentDegrees across): the plane that touches the ellipsoid at
/// the centre, points projected along its normal, as PROJ's `+proj=ortho +lat_0 +lon_0` (EPSG method 9840).
/// True to scale at the centre; at 50 km from it distances are short by 0.003 %, at 500 km by 0.3 %.
///
/// *Plate* (longitude and latitude, larger than that): x = a·cos(centre latitude)·Δlongitude,
/// y = a·Δlatitude, as PROJ's `+proj=eqc +lat_ts +lat_0 +lon_0 +R=a`: a whole globe is a rectangle.
///
/// Both are evaluated in closed form with + - * / and sqrt alone, so that their bits are the same on every
/// machine. Coordinates of the file are given as offsets from the centre, in the file's unit, which keeps
/// full precision. Immutable, thread-safe.
class TeLocalFrame {
public:
  static constexpr double kTangentDegrees = 40;

  /// metresPerUnit: of the file's coordinates.
  static TeLocalFrame linear(double metresPerUnit);
  /// centreLatitude in radians; radiansPerUnit of the file's coordinates; the ellipsoid by its semi-major
  /// axis in metres and its inverse flattening (0 = sphere). The extent decides between tangent and plate.
  static TeLocalFrame geographic(double centreLatitude, double radiansPerUnit, double semiMajor,
                                 double inverseFlattening, TePlanePoint extentInUnits);

  bool isGeographic() const { return m_kind != Kind::Linear; }
  /// "linear", "tangent" or "plate".
  const char* name() const;

  /// Offset from the centre in the file's coordinates, of a local position. False where the plane has no
  /// point of the Earth, or the position is not finite.
  bool toFile(TePlanePoint local, TePlanePoint& offset) const;
  /// Local position of an offset from the centre. False for a point on the far side of the Earth.
  bool toLocal(TePlanePoint offset, TePlanePoint& local) const;

private:
  enum class Kind { Linear, Tangent, Plate };

  bool tangentToFile(TePlanePoint local, TePlanePoint& offset) const;
  bool tangentToLocal(TePlanePoint offset, TePlanePoint& local) const;

  Kind m_kind = Kind::Linear;
  double m_unit = 1; ///< metres, or radians
  double m_semiMajor = 0;
  double m_latitude = 0;
  double m_sin = 0; ///< of the centre's latitude
  double m_cos = 1;
  double m_axisRatio = 1;    ///< b² / a² = 1 - e²
  double m_normalRadius = 0; ///< N, radius of curvature in the prime vertical at the centre
};
