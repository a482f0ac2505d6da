"""Widgets for lessons: buttons to play, sliders, films of episodes, predictions, and listings of the real code.

They work in Jupyter, Colab and VS Code with the core widgets of ipywidgets 7.7 or later. Where no kernel runs, as on
GitHub, they leave a still picture.
"""

try:
    from edugym_course.notebook.buttons import play
    from edugym_course.notebook.controls import sliders
    from edugym_course.notebook.film import frames
    from edugym_course.notebook.listing import source
    from edugym_course.notebook.prediction import predict
except ModuleNotFoundError:
    from edugym.system.extras import require

    require("notebook", "ipywidgets")
    raise

__all__ = ["frames", "play", "predict", "sliders", "source"]
