package nephele.engine.cloud.drawn;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.cloud.cells.CellBox;
import nephele.engine.cloud.cells.DensityCells;
import nephele.engine.cloud.field.PuffFilling;
import nephele.engine.level.Cloud;
import nephele.engine.math.Vec3;

/**
 * A finite cloud as soft balls of extinction σ exp(−d²/2s²) in the space that drifts with it. A cloud of puffs is its own;
 * any other density is divided into blocks of cells, each of which becomes a ball of the same mass. Immutable.
 *
 * @param all balls, in a fixed order
 */
public record CloudPuffs(List<Puff> all) {
    /** Balls that another density becomes at most. */
    private static final int MOST = 4000;
    /** Deviation of a block's ball in edges of the block: a lattice of them is even within 1 %. */
    private static final double SPREAD = 0.6;

    /**
     * One ball.
     *
     * @param deviationMetres s
     * @param perMetre σ, the extinction in its centre
     */
    public record Puff(Vec3 centre, double deviationMetres, double perMetre) {
        private static final double FAINTEST = 1e-4;
        private static final double MOST_DEVIATIONS = 5;

        /** Returns the distance from the centre at which it ends, 0 if nothing of it is visible; twin of {@code puffRadius}. */
        public double radiusMetres() {
            double depth = perMetre * deviationMetres * Math.sqrt(2 * Math.PI);
            return depth > FAINTEST
                    ? deviationMetres * Math.min(MOST_DEVIATIONS, Math.sqrt(2 * Math.log(depth / FAINTEST)))
                    : 0;
        }

        Puff thinned(double fraction) {
            return new Puff(centre, deviationMetres, fraction * perMetre);
        }
    }

    public CloudPuffs {
        all = List.copyOf(all);
    }

    /** Returns true for a cloud that can be divided into balls; an endless one cannot. */
    public static boolean canShow(CloudSource source) {
        return source.grid() == null;
    }

    /** Returns the balls of a sampled cloud. */
    public static CloudPuffs of(DrawnCloud cloud) {
        Cloud written = cloud.source().cloud();
        return written.density() instanceof Cloud.Density.Puffs puffs
                        && written.extent() instanceof Cloud.Extent.Volume volume
                ? written(puffs, volume.centre(), written.extinctionPerMetre())
                : fitted(cloud.cells().density().get(0));
    }

    /** Returns the balls between two times: those of both, each with its fraction. */
    public CloudPuffs towards(CloudPuffs next, double fraction) {
        if (fraction == 0 || next.all.equals(all)) {
            return this;
        }
        List<Puff> both = new ArrayList<>();
        all.forEach(puff -> both.add(puff.thinned(1 - fraction)));
        next.all.forEach(puff -> both.add(puff.thinned(fraction)));
        return new CloudPuffs(both);
    }

    private static CloudPuffs written(Cloud.Density.Puffs puffs, Vec3 centre, double perMetre) {
        return new CloudPuffs(PuffFilling.all(puffs).stream()
                .map(puff -> new Puff(centre.plus(puff.centre()), puff.radiusMetres() / 2, perMetre))
                .toList());
    }

    private static CloudPuffs fitted(DensityCells cells) {
        int side = 1;
        List<Puff> puffs = blocks(cells, side);
        while (puffs.size() > MOST) {
            side++;
            puffs = blocks(cells, side);
        }
        return new CloudPuffs(puffs);
    }

    private static List<Puff> blocks(DensityCells cells, int side) {
        CellBox box = cells.cells();
        List<Puff> puffs = new ArrayList<>();
        for (int k = 0; k < box.nz(); k += side) {
            for (int j = 0; j < box.ny(); j += side) {
                for (int i = 0; i < box.nx(); i += side) {
                    Puff puff = block(cells, side, i, j, k);
                    if (puff.perMetre > 0) {
                        puffs.add(puff);
                    }
                }
            }
        }
        return puffs;
    }

    private static Puff block(DensityCells cells, int side, int i, int j, int k) {
        CellBox box = cells.cells();
        double mass = 0;
        Vec3 moment = Vec3.ZERO;
        for (int z = k; z < Math.min(box.nz(), k + side); z++) {
            for (int y = j; y < Math.min(box.ny(), j + side); y++) {
                for (int x = i; x < Math.min(box.nx(), i + side); x++) {
                    double density = cells.density(x, y, z);
                    mass += density;
                    moment = moment.addScaled(density, new Vec3(box.centreX(x), box.centreY(y), box.centreZ(z)));
                }
            }
        }
        double volume = box.sizeX() * box.sizeY() * box.sizeZ();
        double s = SPREAD * side * Math.cbrt(volume);
        double whole = Math.pow(2 * Math.PI, 1.5) * s * s * s;
        return mass > 0
                ? new Puff(moment.scaled(1 / mass), s, mass * volume * cells.wholePerMetre() / whole)
                : new Puff(Vec3.ZERO, s, 0);
    }
}
