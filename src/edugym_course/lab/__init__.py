"""The lessons where a student works: fresh copies in a folder, a start page, JupyterLab, a record of what is solved."""
