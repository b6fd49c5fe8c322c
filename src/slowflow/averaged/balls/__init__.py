"""Proofs with as many digits as they take, where doubles do not decide. Needs python-flint."""
