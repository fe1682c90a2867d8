/* Open CASCADE's Geom2dAPI_InterCurveCurve behind the interface of ../peer.h, a shared object of its own. */
#include <Geom2dAPI_InterCurveCurve.hxx>
#include <Geom2dInt_GInter.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <IntRes2d_IntersectionPoint.hxx>
#include <IntRes2d_IntersectionSegment.hxx>
#include <Standard_Failure.hxx>
#include <Standard_Version.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>

#include "../peer.h"

static const double tolerance = 1e-12;

static Handle(Geom2d_BezierCurve) curve(const peer_curve &c)
{
    TColgp_Array1OfPnt2d poles(1, c.degree + 1);
    for (int i = 0; i <= c.degree; i++) {
        poles(i + 1) = gp_Pnt2d(c.point[2 * i], c.point[2 * i + 1]);
    }
    if (!c.weight) {
        return new Geom2d_BezierCurve(poles);
    }
    TColStd_Array1OfReal weights(1, c.degree + 1);
    for (int i = 0; i <= c.degree; i++) {
        weights(i + 1) = c.weight[i];
    }
    return new Geom2d_BezierCurve(poles, weights);
}

static void add_segment(const IntRes2d_IntersectionSegment &segment, peer_roots *out)
{
    if (!segment.HasFirstPoint() || !segment.HasLastPoint()) {
        out->coincident = 1;
        return;
    }
    const IntRes2d_IntersectionPoint &a = segment.FirstPoint(), &b = segment.LastPoint();
    peer_add_overlap(out, a.ParamOnFirst(), b.ParamOnFirst(), a.ParamOnSecond(), b.ParamOnSecond());
}

extern "C" peer_outcome peer_intersect(const peer_curve *f, const peer_curve *g, peer_roots *out)
{
    if (f->degree > Geom2d_BezierCurve::MaxDegree() || g->degree > Geom2d_BezierCurve::MaxDegree()) {
        return PEER_REFUSED;
    }
    try {
        Geom2dAPI_InterCurveCurve meeting(curve(*f), curve(*g), tolerance);
        const Geom2dInt_GInter &found = meeting.Intersector();
        if (!found.IsDone()) {
            return PEER_FAILED;
        }
        for (int i = 1; i <= found.NbPoints(); i++) {
            peer_add(out, found.Point(i).ParamOnFirst(), found.Point(i).ParamOnSecond());
        }
        for (int i = 1; i <= found.NbSegments(); i++) {
            add_segment(found.Segment(i), out);
        }
        return PEER_SOLVED;
    } catch (const Standard_Failure &) {
        return PEER_FAILED;
    } catch (...) {
        return PEER_FAILED;
    }
}

extern "C" const char *peer_version(void)
{
    return OCC_VERSION_COMPLETE;
}
