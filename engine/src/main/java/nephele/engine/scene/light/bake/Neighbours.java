package nephele.engine.scene.light.bake;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.math.Aabb;
import nephele.engine.math.bvh.ItemList;
import nephele.engine.math.bvh.SpatialIndex;

/**
 * The pairs of boxes that touch. Their number is bounded: if thousands of boxes overlap each other, those with the most
 * neighbours are treated as having none.
 */
final class Neighbours {
    /** The limit for all boxes together: about a second's work for the users of the pairs. */
    private static final int MOST_PAIRS = 300_000;

    /** More new boxes than these are found with a spatial index. */
    private static final int MOST_SCANNED = 32;

    private static final int[] NONE = {};

    private final List<Aabb> boxes;
    private final double reachMetres;
    private final int[][] near;
    private final boolean isCrowded;
    private int pairs;

    private Neighbours(List<Aabb> boxes, double reachMetres, boolean isCrowded) {
        this.boxes = boxes;
        this.reachMetres = reachMetres;
        this.isCrowded = isCrowded;
        near = new int[boxes.size()][];
        Arrays.fill(near, NONE);
    }

    /**
     * Finds the pairs.
     *
     * @param reachMetres boxes with a wider gap between them are no neighbours
     */
    static Neighbours of(List<Aabb> boxes, double reachMetres) {
        SpatialIndex index = SpatialIndex.of(boxes);
        Neighbours all = new Neighbours(boxes, reachMetres, false);
        all.find(index, MOST_PAIRS);
        if (all.pairs > MOST_PAIRS) {
            all = new Neighbours(boxes, reachMetres, true);
            all.find(index, MOST_PAIRS / boxes.size());
        }
        return all;
    }

    /** Finds all pairs. Boxes with more neighbours than {@code mostOfOne} get none; stops early above the limit. */
    private void find(SpatialIndex index, int mostOfOne) {
        ItemList found = new ItemList();
        for (int box = 0; box < near.length && (isCrowded || pairs <= MOST_PAIRS); box++) {
            Aabb around = boxes.get(box).grown(reachMetres);
            found.clear();
            index.query((bounds, at) -> found.size() <= mostOfOne + 1 && around.overlaps(bounds, at), found);
            pairs += found.size() - 1;
            if (found.size() - 1 <= mostOfOne) {
                near[box] = others(box, found);
            }
        }
    }

    /** Removes the box itself from those found. */
    private static int[] others(int box, ItemList found) {
        found.sort();
        int[] others = new int[found.size() - 1];
        int count = 0;
        for (int i = 0; i < found.size(); i++) {
            if (found.get(i) != box) {
                others[count++] = found.get(i);
            }
        }
        return others;
    }

    /**
     * Returns the result of {@link #of} for edited boxes.
     *
     * @param before for each box its number among these, −1 for a new one; ascending except for new ones
     */
    Neighbours edited(List<Aabb> edited, int[] before) {
        int[] added =
                IntStream.range(0, before.length).filter(i -> before[i] < 0).toArray();
        if (isCrowded || added.length > MOST_SCANNED) {
            return of(edited, reachMetres);
        }
        Neighbours result = new Neighbours(edited, reachMetres, false);
        int[] now = new int[boxes.size()];
        Arrays.fill(now, -1);
        for (int box = 0; box < before.length; box++) {
            if (before[box] >= 0) {
                now[before[box]] = box;
            }
        }
        ItemList found = new ItemList();
        for (int box = 0; box < before.length; box++) {
            found.clear();
            found.accept(box);
            if (before[box] < 0) {
                result.scan(box, IntStream.range(0, before.length).toArray(), found);
            } else {
                for (int other : near[before[box]]) {
                    if (now[other] >= 0) {
                        found.accept(now[other]);
                    }
                }
                result.scan(box, added, found);
            }
            result.near[box] = others(box, found);
            result.pairs += found.size() - 1;
        }
        return result.pairs <= MOST_PAIRS ? result : of(edited, reachMetres);
    }

    private void scan(int box, int[] candidates, ItemList found) {
        Aabb around = boxes.get(box).grown(reachMetres);
        for (int other : candidates) {
            if (other != box && around.overlaps(boxes.get(other))) {
                found.accept(other);
            }
        }
    }

    /** Returns the neighbours in ascending order; none for a box that exceeds its share of the limit. */
    int[] of(int box) {
        return near[box];
    }
}
