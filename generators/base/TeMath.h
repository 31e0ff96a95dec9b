#pragma once

/// Elementary functions made of + - * / and exact bit operations alone, so that they have the same bits with
/// every compiler, library and optimisation, which those of the C library do not promise. Errors are in units
/// of the result's last place, the largest found against long double over 10^6 arguments (TeMath_test). Not a
/// number, and arguments outside the domain, give NaN; results too large give infinity. About 10 to 15 ns.
/// Source: Cody and Waite 1980 and Payne and Hanek 1983 for the arguments' reduction; series of our own.

/// Error < 2.5, for all finite arguments however large.
double teSin(double radians);
double teCos(double radians);
/// Error < 1.5.
double teExp(double x);
/// Natural logarithm; error < 1.5. 0 gives -infinity.
double teLog(double x);
/// Error < 3.
double teTanh(double x);
/// x to the power y. Whole y up to 1024 by multiplication: error < 2·|y| at worst, usually 1 or 2. Otherwise
/// exp(y·log x): relative error < 2^-52·(2 + |y·log x|). A negative x needs a whole y.
double tePow(double x, double y);
