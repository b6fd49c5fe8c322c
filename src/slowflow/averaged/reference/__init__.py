"""The averaged questions on NumPy: in goes a model, out come answers by the same methods as the compiled ones."""
