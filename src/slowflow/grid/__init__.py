"""Maps of designs past one memory: in go arrays of xarray and dask, out come Datasets, and Zarr stores that resume.

Needs `pip install 'slowflow[grid]'`. Nothing of it is imported before such an array is given.
"""
