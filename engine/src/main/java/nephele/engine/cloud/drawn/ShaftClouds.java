package nephele.engine.cloud.drawn;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import nephele.engine.cloud.cells.LayerGrid;
import nephele.engine.cloud.cells.SlantedShade;
import nephele.engine.level.Environment;
import nephele.engine.level.appearance.ShaftLight;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/**
 * The clouds that cast shadows into the air, and the lattice of their shade, which drifts with the first of them.
 *
 * @param indices of the clouds among all
 */
public record ShaftClouds(List<CloudSource> sources, List<Integer> indices, LayerGrid grid) {
    private static final double MOST_CELL_METRES = 62.5;
    /** Cells across the narrowest of the clouds. */
    private static final int CELLS = 24;

    private static final double ROW_METRES = 150;
    private static final int FEWEST_ROWS = 6;
    private static final int MOST_ROWS = 16;

    /** Boxes of the lattice. */
    public static final int LEVELS = 4;

    /** Returns those of an environment; empty if none of its clouds has shafts, or its sky no air. */
    static Optional<ShaftClouds> of(Environment environment, List<CloudSource> sources) {
        List<Integer> indices = IntStream.range(0, sources.size())
                .filter(i -> sources.get(i).cloud().shafts())
                .boxed()
                .toList();
        return ShaftLight.isIn(environment) && !indices.isEmpty()
                ? Optional.of(new ShaftClouds(List.copyOf(sources), indices, grid(sources, indices)))
                : Optional.empty();
    }

    private static LayerGrid grid(List<CloudSource> sources, List<Integer> indices) {
        double base = Double.POSITIVE_INFINITY;
        double top = Double.NEGATIVE_INFINITY;
        double cell = MOST_CELL_METRES;
        for (int i : indices) {
            Aabb bounds = sources.get(i).bounds();
            base = Math.min(base, bounds.minY());
            top = Math.max(top, bounds.maxY());
            double width = Math.min(bounds.maxX() - bounds.minX(), bounds.maxZ() - bounds.minZ());
            cell = Math.min(cell, width / CELLS);
        }
        int rows = (int) Math.max(FEWEST_ROWS, Math.min(MOST_ROWS, Math.round((top - base) / ROW_METRES)));
        return SlantedShade.grid(base, top, cell, rows, LEVELS);
    }

    /** Returns half the second derivative of a level ray's height over the clouds' base, per metre. */
    public double halfCurvature() {
        return indices.stream()
                .mapToDouble(i -> sources.get(i).halfCurvature())
                .max()
                .orElse(0);
    }

    /** Returns how far the lattice has drifted. */
    public Vec3 drift(double seconds) {
        return sources.get(indices.get(0)).drift(seconds);
    }

    /** Returns the place of the lattice where a light's ray to a place of the world crosses the base of the clouds. */
    public Vec3 foot(Vec3 place, double seconds, Vec3 towardsLight) {
        Vec3 drift = drift(seconds);
        double over = place.y() - drift.y() - grid.baseMetres();
        return place.minus(drift).addScaled(-over, SlantedShade.slant(towardsLight));
    }

    /** Computes the shade at a time. */
    SlantedShade shade(List<LayerGrid.Column> columns, double seconds, Vec3 towardsLight) {
        Vec3 drift = drift(seconds);
        List<SlantedShade.Caster> casters = indices.stream()
                .map(sources::get)
                .map(cloud -> new SlantedShade.Caster(
                        cloud.flat(seconds), drift.minus(cloud.drift(seconds)), cloud.presence(seconds)))
                .toList();
        return SlantedShade.of(grid, columns, casters, towardsLight);
    }
}
