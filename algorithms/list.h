/* The registry: one line per algorithm; order here is order in the tables.  What only makes sense in doubles is left
 * out of the other builds.  CONTROL entries are deliberate mistakes, kept to show that the tests find them. */
INTERSECTOR(subdivision)
INTERSECTOR(subdivision_oriented)
INTERSECTOR(bezier_clipping)
INTERSECTOR(hybrid_clipping_1)
INTERSECTOR(hybrid_clipping_2)
INTERSECTOR(hybrid_clipping_3)
INTERSECTOR(hybrid_clipping_1_arc)
INTERSECTOR(hybrid_clipping_2_arc)
INTERSECTOR(hybrid_clipping_3_arc)
INTERSECTOR(implicitization)
INTERSECTOR(certified)
#if !defined(FATLINE_QUAD) && !defined(FATLINE_MULTI)
INTERSECTOR(resultant_eigen)
#endif

CONTROL(control_discard_and)
CONTROL(control_no_margin)
CONTROL(control_normal_not_unit)

#define INTERSECTOR_DEFAULT bezier_clipping
