package nephele.engine.scene.light;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import nephele.engine.level.appearance.Lamp;
import nephele.engine.level.placed.PlacedModels;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Kept;
import nephele.engine.math.Vec3;

/**
 * The cells of a grid that each punctual light may reach: those within its range that are not entirely in shadow. The
 * region that a convex solid hides from a point is convex, so a box is hidden if the same solid hides its eight
 * corners. Conservative: no lit cell is omitted.
 */
final class LampCells {
    /**
     * The margin around a light's range in cell sides: one for cells that are partly within it, and the cells' overlap.
     */
    private static final double MARGIN = 1.1;

    private final LampGrid grid;
    private final List<Lamp> lamps;
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
    LampCells(LampGrid grid, List<Lamp> lamps, int[] firstLayer, StaticShapes statics, LampCells before) {
        this.grid = grid;
        this.lamps = lamps;
        this.statics = statics;
        casts = new boolean[lamps.size()];
        for (int lamp = 0; lamp < casts.length; lamp++) {
            casts[lamp] = firstLayer[lamp] >= 0;
        }
        lit = before != null && before.grid.hasSameCells(grid) ? known(before) : new BitSet[casts.length];
        find(IntStream.range(0, casts.length).filter(lamp -> lit[lamp] == null).toArray());
    }

    boolean mayLight(int lamp, int cell) {
        return lit[lamp].get(cell);
    }

    /** Returns the cells of a light; reused after an edit, never modified. */
    BitSet lit(int lamp) {
        return lit[lamp];
    }

    boolean areOf(List<Lamp> all, StaticShapes shapes) {
        return shapes == statics && all.equals(lamps);
    }

    private BitSet[] known(LampCells before) {
        Map<Lamp, Integer> places = new HashMap<>();
        for (int i = 0; i < before.casts.length; i++) {
            places.put(before.lamps.get(i), i);
        }
        List<Aabb> changed = changed(before.statics, statics);
        BitSet[] known = new BitSet[casts.length];
        for (int lamp = 0; lamp < known.length; lamp++) {
            Integer place = places.get(lamps.get(lamp));
            if (place != null && before.casts[place] == casts[lamp]) {
                Aabb region = region(lamp);
                boolean isHiddenAnew = casts[lamp] && changed.stream().anyMatch(region::overlaps);
                known[lamp] = isHiddenAnew ? null : before.lit[place];
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
        int[] places = Kept.places(before, now);
        for (int i = 0; i < places.length; i++) {
            if (places[i] == Kept.NEW) {
                add.accept(now.get(i));
            }
        }
    }

    private void find(int[] unknown) {
        if (unknown.length == 0) {
            return;
        }
        List<Aabb> regions = IntStream.of(unknown)
                .filter(lamp -> casts[lamp])
                .mapToObj(this::region)
                .toList();
        Occluders occluders = new Occluders(within(regions));
        for (int lamp : unknown) {
            lit[lamp] = new BitSet();
        }
        int found = 0;
        // Beyond this limit the remaining cells are not needed: the grid will use larger cells.
        for (int cell = 0; cell < grid.cells() && found <= LampGrid.MOST_LIT; cell++) {
            Aabb reach = grid.reachOf(cell);
            Aabb box = grid.boxOf(cell);
            for (int lamp : unknown) {
                if (LampReach.touches(lamps.get(lamp), reach) && !hides(occluders, lamp, box)) {
                    lit[lamp].set(cell);
                    found++;
                }
            }
        }
    }

    private boolean hides(Occluders occluders, int lamp, Aabb box) {
        if (!casts[lamp]) {
            return false;
        }
        Vec3 p = lamps.get(lamp).position();
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
    private Aabb region(int lamp) {
        Vec3 p = lamps.get(lamp).position();
        Aabb cells = grid.bounds();
        Vec3 nearest = new Vec3(
                Math.min(Math.max(p.x(), cells.minX()), cells.maxX()),
                Math.min(Math.max(p.y(), cells.minY()), cells.maxY()),
                Math.min(Math.max(p.z(), cells.minZ()), cells.maxZ()));
        Vec3 cell = grid.cellMetres();
        double margin = MARGIN * Math.max(cell.x(), Math.max(cell.y(), cell.z()));
        return Aabb.of(List.of(p, nearest)).grown(lamps.get(lamp).rangeMetres() + margin);
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
