#pragma once

class SoSeparator;

/// Makes what follows in a separator a sign rather than a thing: drawn in its own colours without light or
/// fog, as faces whatever the style before, and never picked.
void teAddSignState(SoSeparator& separator);

/// Makes what follows in a separator a background or an overlay: signs that neither read nor write depth.
void teAddOverlayState(SoSeparator& separator);
