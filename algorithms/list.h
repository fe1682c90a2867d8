/* The registry: one line per algorithm; order here is order in the tables.  What only makes sense in doubles
 * is left out of the other builds.  CONTROL entries are deliberate mistakes, kept to show that the tests find
 * them. */
INTERSECTOR(subdivision)
INTERSECTOR(subdivision_oriented)
INTERSECTOR(bezier_clipping)
INTERSECTOR(hybrid_clipping_1)
INTERSECTOR(hybrid_clipping_2)
INTERSECTOR(hybrid_clipping_3)
INTERSECTOR(hybrid_clipping_2_scalar)
INTERSECTOR(hybrid_clipping_3_scalar)
INTERSECTOR(hybrid_clipping_1_arc)
INTERSECTOR(hybrid_clipping_2_arc)
INTERSECTOR(hybrid_clipping_3_arc)
INTERSECTOR(gap_clipping_2)
INTERSECTOR(gap_clipping_3)
INTERSECTOR(gap_clipping_4)
INTERSECTOR(gap_clipping_5)
INTERSECTOR(pair_clipping_1)
INTERSECTOR(pair_clipping_2)
INTERSECTOR(pair_clipping_3)
INTERSECTOR(implicitization)
INTERSECTOR(implicitization_quadratic)
INTERSECTOR(implicitization_cubic)
INTERSECTOR(certified)
#if !defined(FATLINE_QUAD) && !defined(FATLINE_MULTI)
INTERSECTOR(certified_scalar)
INTERSECTOR(resultant_eigen)
#endif

/* Other people's, with their own tables in peers/peers.c; whatever is not installed is listed as absent. */
#if !defined(FATLINE_QUAD) && !defined(FATLINE_MULTI)
PEER(lyon_geom)
PEER(lyon_geom_polished)
PEER(lib2geom)
PEER(lib2geom_polished)
PEER(open_cascade)
PEER(sisl)
PEER(sisl_polished)
PEER(cgal)
PEER(paper)
PEER(paper_polished)
PEER(flo_bezier3)
PEER(kld_intersections)
PEER(kld_intersections_polished)
PEER(bezier_js)
PEER(bezier_js_polished)
#endif

/* Variants for comparisons. */
#if !defined(FATLINE_QUAD) && !defined(FATLINE_MULTI)
VARIANT(certified_avx2)
#endif

CONTROL(control_discard_and)
CONTROL(control_no_margin)
CONTROL(control_normal_not_unit)
CONTROL(control_no_delta)

#define INTERSECTOR_DEFAULT certified

/* The same for the second part. */
#ifdef REGION_METHOD
REGION_METHOD(region_carriers)
REGION_METHOD(region_cutting)
#endif
#define INTERSECTOR_FLOOR newton_floor
