"""The averaged equations as numbers: mechanism, model, checks of arguments, the compiled solvers."""
