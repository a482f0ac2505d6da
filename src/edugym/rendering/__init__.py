"""Pictures: a scene says what to show, one back end each draws it as SVG, pixels, a window or characters."""
