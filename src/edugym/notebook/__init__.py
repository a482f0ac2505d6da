"""For lessons: play with buttons, redo an experiment with sliders, look at an episode, read the real code.

Everything here works in Jupyter, Colab and VS Code with the core widgets of ipywidgets 7.7 or later, and leaves a still
picture where no kernel runs, as on GitHub.
"""

try:
    from edugym.notebook.buttons import play
    from edugym.notebook.film import frames
    from edugym.notebook.listing import source
    from edugym.notebook.sliders import explore
except ModuleNotFoundError:
    from edugym.extras import require

    require("notebook", "ipywidgets")
    raise

__all__ = ["explore", "frames", "play", "source"]
