package nephele.engine.portal.placement;

/** What counts as the same plane, the same place and whole, in metres. */
final class Tolerance {
    /** A face belongs to a plane when no corner of it is farther off, and rounding of its coordinates besides. */
    static final double COPLANAR = 1e-3;

    /** Cosine of half a degree: faces that lean more are not coplanar. */
    static final double COPLANAR_COSINE = 0.99996192306417131;

    /** A piece thinner than this leans as noise in its corners will; only where it lies counts. */
    static final double SLIVER = 1e-2;

    /** Faces closer than twice this are joined: cracks and noise of a mesh. */
    static final double CRACK = 5e-5;

    /** What reaches this close to a surface stands against it. */
    static final double STANDS_AGAINST = 1e-2;

    /** An aperture may reach over an edge by this; less than the 10⁻⁶ that anybody is promised. */
    static final double OVERLAP = 2e-7;

    private Tolerance() {}

    /** Of a plane through places with coordinates up to {@code extent}. */
    static double coplanar(double extent) {
        return COPLANAR + 4 * Math.ulp(extent);
    }
}
