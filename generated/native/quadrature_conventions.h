/* What integrals over the quarter cycle and their enclosures have in common, in C and in Python.

   Written by `make derive` from derivations/codegen/conventions.toml; never edit. */

#ifndef QUADRATURE_CONVENTIONS_H
#define QUADRATURE_CONVENTIONS_H

/* what halving may change of a sum that has settled, of its size */
#define SF_AGREED 1.4210854715202004e-14
/* in place of a rounding of A and of a parameter, relatively */
#define SF_MOVED_BY 8.8817841970012523e-16
/* a part of the quarter that one panel is enough for */
#define SF_SHORT_PART 9.5367431640625e-07
/* from which on rounding is looked at */
#define SF_FEWEST_PANELS 16
/* after which a sum is given up */
#define SF_MOST_PANELS 512
/* of Gauss's rule on a panel */
#define SF_NODES 16
/* power of what is divided into panels that the angle from a piece's begin is */
#define SF_DENSE 3
/* an amplitude next to 0 */
#define SF_NEXT_TO_ZERO 3.8725919148493183e-121
/* of the quarter cycle, of each piece, in which an average by quadrature is enclosed */
#define SF_PARTS 24
/* how often the first of them is halved at most */
#define SF_HALVED 64
/* relative error of an angle in an enclosure */
#define SF_ANGLE 3.5527136788005009e-15
/* of an enclosure, beyond which it is not known */
#define SF_LARGEST_SUM 9.7453140113999991e+288
/* integrals of a contact in an enclosure */
#define SF_CONTACT_SUMS 5

#endif
