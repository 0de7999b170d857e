package nephele.engine.cloud.drawn;

import java.util.Comparator;
import java.util.List;
import nephele.engine.cloud.cells.CellMarch;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/**
 * How a place sees the sky through clouds and with their light, in the directions of a cube map: what the clouds leave of
 * it, and what they add for unit light around them. Immutable.
 */
public final class SkyThroughClouds {
    /** Cells along a side of the cube. */
    public static final int SIDE = 8;

    private static final int VALUES = 4;
    /** Light of one kind in each colour: the sun's, that of the upper and that of the lower half of the sky. */
    private static final Vec3 SUN = new Vec3(1, 0, 0);

    private static final Vec3 ABOVE = new Vec3(0, 1, 0);
    private static final Vec3 BELOW = new Vec3(0, 0, 1);

    private final float[] values = new float[VALUES * 6 * SIDE * SIDE];

    private SkyThroughClouds() {}

    static SkyThroughClouds of(List<DrawnCloud> clouds, Vec3 towardsSun, Vec3 place) {
        var sky = new SkyThroughClouds();
        var outside = new CellMarch.OutsideOfCloud(towardsSun, SUN, ABOVE, BELOW);
        var fromFarthest = clouds.stream()
                .sorted(Comparator.comparingDouble(cloud -> -distance(cloud, place)))
                .toList();
        for (int cell = 0; cell < 6 * SIDE * SIDE; cell++) {
            Vector3d d = direction(cell);
            double left = 1;
            Vec3 light = Vec3.ZERO;
            for (DrawnCloud cloud : fromFarthest) {
                CellMarch march = cloud.march(outside);
                march.march(cloud.drifting(place, d.x, d.y, d.z), 0, Double.POSITIVE_INFINITY, 1, 0.5);
                left *= march.transmittance();
                light = light.scaled(march.transmittance()).plus(march.radiance());
            }
            sky.put(cell, left, light);
        }
        return sky;
    }

    private static double distance(DrawnCloud cloud, Vec3 place) {
        var bounds = cloud.source().bounds();
        return Math.max(0, Math.max(bounds.minY() - place.y(), place.y() - bounds.maxY()));
    }

    private void put(int cell, double left, Vec3 light) {
        values[VALUES * cell] = (float) left;
        values[VALUES * cell + 1] = (float) light.x();
        values[VALUES * cell + 2] = (float) light.y();
        values[VALUES * cell + 3] = (float) light.z();
    }

    /** Returns the unit direction of the middle of a cell. */
    private static Vector3d direction(int cell) {
        double s = 2 * (cell % SIDE + 0.5) / SIDE - 1;
        double t = 2 * (cell / SIDE % SIDE + 0.5) / SIDE - 1;
        int face = cell / (SIDE * SIDE);
        double w = (face & 1) == 0 ? 1 : -1;
        Vector3d direction =
                switch (face / 2) {
                    case 0 -> new Vector3d(w, s, t);
                    case 1 -> new Vector3d(s, w, t);
                    default -> new Vector3d(s, t, w);
                };
        return direction.normalize();
    }

    private static int cell(double x, double y, double z) {
        double ax = Math.abs(x);
        double ay = Math.abs(y);
        double az = Math.abs(z);
        if (ax >= ay && ax >= az) {
            return cell(x > 0 ? 0 : 1, y / ax, z / ax);
        }
        return ay >= az ? cell(y > 0 ? 2 : 3, x / ay, z / ay) : cell(z > 0 ? 4 : 5, x / az, y / az);
    }

    private static int cell(int face, double s, double t) {
        return (face * SIDE + index(t)) * SIDE + index(s);
    }

    private static int index(double coordinate) {
        return Math.max(0, Math.min(SIDE - 1, (int) ((coordinate + 1) / 2 * SIDE)));
    }

    /**
     * Returns the radiance from a direction, part of the way to another time's.
     *
     * @param clear radiance of the sky without clouds
     */
    public Vector3d from(
            SkyThroughClouds next,
            double fraction,
            Vector3d clear,
            CellMarch.OutsideOfCloud around,
            Vector3d direction) {
        int at = VALUES * cell(direction.x, direction.y, direction.z);
        double sun = mixed(next, fraction, at + 1);
        double above = mixed(next, fraction, at + 2);
        double below = mixed(next, fraction, at + 3);
        return clear.mul(mixed(next, fraction, at))
                .add(around.irradiance()
                        .scaled(sun)
                        .addScaled(above, around.above())
                        .addScaled(below, around.below())
                        .toVector());
    }

    private double mixed(SkyThroughClouds next, double fraction, int at) {
        return values[at] + fraction * (next.values[at] - values[at]);
    }
}
