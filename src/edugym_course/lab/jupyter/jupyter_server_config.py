"""Settings of JupyterLab's server that need the place of a file: its own style sheet, or that of the user."""

from pathlib import Path

from jupyter_core.paths import jupyter_config_dir

c = globals()["get_config"]()  # which Jupyter puts there when it runs this file
c.LabApp.custom_css = True
places = Path(jupyter_config_dir(), "custom"), Path(__file__).parent / "custom"  # the first that has the file
c.ServerApp.tornado_settings = {"static_custom_path": [str(place) for place in places]}
