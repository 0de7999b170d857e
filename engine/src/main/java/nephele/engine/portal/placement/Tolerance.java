package nephele.engine.portal.placement;

/** Tolerances for coplanarity, coincidence and containment, in metres. */
final class Tolerance {
    /** Greatest distance of a face's corners from its plane, in addition to rounding of coordinates. */
    static final double COPLANAR = 1e-3;

    /** Cosine of half a degree, the greatest angle between coplanar faces. */
    static final double COPLANAR_COSINE = 0.99996192306417131;

    /** Width below which noise in a piece's corners decides its normal, so that only its position counts. */
    static final double SLIVER = 1e-2;

    /** Half of the greatest gap between joined faces: cracks and noise of a mesh. */
    static final double CRACK = 5e-5;

    /** Distance within which a shape counts as touching a surface. */
    static final double STANDS_AGAINST = 1e-2;

    /** Greatest overlap of an aperture over an edge; below the documented 10⁻⁶. */
    static final double OVERLAP = 2e-7;

    private Tolerance() {}

    /** Returns the tolerance of a plane through points with coordinates up to {@code extent}. */
    static double coplanar(double extent) {
        return COPLANAR + 4 * Math.ulp(extent);
    }
}
