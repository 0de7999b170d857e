package nephele.engine.level.appearance;

import nephele.engine.math.Directions;
import nephele.engine.math.Pcg3d;
import nephele.engine.math.Vec3;

/**
 * One star in each cell of a cube around the eye, some 9600 to magnitude 6; the twin of {@code stars} in {@code
 * atmosphere.frag}.
 */
final class StarCells {
    private static final int CELLS = 40;

    /** The sun's magnitude; magnitudes are −2.5 log10 of flux. */
    private static final double SUN_MAGNITUDE = -26.74;

    private StarCells() {}

    /**
     * Returns the radiance per unit irradiance of the sun.
     *
     * @param direction unit, along the axes of the stars
     */
    static Vec3 radiance(Vec3 direction, double pixelRadians) {
        double[] d = {direction.x(), direction.y(), direction.z()};
        double x = Math.abs(d[0]);
        double y = Math.abs(d[1]);
        double z = Math.abs(d[2]);
        int axis = x > y && x > z ? 0 : y > z ? 1 : 2;
        int next = (axis + 1) % 3;
        int last = (axis + 2) % 3;
        double along = Math.abs(d[axis]);
        int column = (int) Math.floor((d[next] / along * 0.5 + 0.5) * CELLS);
        int row = (int) Math.floor((d[last] / along * 0.5 + 0.5) * CELLS);
        Pcg3d random = Pcg3d.of(column + 64, row, axis * 2 + (d[axis] > 0 ? 1 : 0));
        double[] star = new double[3];
        star[axis] = Math.signum(d[axis]);
        star[next] = (column + 0.15 + 0.7 * Pcg3d.unit(random.x())) / CELLS * 2 - 1;
        star[last] = (row + 0.15 + 0.7 * Pcg3d.unit(random.y())) / CELLS * 2 - 1;
        double spread = 0.6 * Math.max(pixelRadians, 2e-4);
        double apart =
                direction.minus(Directions.unit(star[0], star[1], star[2])).length();
        // The number of stars grows by 10^0.5 with each magnitude.
        double magnitude = Math.max(-1, 6 + 2 * Math.log10(Math.max(Pcg3d.unit(random.z()), 1e-4)));
        double flux = Math.pow(10, -0.4 * (magnitude - SUN_MAGNITUDE)) * Moonlight.NIGHT_GAIN;
        double square = 2 * spread * spread;
        return tint(Pcg3d.unit(random.x())).scaled(flux * Math.exp(-apart * apart / square) / (Math.PI * square));
    }

    /** Returns a colour between an orange and a blue star's. */
    private static Vec3 tint(double random) {
        double blue = random * 57 - Math.floor(random * 57);
        return new Vec3(1, 0.8, 0.6).scaled(1 - blue).addScaled(blue, new Vec3(0.7, 0.85, 1));
    }
}
