package nephele.engine.cloud.drawn;

import java.util.stream.IntStream;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** Shares of the sun's light that clouds leave, at points of a lattice over a region. Immutable. */
public final class SunShares {
    private static final double SPACING_METRES = 15;
    private static final int MOST_ACROSS = 48;
    private static final int MOST_LAYERS = 6;

    private final Size size;
    private final float[] shares;

    private SunShares(Size size, float[] shares) {
        this.size = size;
        this.shares = shares;
    }

    /** Numbers of points along the axes. */
    public record Size(int x, int y, int z) {
        /** Returns the lattice of a region. */
        public static Size of(Aabb region) {
            return new Size(
                    points(region.maxX() - region.minX(), MOST_ACROSS),
                    points(region.maxY() - region.minY(), MOST_LAYERS),
                    points(region.maxZ() - region.minZ(), MOST_ACROSS));
        }

        private static int points(double metres, int most) {
            return (int) Math.max(2, Math.min(most, Math.ceil(metres / SPACING_METRES)));
        }

        /** Returns the points of equal z. */
        public int slice() {
            return x * y;
        }
    }

    static SunShares of(DrawnClouds clouds, Aabb region) {
        Size size = Size.of(region);
        float[] shares = new float[size.slice() * size.z()];
        IntStream.range(0, size.z()).parallel().forEach(k -> {
            for (int at = 0; at < size.slice(); at++) {
                Vec3 place = new Vec3(
                        between(region.minX(), region.maxX(), at % size.x(), size.x()),
                        between(region.minY(), region.maxY(), at / size.x(), size.y()),
                        between(region.minZ(), region.maxZ(), k, size.z()));
                shares[k * size.slice() + at] = (float) clouds.sunShare(place);
            }
        });
        return new SunShares(size, shares);
    }

    private static double between(double min, double max, int index, int count) {
        return min + (index + 0.5) / count * (max - min);
    }

    /** Puts a slice of equal z as unsigned 16 bits, x fastest, on the way to another time's. */
    public void put(SunShares next, double share, int k, java.nio.ShortBuffer texels) {
        for (int at = k * size.slice(); at < (k + 1) * size.slice(); at++) {
            texels.put((short) Math.round(65535 * (shares[at] + share * (next.shares[at] - shares[at]))));
        }
    }
}
