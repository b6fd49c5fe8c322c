"""What kernels are to give, by routes other than the derivation: a room for each part of the catalogue.

Nothing here derives or computes with what is generated. Numbers are mpmath's, of 60 digits, or rationals.
"""

from flint import ctx
from mpmath import mp

mp.dps = 60
ctx.prec = 300
