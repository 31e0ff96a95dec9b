#pragma once

#include "engine/objects/TeAircraft.h"
#include "engine/paths/TePathTraveller.h"

/// An aircraft that flies a path instead of listening to keys.
///
/// It is where the path's traveller is; at a height above ground it follows the terrain below as a damped
/// spring does (kStiffness), and never comes nearer to known ground than TeAircraft::kClearance. Where the
/// ground is not known it keeps its altitude. After a jump it is at its height at once, or as high as it was
/// above the last known ground. At the path's end it rests in the air.
class TePathAircraft : public TeAircraft {
public:
  static constexpr double kStiffness =
      1.5; ///< radians a second: hills passed in less than that are flown through

  TePathAircraft(std::string name, TePathTraveller traveller,
                 const SbColor& colour = SbColor(0.85f, 0.2f, 0.1f));

  const TePathTraveller& traveller() const { return m_traveller; }

  void update(const TeUpdate& update) override;
  bool moving() const override { return !m_traveller.ended(); }
  bool handleEvent(const TeKeyEvent& event) override;
  std::vector<std::string> helpLines() const override;
  std::uint64_t stateHash() const override;

private:
  /// Of the traveller's place.
  double altitude(const TeUpdate& update, bool jumped);

  TePathTraveller m_traveller;
  double m_ground = 0; ///< the last that was known
  double m_climb = 0;  ///< m/s
};
