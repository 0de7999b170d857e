package nephele.engine.reference;

import java.util.SplittableRandom;
import java.util.stream.IntStream;
import nephele.engine.math.Hash64;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The sky, its clouds and its air as seen from one place, in a table over all directions: a bake asks for them hundreds
 * of times at each of a hundred thousand places, between which they differ little.
 */
public final class SkyPanorama {
    /** Texels along a side of each of the six faces of a cube. */
    private static final int SIDE = 32;

    /** Samples of a texel where clouds make the sky's light random. */
    private static final int CLOUDED_SAMPLES = 16;

    private final float[] radiance = new float[6 * SIDE * SIDE * 3];

    private SkyPanorama() {}

    static SkyPanorama of(TracedLevel level, Vec3 eye) {
        SkyPanorama sky = new SkyPanorama();
        int samples = level.hasClouds() ? CLOUDED_SAMPLES : 1;
        IntStream.range(0, 6 * SIDE).parallel().forEach(row -> {
            GatherRays open = level.skyRays();
            for (int column = 0; column < SIDE; column++) {
                int texel = row * SIDE + column;
                SplittableRandom random = new SplittableRandom(Hash64.combine(texel, samples));
                Vector3d sum = new Vector3d();
                for (int i = 0; i < samples; i++) {
                    open.trace(eye.toVector(), direction(texel), random);
                    sum.add(open.arriving());
                }
                for (int channel = 0; channel < 3; channel++) {
                    sky.radiance[3 * texel + channel] = (float) (sum.get(channel) / samples);
                }
            }
        });
        return sky;
    }

    /** Returns the direction through the middle of a texel. */
    private static Vector3d direction(int texel) {
        int face = texel / (SIDE * SIDE);
        double s = 2 * (texel % SIDE + 0.5) / SIDE - 1;
        double t = 2 * (texel / SIDE % SIDE + 0.5) / SIDE - 1;
        double side = face % 2 == 0 ? 1 : -1;
        Vector3d direction =
                switch (face / 2) {
                    case 0 -> new Vector3d(side, s, t);
                    case 1 -> new Vector3d(s, side, t);
                    default -> new Vector3d(s, t, side);
                };
        return direction.normalize();
    }

    /** Returns the radiance from a direction, interpolated within a face of the cube. */
    Vector3d at(Vector3dc d) {
        double x = Math.abs(d.x());
        double y = Math.abs(d.y());
        double z = Math.abs(d.z());
        int axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
        double length = axis == 0 ? x : axis == 1 ? y : z;
        double s = (axis == 0 ? d.y() : d.x()) / length;
        double t = (axis == 2 ? d.y() : d.z()) / length;
        int face = 2 * axis + (d.get(axis) >= 0 ? 0 : 1);
        double column = Math.max(0, Math.min((s + 1) / 2 * SIDE - 0.5, SIDE - 1));
        double row = Math.max(0, Math.min((t + 1) / 2 * SIDE - 0.5, SIDE - 1));
        int left = Math.min((int) column, SIDE - 2);
        int low = Math.min((int) row, SIDE - 2);
        Vector3d sum = new Vector3d();
        for (int corner = 0; corner < 4; corner++) {
            double across = corner % 2 == 0 ? left + 1 - column : column - left;
            double up = corner / 2 == 0 ? low + 1 - row : row - low;
            int at = 3 * ((face * SIDE + low + corner / 2) * SIDE + left + corner % 2);
            sum.add(across * up * radiance[at], across * up * radiance[at + 1], across * up * radiance[at + 2]);
        }
        return sum;
    }
}
