package nephele.engine.scene.light;

import java.util.ArrayList;
import java.util.Arrays;
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
 * Lists the punctual lights that can light the faces in each cell of a regular grid over the level, so that a pixel
 * evaluates few of a thousand lights. Lists are complete: if many lights have a long range the cells grow, and only
 * lights behind the face or hidden from the whole cell are omitted. Points outside the grid belong to its outermost
 * cells.
 *
 * <p>A light is hidden from a cell by a single solid: the region that a convex solid hides from a point is convex, so a
 * box is hidden if the same solid hides its eight corners. No lit cell is omitted.
 */
public final class LightGrid {
    /** One list for faces towards each of +x −x +y −y +z −z, and one for all others. */
    public static final int FACINGS = 7;

    private static final int MAX_CELLS = 1 << 13;
    private static final int MAX_ENTRIES = 1 << 17;

    /**
     * The greatest number of pairs of a light and a cell: each pair takes at least four entries, so more cannot fit.
     */
    private static final int MOST_LIT = MAX_ENTRIES / 4;

    private static final double FINEST_CELL_METRES = 1;

    /** In cell sides: float coordinates in the shader may fall into the neighbouring cell. */
    private static final double OVERLAP_CELLS = 1e-3;

    /**
     * The margin around a light's range in cell sides: one for cells that are partly within it, and the cells' overlap.
     */
    private static final double MARGIN_CELLS = 1.1;

    private final Vec3 min;
    private final Vec3 cellMetres;
    private final int columns;
    private final int floors;
    private final int rows;

    private final List<PunctualLight> sources;
    private final boolean[] casts;
    private final StaticShapes statics;
    /** For each light the set of cells that it may reach; reused after an edit, never modified. */
    private final BitSet[] lit;

    private int[] firstOfList;
    private int[] lights;

    /**
     * Makes the grid of some lights, with the smallest cells whose lists are not too long.
     *
     * @param firstLayer negative for lights without shadows
     * @param box around the surfaces to light
     * @param before {@code null}, or the grid of a level before an edit: the cells of a light are reused if neither it
     *     nor anything that may hide it has changed
     */
    static LightGrid of(
            List<PunctualLight> lights, int[] firstLayer, Aabb box, StaticShapes statics, LightGrid before) {
        for (double side = finestMetres(box); ; side *= 2) {
            LightGrid grid = new LightGrid(lights, firstLayer, box, side, statics, before);
            if (grid.list()) {
                return grid;
            }
        }
    }

    private LightGrid(
            List<PunctualLight> lights,
            int[] firstLayer,
            Aabb box,
            double side,
            StaticShapes statics,
            LightGrid before) {
        columns = (int) cells(box.maxX() - box.minX(), side);
        floors = (int) cells(box.maxY() - box.minY(), side);
        rows = (int) cells(box.maxZ() - box.minZ(), side);
        min = new Vec3(box.minX(), box.minY(), box.minZ());
        cellMetres = new Vec3(
                cellSide(box.maxX() - box.minX(), columns),
                cellSide(box.maxY() - box.minY(), floors),
                cellSide(box.maxZ() - box.minZ(), rows));
        sources = lights;
        this.statics = statics;
        casts = new boolean[lights.size()];
        for (int light = 0; light < casts.length; light++) {
            casts[light] = firstLayer[light] >= 0;
        }
        lit = before != null && before.hasSameCells(this) ? known(before) : new BitSet[casts.length];
        find(IntStream.range(0, casts.length)
                .filter(light -> lit[light] == null)
                .toArray());
    }

    /** Returns the side of the smallest cells that are allowed for the level's size, metres. */
    private static double finestMetres(Aabb bounds) {
        double side = FINEST_CELL_METRES;
        while (cells(bounds.maxX() - bounds.minX(), side)
                        * cells(bounds.maxY() - bounds.minY(), side)
                        * cells(bounds.maxZ() - bounds.minZ(), side)
                > MAX_CELLS) {
            side *= 1.25;
        }
        return side;
    }

    private static double cells(double extent, double side) {
        return Math.max(1, Math.ceil(extent / side));
    }

    private static double cellSide(double extent, int cells) {
        return Math.max(extent, 1e-3) / cells;
    }

    private boolean hasSameCells(LightGrid other) {
        return min.equals(other.min)
                && cellMetres.equals(other.cellMetres)
                && columns == other.columns
                && floors == other.floors
                && rows == other.rows;
    }

    private int cells() {
        return columns * floors * rows;
    }

    private Aabb bounds() {
        return new Aabb(
                min.x(),
                min.y(),
                min.z(),
                min.x() + columns * cellMetres.x(),
                min.y() + floors * cellMetres.y(),
                min.z() + rows * cellMetres.z());
    }

    /** Returns the grid's corner, world metres. */
    public Vec3 min() {
        return min;
    }

    /** Returns the sides of a cell. */
    public Vec3 cellMetres() {
        return cellMetres;
    }

    /** Returns the number of cells along x; {@link #floors} along y and {@link #rows} along z. */
    public int columns() {
        return columns;
    }

    public int floors() {
        return floors;
    }

    public int rows() {
        return rows;
    }

    /**
     * Returns the start of each list in {@link #lights}, and one entry more; {@value #FACINGS} lists per cell, cells with
     * x varying fastest.
     */
    public int[] firstOfList() {
        return firstOfList;
    }

    /** Returns indices into the list of lights, ascending within a list. */
    public int[] lights() {
        return lights;
    }

    /** Returns true if it is the grid of these lights among these shapes. */
    boolean isOf(List<PunctualLight> all, StaticShapes shapes) {
        return shapes == statics && all.equals(sources);
    }

    /** Returns the cells of a light: the same object after an edit while nothing that may hide the light has changed. */
    BitSet lit(int light) {
        return lit[light];
    }

    /**
     * Makes the lists of all cells.
     *
     * @return false if the lists are too long and the cells can be larger
     */
    private boolean list() {
        int most = cells() == 1 ? Integer.MAX_VALUE : MAX_ENTRIES;
        int[] first = new int[FACINGS * cells() + 1];
        int[] entries = new int[64];
        int[] near = new int[sources.size()];
        int count = 0;
        for (int cell = 0; cell < cells(); cell++) {
            int nearCount = near(cell, near);
            Aabb box = nearCount == 0 ? Aabb.EMPTY : reachOf(cell);
            for (int facing = 0; facing < FACINGS; facing++) {
                first[FACINGS * cell + facing] = count;
                entries = count + nearCount > entries.length ? Arrays.copyOf(entries, 2 * count + nearCount) : entries;
                for (int i = 0; i < nearCount; i++) {
                    if (isBefore(facing, box, sources.get(near[i]).position())) {
                        entries[count++] = near[i];
                    }
                }
            }
            if (count > most) {
                return false;
            }
        }
        first[first.length - 1] = count;
        firstOfList = first;
        lights = Arrays.copyOf(entries, count);
        return true;
    }

    private int near(int cell, int[] near) {
        int count = 0;
        for (int light = 0; light < near.length; light++) {
            if (lit[light].get(cell)) {
                near[count++] = light;
            }
        }
        return count;
    }

    /** Returns true if a light can be in front of a face in the box with the given facing. */
    private static boolean isBefore(int facing, Aabb box, Vec3 light) {
        return switch (facing) {
            case 0 -> light.x() > box.minX();
            case 1 -> light.x() < box.maxX();
            case 2 -> light.y() > box.minY();
            case 3 -> light.y() < box.maxY();
            case 4 -> light.z() > box.minZ();
            case 5 -> light.z() < box.maxZ();
            default -> true;
        };
    }

    private Aabb boxOf(int cell) {
        int x = cell % columns;
        int y = cell / columns % floors;
        int z = cell / columns / floors;
        Vec3 c = cellMetres;
        return new Aabb(
                        min.x() + x * c.x(),
                        min.y() + y * c.y(),
                        min.z() + z * c.z(),
                        min.x() + (x + 1) * c.x(),
                        min.y() + (y + 1) * c.y(),
                        min.z() + (z + 1) * c.z())
                .grown(OVERLAP_CELLS * Math.max(c.x(), Math.max(c.y(), c.z())));
    }

    /** Returns the cell's box, slightly grown; unbounded on the grid's outside. */
    private Aabb reachOf(int cell) {
        int x = cell % columns;
        int y = cell / columns % floors;
        int z = cell / columns / floors;
        return new Aabb(
                low(min.x(), cellMetres.x(), x),
                low(min.y(), cellMetres.y(), y),
                low(min.z(), cellMetres.z(), z),
                high(min.x(), cellMetres.x(), x, columns),
                high(min.y(), cellMetres.y(), y, floors),
                high(min.z(), cellMetres.z(), z, rows));
    }

    private static double low(double min, double side, int index) {
        return index == 0 ? -1e12 : min + (index - OVERLAP_CELLS) * side;
    }

    private static double high(double min, double side, int index, int count) {
        return index == count - 1 ? 1e12 : min + (index + 1 + OVERLAP_CELLS) * side;
    }

    private BitSet[] known(LightGrid before) {
        Map<PunctualLight, Integer> places = new HashMap<>();
        for (int i = 0; i < before.casts.length; i++) {
            places.put(before.sources.get(i), i);
        }
        List<Aabb> changed = changed(before.statics, statics);
        BitSet[] known = new BitSet[casts.length];
        for (int light = 0; light < known.length; light++) {
            Integer place = places.get(sources.get(light));
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
        for (int cell = 0; cell < cells() && found <= MOST_LIT; cell++) {
            Aabb reach = reachOf(cell);
            Aabb box = boxOf(cell);
            for (int light : unknown) {
                if (sources.get(light).touches(reach) && !hides(occluders, light, box)) {
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
        Vec3 p = sources.get(light).position();
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
        Vec3 p = sources.get(light).position();
        Aabb cells = bounds();
        Vec3 nearest = new Vec3(
                Math.min(Math.max(p.x(), cells.minX()), cells.maxX()),
                Math.min(Math.max(p.y(), cells.minY()), cells.maxY()),
                Math.min(Math.max(p.z(), cells.minZ()), cells.maxZ()));
        double margin = MARGIN_CELLS * Math.max(cellMetres.x(), Math.max(cellMetres.y(), cellMetres.z()));
        return Aabb.of(List.of(p, nearest)).grown(sources.get(light).rangeMetres() + margin);
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
