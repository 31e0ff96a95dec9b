#pragma once

class SbColor;
class SoSeparator;

/// A small aircraft of flat faces, white and one more colour, with normals for light: 9.6 m wide, 8.4 m long.
/// x right, y forward, z up; (0, 0, 0) is in the middle of the body below the wing.
SoSeparator* teAircraftModel(const SbColor& colour);
