package nephele.engine.atmosphere;

import java.util.Arrays;

/**
 * A ray through the air in the frame of the planet, and the point on it that is looked at. The ray ends at the ground or
 * at the top of the air. It is cut where an integrand is not smooth: at heights, at the point nearest to the planet, at
 * the edges of the planet's shadow.
 */
final class AirRay {
    private static final double PLANET = Air.PLANET_RADIUS_METRES;

    private double radius;
    private double zenithCosine;
    private double sunCosine;
    private double betweenCosine;
    private double lengthMetres;
    private boolean hitsGround;
    private final double sunRadiusRadians;
    private final double[] cuts;
    private int cutCount;

    private double pointHeightMetres;
    private double pointZenithCosine;
    private double pointSunCosine;
    private double pointMolecules;
    private double pointAerosols;

    /** A ray under a sun that is a point. */
    AirRay() {
        this(0, 0);
    }

    /**
     * @param sunRadiusRadians angular radius of the disc that lights the air, which makes the edge of the shadow wide
     * @param moreCuts the greatest number of distances at which a segment is cut besides
     */
    AirRay(double sunRadiusRadians, int moreCuts) {
        this.sunRadiusRadians = sunRadiusRadians;
        cuts = new double[2 * Air.LAYERS_METRES.length + 14 + moreCuts];
    }

    /**
     * Sets the ray.
     *
     * @param heightMetres of its origin above the ground, 0 to {@link Air#TOP_METRES}
     * @param zenithCosine between the zenith of the origin and the ray
     * @param sunCosine between the zenith of the origin and the sun
     * @param betweenCosine between the ray and the sun
     */
    void set(double heightMetres, double zenithCosine, double sunCosine, double betweenCosine) {
        begin(heightMetres, zenithCosine, sunCosine, betweenCosine);
        double ground = halfChordSquared(PLANET);
        hitsGround = zenithCosine < 0 && ground >= 0;
        lengthMetres = hitsGround ? Math.max(0, -radius * zenithCosine - Math.sqrt(ground)) : toTop();
        cut();
    }

    /**
     * Sets a ray that ends after a distance, or at the top of the air. The ground does not stop it: below the ground the
     * air is that of height 0.
     */
    void setSegment(
            double heightMetres, double zenithCosine, double sunCosine, double betweenCosine, double lengthMetres) {
        setSegment(heightMetres, zenithCosine, sunCosine, betweenCosine, new double[] {lengthMetres});
    }

    /** Sets a ray as the other method does, cut at distances of which the last is its length. */
    void setSegment(
            double heightMetres, double zenithCosine, double sunCosine, double betweenCosine, double[] distances) {
        begin(heightMetres, zenithCosine, sunCosine, betweenCosine);
        hitsGround = false;
        lengthMetres = Math.max(0, Math.min(distances[distances.length - 1], toTop()));
        for (int i = 0; i < distances.length - 1; i++) {
            add(distances[i]);
        }
        cutAtHeight(0);
        cut();
    }

    private void begin(double heightMetres, double zenithCosine, double sunCosine, double betweenCosine) {
        radius = PLANET + heightMetres;
        this.zenithCosine = zenithCosine;
        this.sunCosine = sunCosine;
        this.betweenCosine = betweenCosine;
        cutCount = 0;
    }

    private double toTop() {
        return Math.max(0, -radius * zenithCosine + Math.sqrt(Math.max(0, halfChordSquared(Air.TOP_RADIUS_METRES))));
    }

    /** Negative if the line misses the sphere; the squares of the radii are not subtracted from each other. */
    private double halfChordSquared(double sphereRadius) {
        double along = radius * zenithCosine;
        return along * along + (sphereRadius - radius) * (sphereRadius + radius);
    }

    private void cut() {
        add(0);
        add(lengthMetres);
        add(-radius * zenithCosine);
        for (double height : Air.LAYERS_METRES) {
            cutAtHeight(height);
        }
        cutAtShadow(0);
        if (sunRadiusRadians > 0) {
            cutAtShadow(-sunRadiusRadians);
            cutAtShadow(sunRadiusRadians);
        }
        Arrays.sort(cuts, 0, cutCount);
    }

    private void cutAtHeight(double height) {
        double nearest = -radius * zenithCosine;
        double square = halfChordSquared(PLANET + height);
        if (square > 0) {
            add(nearest - Math.sqrt(square));
            add(nearest + Math.sqrt(square));
        }
    }

    /**
     * Cuts where the sun's middle has an angle above the horizon: on a half cone around the axis of the planet's shadow
     * that touches the planet. Cuts where the ray meets its other half do no harm.
     */
    private void cutAtShadow(double aboveHorizonRadians) {
        double s = Math.sin(aboveHorizonRadians);
        double square = 1 - s * s;
        double fromLimb = radius * sunCosine - PLANET * s;
        double a = square - betweenCosine * betweenCosine;
        double b = radius * zenithCosine * square - betweenCosine * fromLimb;
        double c = (radius - PLANET) * (radius + PLANET) * square - fromLimb * fromLimb;
        double root = b * b - a * c;
        if (root > 0) {
            double q = -b - Math.copySign(Math.sqrt(root), b);
            add(q / a);
            add(c / q);
        }
    }

    private void add(double distance) {
        if (distance >= 0 && distance <= lengthMetres) {
            cuts[cutCount++] = distance;
        }
    }

    /** Looks at a point of the ray. */
    void lookAt(double distance) {
        double rise = distance * (distance + 2 * radius * zenithCosine);
        double above = (radius - PLANET) * (radius + PLANET) + rise;
        double r = Math.sqrt(PLANET * PLANET + above);
        pointHeightMetres = Math.max(0, above / (r + PLANET));
        pointZenithCosine = clamped((radius * zenithCosine + distance) / r);
        pointSunCosine = clamped((radius * sunCosine + distance * betweenCosine) / r);
        pointMolecules = Air.molecules(pointHeightMetres);
        pointAerosols = Air.aerosols(pointHeightMetres);
    }

    private static double clamped(double cosine) {
        return Math.max(-1, Math.min(1, cosine));
    }

    double lengthMetres() {
        return lengthMetres;
    }

    boolean hitsGround() {
        return hitsGround;
    }

    /** Returns the number of pieces between cuts. */
    int pieceCount() {
        return cutCount - 1;
    }

    /** Returns the distance at which a piece begins, and the one before it ends. */
    double cut(int index) {
        return cuts[index];
    }

    double betweenCosine() {
        return betweenCosine;
    }

    double pointHeightMetres() {
        return pointHeightMetres;
    }

    double pointZenithCosine() {
        return pointZenithCosine;
    }

    double pointSunCosine() {
        return pointSunCosine;
    }

    /** Returns the density of the molecules, relative to that at the ground. */
    double pointMolecules() {
        return pointMolecules;
    }

    /** Returns the density of the aerosols, relative to that at the ground. */
    double pointAerosols() {
        return pointAerosols;
    }

    /** Puts the extinction of an air at the point, per metre, for each wavelength. */
    void putExtinctionPerMetre(Air air, double[] extinction) {
        air.putExtinctionPerMetre(pointHeightMetres, pointMolecules, pointAerosols, extinction);
    }
}
