package nephele.engine.scene.light;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import nephele.engine.level.appearance.PunctualLight;
import nephele.engine.level.placed.PlacedModels;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.IdentityDiff;
import nephele.engine.math.Vec3;
import nephele.engine.scene.light.bake.Occluders;

/**
 * The cells of a grid that each punctual light may reach: those within its range that are not entirely in shadow. The
 * region that a convex solid hides from a point is convex, so a box is hidden if the same solid hides its eight
 * corners. Conservative: no lit cell is omitted.
 */
final class LightGridCells {
    /**
     * The margin around a light's range in cell sides: one for cells that are partly within it, and the cells' overlap.
     */
    private static final double MARGIN_CELLS = 1.1;

    private final LightGrid grid;
    private final List<PunctualLight> lights;
    private final boolean[] casts;
    private final StaticShapes statics;
    /** For each light the set of cells. */
    private final BitSet[] lit;

    /**
     * Finds the cells.
     *
     * @param grid its cells are used, not its lists
     * @param firstLayer negative for lights without shadows
     * @param before {@code null}, or the cells of a level before an edit: those of a light are reused if neither it nor
     *     anything that may hide it has changed
     */
    LightGridCells(
            LightGrid grid, List<PunctualLight> lights, int[] firstLayer, StaticShapes statics, LightGridCells before) {
        this.grid = grid;
        this.lights = lights;
        this.statics = statics;
        casts = new boolean[lights.size()];
        for (int light = 0; light < casts.length; light++) {
            casts[light] = firstLayer[light] >= 0;
        }
        lit = before != null && before.grid.hasSameCells(grid) ? known(before) : new BitSet[casts.length];
        find(IntStream.range(0, casts.length)
                .filter(light -> lit[light] == null)
                .toArray());
    }

    boolean mayLight(int light, int cell) {
        return lit[light].get(cell);
    }

    /** Returns the cells of a light; reused after an edit, never modified. */
    BitSet lit(int light) {
        return lit[light];
    }

    boolean areOf(List<PunctualLight> all, StaticShapes shapes) {
        return shapes == statics && all.equals(lights);
    }

    private BitSet[] known(LightGridCells before) {
        Map<PunctualLight, Integer> places = new HashMap<>();
        for (int i = 0; i < before.casts.length; i++) {
            places.put(before.lights.get(i), i);
        }
        List<Aabb> changed = changed(before.statics, statics);
        BitSet[] known = new BitSet[casts.length];
        for (int light = 0; light < known.length; light++) {
            Integer place = places.get(lights.get(light));
            if (place != null && before.casts[place] == casts[light]) {
                Aabb region = region(light);
                boolean isHiddenAnew = casts[light] && changed.stream().anyMatch(region::overlaps);
                known[light] = isHiddenAnew ? null : before.lit[place];
            }
        }
        return known;
    }

    /** Returns the bounds of the shapes that only one of two levels contains. */
    private static List<Aabb> changed(StaticShapes before, StaticShapes now) {
        List<Aabb> changed = new ArrayList<>();
        addNew(before.solids(), now.solids(), brush -> changed.add(brush.shape().bounds()));
        addNew(now.solids(), before.solids(), brush -> changed.add(brush.shape().bounds()));
        addNew(before.models().all(), now.models().all(), model -> changed.add(model.bounds()));
        addNew(now.models().all(), before.models().all(), model -> changed.add(model.bounds()));
        return changed;
    }

    private static <T> void addNew(List<T> before, List<T> now, Consumer<T> add) {
        int[] places = IdentityDiff.previousIndices(before, now);
        for (int i = 0; i < places.length; i++) {
            if (places[i] == IdentityDiff.NEW) {
                add.accept(now.get(i));
            }
        }
    }

    private void find(int[] unknown) {
        if (unknown.length == 0) {
            return;
        }
        List<Aabb> regions = IntStream.of(unknown)
                .filter(light -> casts[light])
                .mapToObj(this::region)
                .toList();
        Occluders occluders = new Occluders(within(regions));
        for (int light : unknown) {
            lit[light] = new BitSet();
        }
        int found = 0;
        // Beyond this limit the remaining cells are not needed: the grid will use larger cells.
        for (int cell = 0; cell < grid.cells() && found <= LightGrid.MOST_LIT; cell++) {
            Aabb reach = grid.reachOf(cell);
            Aabb box = grid.boxOf(cell);
            for (int light : unknown) {
                if (lights.get(light).touches(reach) && !hides(occluders, light, box)) {
                    lit[light].set(cell);
                    found++;
                }
            }
        }
    }

    private boolean hides(Occluders occluders, int light, Aabb box) {
        if (!casts[light]) {
            return false;
        }
        Vec3 p = lights.get(light).position();
        double[][] towards = new double[8][3];
        for (int corner = 0; corner < 8; corner++) {
            towards[corner][0] = ((corner & 1) == 0 ? box.minX() : box.maxX()) - p.x();
            towards[corner][1] = ((corner & 2) == 0 ? box.minY() : box.maxY()) - p.y();
            towards[corner][2] = ((corner & 4) == 0 ? box.minZ() : box.maxZ()) - p.z();
        }
        return occluders.oneMeetsAllSegments(new double[] {p.x(), p.y(), p.z()}, towards);
    }

    /**
     * Returns a box around everything that may be between a light and a cell within its range; the outermost cells
     * extend to any light.
     */
    private Aabb region(int light) {
        Vec3 p = lights.get(light).position();
        Aabb cells = grid.bounds();
        Vec3 nearest = new Vec3(
                Math.min(Math.max(p.x(), cells.minX()), cells.maxX()),
                Math.min(Math.max(p.y(), cells.minY()), cells.maxY()),
                Math.min(Math.max(p.z(), cells.minZ()), cells.maxZ()));
        Vec3 cell = grid.cellMetres();
        double margin = MARGIN_CELLS * Math.max(cell.x(), Math.max(cell.y(), cell.z()));
        return Aabb.of(List.of(p, nearest)).grown(lights.get(light).rangeMetres() + margin);
    }

    private StaticShapes within(List<Aabb> regions) {
        return new StaticShapes(
                statics.solids().stream()
                        .filter(solid -> isIn(solid.shape().bounds(), regions))
                        .toList(),
                new PlacedModels(statics.models().all().stream()
                        .filter(model -> isIn(model.bounds(), regions))
                        .toList()),
                List.of());
    }

    private static boolean isIn(Aabb box, List<Aabb> regions) {
        return regions.stream().anyMatch(box::overlaps);
    }
}
