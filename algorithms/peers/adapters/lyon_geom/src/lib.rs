//! lyon_geom's intersection of two cubics behind the interface of ../../../peer.h.
use lyon_geom::euclid::default::Point2D;
use lyon_geom::CubicBezierSegment;
use std::os::raw::{c_char, c_int};

const ROOTS: usize = 1024;
const OVERLAPS: usize = 16;
const SOLVED: c_int = 0;
const REFUSED: c_int = 1;
const FAILED: c_int = 2;

#[repr(C)]
pub struct PeerCurve {
    degree: c_int,
    point: *const f64,
    weight: *const f64,
}

#[repr(C)]
pub struct PeerRoots {
    count: c_int,
    overlaps: c_int,
    coincident: c_int,
    root: [[f64; 2]; ROOTS],
    overlap: [[f64; 4]; OVERLAPS],
}

unsafe fn cubic(c: &PeerCurve) -> CubicBezierSegment<f64> {
    let p = |i: usize| Point2D::new(*c.point.add(2 * i), *c.point.add(2 * i + 1));
    CubicBezierSegment { from: p(0), ctrl1: p(1), ctrl2: p(2), to: p(3) }
}

fn is_taken(c: &PeerCurve) -> bool {
    c.degree == 3 && c.weight.is_null()
}

/// # Safety
/// The pointers are valid, and each curve has 2 (degree + 1) coordinates.
#[no_mangle]
pub unsafe extern "C" fn peer_intersect(f: *const PeerCurve, g: *const PeerCurve, out: *mut PeerRoots) -> c_int {
    if !is_taken(&*f) || !is_taken(&*g) {
        return REFUSED;
    }
    let (f, g) = (cubic(&*f), cubic(&*g));
    match std::panic::catch_unwind(|| f.cubic_intersections_t(&g)) {
        Ok(roots) => {
            for (i, (t, s)) in roots.iter().enumerate() {
                (*out).root[i] = [*t, *s];
            }
            (*out).count = roots.len() as c_int;
            SOLVED
        }
        Err(_) => FAILED,
    }
}

#[no_mangle]
pub extern "C" fn peer_version() -> *const c_char {
    concat!(env!("PEER_VERSION"), "\0").as_ptr() as *const c_char
}
