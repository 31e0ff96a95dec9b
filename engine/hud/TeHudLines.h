#pragma once

#include <string>
#include <vector>

class TeObject;
struct TeStatistics;

/// What the HUD says of an active object and the engine: position, velocity, height above ground, the
/// object's own lines, frame time, patches, error bound; with a pixel error, what it is and what it costs.
/// Numbers are rounded so that equal states give equal lines; lines are cut after 159 bytes.
std::vector<std::string> teHudLines(const TeObject& object, const TeStatistics& statistics);
