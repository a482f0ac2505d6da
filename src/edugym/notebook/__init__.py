"""Widgets for lessons: buttons to play, sliders, films of episodes, predictions, and listings of the real code.

They work in Jupyter, Colab and VS Code with the core widgets of ipywidgets 7.7 or later. Where no kernel runs, as on
GitHub, they leave a still picture.
"""

try:
    from edugym.notebook.buttons import play
    from edugym.notebook.controls import sliders
    from edugym.notebook.film import frames
    from edugym.notebook.listing import source
    from edugym.notebook.prediction import predict
except ModuleNotFoundError:
    from edugym.extras import require

    require("notebook", "ipywidgets")
    raise

__all__ = ["frames", "play", "predict", "sliders", "source"]
