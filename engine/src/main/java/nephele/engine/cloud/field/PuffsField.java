package nephele.engine.cloud.field;

import java.util.List;
import java.util.OptionalDouble;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.MajorantWalk;
import nephele.engine.level.Cloud;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/**
 * A sum of soft balls of density exp(−d²/2s²), s half of a puff's radius. A puff ends at 5 s and nowhere nearer: the
 * extent of the cloud gives its centre, but does not cut it, so that its optical depth is the same from every side.
 */
public final class PuffsField implements ExtinctionField {
    private final List<GaussianPuff> puffs;
    private final double extinctionPerMetre;
    private final Aabb bounds;
    private final PuffCells cells;

    /**
     * @param puffs with centres relative to {@code centre}
     * @param centre world metres
     * @param extinctionPerMetre in the centre of a puff that no other overlaps
     */
    public PuffsField(List<Cloud.Puff> puffs, Vec3 centre, double extinctionPerMetre) {
        this.puffs = puffs.stream()
                .map(puff -> new GaussianPuff(centre.plus(puff.centre()), puff.radiusMetres() / 2))
                .toList();
        this.extinctionPerMetre = extinctionPerMetre;
        bounds = this.puffs.stream().map(GaussianPuff::bounds).reduce(Aabb.EMPTY, Aabb::union);
        cells = bounds.isEmpty() ? null : PuffCells.of(bounds, this.puffs);
    }

    @Override
    public double perMetre(double x, double y, double z) {
        if (!bounds.contains(x, y, z)) {
            return 0;
        }
        double sum = 0;
        int cell = cells.cell(x, y, z);
        for (int n = 0; n < cells.reaching(cell); n++) {
            sum += puffs.get(cells.puff(cell, n)).density(x, y, z);
        }
        return extinctionPerMetre * sum;
    }

    @Override
    public boolean isEmpty() {
        return extinctionPerMetre == 0 || bounds.isEmpty();
    }

    @Override
    public Aabb bounds() {
        return bounds;
    }

    @Override
    public MajorantWalk walk(Ray ray, double fromMetres, double toMetres) {
        if (cells == null) {
            return new UniformWalk(RaySpan.EMPTY, 0);
        }
        RaySpan span = RaySpan.inBox(ray, bounds, fromMetres, toMetres);
        return new CellWalk(ray, span, cells.lattice(), (i, j, k) -> extinctionPerMetre * cells.perMetre(i, j, k));
    }

    @Override
    public OptionalDouble closedDepth(Ray ray, double fromMetres, double toMetres) {
        double metres = 0;
        for (GaussianPuff puff : puffs) {
            metres += ray.isCastable() ? puff.metresAlong(ray, fromMetres, toMetres) : 0;
        }
        return OptionalDouble.of(extinctionPerMetre * metres);
    }
}
