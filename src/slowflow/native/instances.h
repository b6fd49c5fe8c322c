/* Every mechanism's solvers, and the table SF_TABLE of them. */
#include "interface.h"

#include "duffing.h"
#include "rod_spring.h"
#include "rod_spring_attached.h"
#include "rod_spring_exact.h"

#define SF_M(name) rod_spring_solver_##name
#define SF_KERNEL(name) rod_spring_##name
#define SF_NAME "rod_spring"
#define SF_DESIGN_SIZE 3
#define SF_IS_DESIGN(x) (x[0] > 0 && x[1] > 0 && x[2] >= 0 && x[2] < 1 && x[0] < HUGE_VAL && x[1] < HUGE_VAL)
#define SF_PARAMETERS_OF(x, p) rod_spring_coefficients(x[0], x[1], x[2], p)
#define SF_PARAMETERS ROD_SPRING_PARAMETERS
#define SF_BREAKPOINTS ROD_SPRING_BREAKPOINTS
#define SF_REACH 1.0
#include "mechanism.h"

#define SF_M(name) duffing_solver_##name
#define SF_KERNEL(name) duffing_##name
#define SF_NAME "duffing"
#define SF_DESIGN_SIZE 2
#define SF_IS_DESIGN(x) (fabs(x[0]) < HUGE_VAL && fabs(x[1]) < HUGE_VAL)
#define SF_PARAMETERS_OF(x, p) (p[0] = x[0], p[1] = x[1])
#define SF_PARAMETERS DUFFING_PARAMETERS
#define SF_BREAKPOINTS DUFFING_BREAKPOINTS
#define SF_REACH HUGE_VAL
#include "mechanism.h"

/* the force as the geometry gives it */
#define SF_M(name) rod_spring_exact_solver_##name
#define SF_KERNEL(name) rod_spring_exact_##name
#define SF_NAME "rod_spring_exact"
#define SF_DESIGN_SIZE 3
#define SF_IS_DESIGN(x) (x[0] > 0 && x[1] > 0 && x[2] >= 0 && x[2] < 1 && x[0] < HUGE_VAL && x[1] < HUGE_VAL)
#define SF_PARAMETERS_OF(x, p) rod_spring_exact_coefficients(x[0], x[1], x[2], p)
#define SF_PARAMETERS ROD_SPRING_EXACT_PARAMETERS
#define SF_BREAKPOINTS ROD_SPRING_EXACT_BREAKPOINTS
#define SF_REACH 1.0
#include "mechanism.h"

/* the first piece alone, for a response that cannot leave it: no angle is ever evaluated */
#define SF_M(name) rod_spring_attached_solver_##name
#define SF_KERNEL(name) rod_spring_attached_##name
#define SF_NAME "rod_spring_attached"
#define SF_DESIGN_SIZE 3
#define SF_IS_DESIGN(x) (x[0] > 0 && x[1] > 0 && x[2] >= 0 && x[2] < 1 && x[0] < HUGE_VAL && x[1] < HUGE_VAL)
#define SF_PARAMETERS_OF(x, p) rod_spring_coefficients(x[0], x[1], x[2], p)
#define SF_PARAMETERS ROD_SPRING_PARAMETERS
#define SF_BREAKPOINTS 0
#define SF_REACH 1.0
#include "mechanism.h"

/* by the order of their numbers in interface.h */
const sf_solver *const SF_TABLE[SF_MECHANISMS] = {&rod_spring_solver_solver, &duffing_solver_solver,
                                                  &rod_spring_exact_solver_solver,
                                                  &rod_spring_attached_solver_solver};
