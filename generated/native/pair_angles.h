/* The arctangent of a pair.

   Written by `make derive`; never edit.
   Input: none but the series in derivations/codegen/arctangent.py
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#ifndef PAIR_ANGLES_H
#define PAIR_ANGLES_H

#include "pair.h"

#if defined(__GNUC__)
#define PAIR_ANGLES_CONST __attribute__((const))
#else
#define PAIR_ANGLES_CONST
#endif

/* The angle whose tangent is y/x, 0 <= y <= x: where an angle and its complement are asked for, it is computed once. */
PAIR_ANGLES_CONST static sf_pair pair_angles_acute(sf_pair y, sf_pair x)
{
    static const sf_pair table[] = {
        {0.0, 0.0},
        {0.06241880999595735, -1.5490756308295046e-18},
        {0.12435499454676144, -3.1253241424539383e-18},
        {0.18534794999569476, 4.180692268843079e-18},
        {0.24497866312686414, 1.0698755618734451e-17},
        {0.30288486837497142, -1.1010827903001369e-17},
        {0.35877067027057225, -2.4623815582638635e-17},
        {0.41241044159738732, -1.5876522277706891e-17},
        {0.46364760900080609, 2.2698777452961687e-17},
        {0.51238946031073773, -2.5462781472855804e-17},
        {0.55859931534356244, -5.4556305485916264e-18},
        {0.60228734613496415, 2.9504307372284023e-17},
        {0.64350110879328437, 1.5834785051444286e-17},
        {0.68231655487474807, 6.9432236715600077e-18},
        {0.71882999962162453, -2.1478388444456983e-17},
        {0.75315128096219441, -2.4256934659182068e-17},
        {0.78539816339744828, 3.061616997868383e-17},
    };
    static const sf_pair first[] = {
        {0.1111111111111111, 6.1679056923619804e-18},
        {-0.14285714285714285, -7.9301644616082606e-18},
        {0.20000000000000001, -1.1102230246251566e-17},
        {-0.33333333333333331, -1.8503717077085941e-17},
    };
    static const double others[] = {
        0.047619047619047616,
        -0.052631578947368418,
        0.058823529411764705,
        -0.066666666666666666,
        0.076923076923076927,
        -0.090909090909090912,
    };
    const sf_pair t = sfp_div(y, x);
    const int k = t.high > 0 ? (int)(16 * t.high + 0.5) : 0; /* of no number, as in a lane that is not asked, too */
    const double c = k / 16.0;
    const sf_pair z = k == 0 ? t : sfp_div(sfp_sub(t, sfp_point(c)), sfp_add(sfp_point(1.0), sfp_times(c, t)));
    const sf_pair w = sfp_square(z);
    double tail = others[0];
    for (int i = 1; i < 6; i++)
        tail = tail * w.high + others[i];
    sf_pair e = sfp_add(sfp_mul(w, sfp_point(tail)), first[0]);
    for (int i = 1; i < 4; i++)
        e = sfp_add(sfp_mul(w, e), first[i]);
    return sfp_add(table[k], sfp_add(z, sfp_mul(z, sfp_mul(w, e))));
}

/* The angle of (x, y) from 0 to pi/2, x and y not negative, not both 0. */
TWOFOLD_INLINE sf_pair pair_angles_atan2(sf_pair y, sf_pair x)
{
    const int steep = y.high > x.high;
    const sf_pair angle = pair_angles_acute(steep ? x : y, steep ? y : x);
    return steep ? sfp_sub(sfp_of(1.5707963267948966, 6.123233995736766e-17), angle) : angle;
}

/* The angle of (y, x): what pair_angles_atan2(x, y) gives. */
TWOFOLD_INLINE sf_pair pair_angles_atan2_swapped(sf_pair y, sf_pair x)
{
    const int steep = y.high > x.high;
    const sf_pair angle = pair_angles_acute(steep ? x : y, steep ? y : x);
    return steep ? angle : sfp_sub(sfp_of(1.5707963267948966, 6.123233995736766e-17), angle);
}

#endif
