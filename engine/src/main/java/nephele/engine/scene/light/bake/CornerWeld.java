package nephele.engine.scene.light.bake;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.math.Vec3;

/** Welds corners: all corners within a micrometre of the first one get its bits. */
public final class CornerWeld {
    public static final double WELD_METRES = 1e-6;

    private static final double CELL_METRES = 1e-3;
    /** Keeps whole millimetres, which are common in levels, away from the cells' borders. */
    private static final double OFFSET_METRES = 3.7e-4;

    private final Map<Cell, List<Vec3>> corners = new HashMap<>();

    private record Cell(long x, long y, long z) {}

    Vec3 welded(Vec3 p) {
        for (long x = cell(p.x() - WELD_METRES); x <= cell(p.x() + WELD_METRES); x++) {
            for (long y = cell(p.y() - WELD_METRES); y <= cell(p.y() + WELD_METRES); y++) {
                for (long z = cell(p.z() - WELD_METRES); z <= cell(p.z() + WELD_METRES); z++) {
                    Vec3 known = knownIn(new Cell(x, y, z), p);
                    if (known != null) {
                        return known;
                    }
                }
            }
        }
        corners.computeIfAbsent(new Cell(cell(p.x()), cell(p.y()), cell(p.z())), cell -> new ArrayList<>(1))
                .add(p);
        return p;
    }

    private Vec3 knownIn(Cell cell, Vec3 p) {
        for (Vec3 known : corners.getOrDefault(cell, List.of())) {
            if (known.toVector().distance(p.x(), p.y(), p.z()) <= WELD_METRES) {
                return known;
            }
        }
        return null;
    }

    private static long cell(double metres) {
        return (long) Math.floor((metres + OFFSET_METRES) / CELL_METRES);
    }
}
