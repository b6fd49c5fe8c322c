"""The corpus: what slowflow answers today, by which a change that should move no answer is judged (`make corpus`).

It says that answers are the same, not that they are right; `tests/certified` values and oracles do that.
"""
