#pragma once

class SoSeparator;

/// Makes what follows in a separator a background or an overlay: drawn in its own colours without light,
/// without reading or writing depth, and never picked.
void teAddOverlayState(SoSeparator& separator);
