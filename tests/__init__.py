"""The tests, one file a subject; `oracles/` and `native/` are what they and the benchmarks compare with."""
