"""The website: kernels, data, and the playground in a browser."""
