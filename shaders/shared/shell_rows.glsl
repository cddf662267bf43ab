// Rows of the table of moments by shells.
layout(constant_id = 21) const uint kShellRows = 0u;  // 0: altitudes go with a square root, not by shells

uint shell_rows() { return kShellRows; }
