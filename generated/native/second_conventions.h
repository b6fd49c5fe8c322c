/* What the solvers of the second approximation have in common, in C and in Python.

   Written by `make derive` from derivations/codegen/conventions.toml; never edit. */

#ifndef SECOND_CONVENTIONS_H
#define SECOND_CONVENTIONS_H

/* What a curve of the second approximation is followed for. */
typedef enum {
    SF_EVERY_POINT = 0, /* all of its points */
    SF_FOLDS_ONLY = 1, /* those next to which F_A may vanish */
    SF_TOP_ONLY = 2 /* those next to which u_max may be largest */
} sf_wanted;

/* change of ln A, ln Omega up to which it is a correction, share of A too */
#define SF_SMALL 0.20000000000000001
/* the same of the spring's harmonics: from 1/8 on the mass might not turn where they add up */
#define SF_HARMONICS 0.10000000000000001
/* of Newton's iteration, at most */
#define SF_STEPS 25
/* longest step in ln A, R/F_0 and ln Omega */
#define SF_LONGEST 0.10000000000000001
/* the step that ends the iteration */
#define SF_DONE 9.9999999999999994e-12
/* the last step of a point of a curve, where the next is its square */
#define SF_MOVED 1e-08
/* of R, over A Omega^2 */
#define SF_ROUNDING 1.7763568394002505e-15
/* of ln Omega in the distance, with ln A and R/F_0 */
#define SF_WEIGHT 2.0
/* steps to the frequency of a given R */
#define SF_MATCHING 5
/* relative distance up to which two answers are one */
#define SF_SETTLED 9.9999999999999995e-08
/* size of F_A where it has vanished, over that at the neighbouring points */
#define SF_VANISHED 0.001
/* points of the curve on which folds and states are looked for */
#define SF_SAMPLES 600
/* how far that curve reaches beyond the frequencies of the query */
#define SF_BEYOND 1.3

#endif
