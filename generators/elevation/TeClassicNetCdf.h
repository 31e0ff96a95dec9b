#pragma once

#include "generators/base/TeResult.h"

#include <string>

/// Checks that a netCDF file of the classic formats (CDF-1, CDF-2, CDF-5) is long enough for all variables
/// that its header names: the netCDF library reads zeros beyond the end of a file that was cut off. Files of
/// the HDF5 kind, whose library checks this itself, pass. Error: cut off, or a header that makes no sense.
/// Source: NetCDF Classic Format Specification, Unidata.
TeStatus teCheckClassicNetCdf(const std::string& path);
