#pragma once

/// Trigonometric functions whose bits rest on + - * / alone, for results that must not depend on the
/// machine's mathematics library. Angles in radians. Not correctly rounded: the error is below 4e-16
/// absolute. Cost: some 10 ns. Thread-safe.

/// Sine and cosine of an angle within ±1e5; beyond it the error grows with the angle.
double teSin(double angle);
double teCos(double angle);
/// The angle of the direction (x, y) in [-pi, pi]; 0 for (0, 0).
double teAtan2(double y, double x);
