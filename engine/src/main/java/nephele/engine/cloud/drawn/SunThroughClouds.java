package nephele.engine.cloud.drawn;

import java.nio.ShortBuffer;
import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.cloud.cells.CellBox;
import nephele.engine.cloud.cells.CellMarch;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** The transmittance of clouds for the sun's light, at points of a lattice over a region. Immutable. */
public final class SunThroughClouds {
    private static final double SPACING_METRES = 15;
    private static final int MOST_ACROSS = 48;
    private static final int MOST_LAYERS = 6;
    private static final CellMarch.OutsideOfCloud DARK =
            new CellMarch.OutsideOfCloud(new Vec3(0, 1, 0), Vec3.ZERO, Vec3.ZERO, Vec3.ZERO);

    private final List<DrawnCloud> clouds;
    private final Vec3 towardsSun;
    private final CellBox lattice;
    private final float[] transmittances;

    /** Marches from all points of a region's lattice on all processors. @param towardsSun unit */
    SunThroughClouds(List<DrawnCloud> clouds, Vec3 towardsSun, Aabb region) {
        this.clouds = List.copyOf(clouds);
        this.towardsSun = towardsSun;
        lattice = lattice(region);
        transmittances = new float[lattice.count()];
        IntStream.range(0, lattice.nz()).parallel().forEach(k -> {
            for (int j = 0; j < lattice.ny(); j++) {
                for (int i = 0; i < lattice.nx(); i++) {
                    Vec3 place = new Vec3(lattice.centreX(i), lattice.centreY(j), lattice.centreZ(k));
                    transmittances[lattice.index(i, j, k)] = (float) from(place);
                }
            }
        });
    }

    /** Returns the lattice of a region, whose points are the centres of cells. */
    public static CellBox lattice(Aabb region) {
        return new CellBox(
                region,
                points(region.maxX() - region.minX(), MOST_ACROSS),
                points(region.maxY() - region.minY(), MOST_LAYERS),
                points(region.maxZ() - region.minZ(), MOST_ACROSS));
    }

    private static int points(double metres, int most) {
        return (int) Math.max(2, Math.min(most, Math.ceil(metres / SPACING_METRES)));
    }

    /** Returns the transmittance from any place, by a march from there. */
    public double from(Vec3 place) {
        double left = 1;
        for (DrawnCloud cloud : clouds) {
            CellMarch march = cloud.march(DARK);
            march.march(
                    cloud.drifting(place, towardsSun.x(), towardsSun.y(), towardsSun.z()),
                    0,
                    Double.POSITIVE_INFINITY,
                    1,
                    0.5);
            left *= march.transmittance();
        }
        return left;
    }

    /** Puts a slice of equal z as unsigned 16 bits, x fastest, part of the way to another time's. */
    public void put(SunThroughClouds next, double fraction, int k, ShortBuffer texels) {
        int first = lattice.index(0, 0, k);
        for (int at = first; at < first + lattice.nx() * lattice.ny(); at++) {
            double left = transmittances[at] + fraction * (next.transmittances[at] - transmittances[at]);
            texels.put((short) Math.round(65535 * left));
        }
    }
}
