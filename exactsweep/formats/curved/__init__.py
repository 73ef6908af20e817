"""SVG and DXF: outlines with curves and transformations."""
