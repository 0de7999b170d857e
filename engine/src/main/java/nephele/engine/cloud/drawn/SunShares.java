package nephele.engine.cloud.drawn;

import java.util.stream.IntStream;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** Shares of the sun's light that clouds leave, at points of a lattice over a region. Immutable. */
public final class SunShares {
    /** Points along x and z. */
    public static final int ACROSS = 48;
    /** Points along y. */
    public static final int LAYERS = 6;

    private final float[] shares;

    private SunShares(float[] shares) {
        this.shares = shares;
    }

    static SunShares of(DrawnClouds clouds, Aabb region) {
        float[] shares = new float[ACROSS * LAYERS * ACROSS];
        IntStream.range(0, ACROSS).parallel().forEach(k -> {
            for (int at = 0; at < ACROSS * LAYERS; at++) {
                Vec3 place = new Vec3(
                        between(region.minX(), region.maxX(), at % ACROSS, ACROSS),
                        between(region.minY(), region.maxY(), at / ACROSS, LAYERS),
                        between(region.minZ(), region.maxZ(), k, ACROSS));
                shares[k * ACROSS * LAYERS + at] = (float) clouds.sunShare(place);
            }
        });
        return new SunShares(shares);
    }

    private static double between(double min, double max, int index, int count) {
        return min + (index + 0.5) / count * (max - min);
    }

    /** Puts a slice of equal z as unsigned 16 bits, x fastest, on the way to another time's. */
    public void put(SunShares next, double share, int k, java.nio.ShortBuffer texels) {
        for (int at = k * ACROSS * LAYERS; at < (k + 1) * ACROSS * LAYERS; at++) {
            texels.put((short) Math.round(65535 * (shares[at] + share * (next.shares[at] - shares[at]))));
        }
    }
}
