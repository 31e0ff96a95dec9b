#pragma once

#include "generators/base/TeResult.h"

class QWidget;

/// SoQt's one application object.
class TeSoQtApplication {
public:
  /// Starts SoQt once and gives its top-level widget. Error: no display can be opened (Qt itself would end
  /// the program), or SoQt reports that there is no OpenGL.
  static TeResult<QWidget*> start();
};
