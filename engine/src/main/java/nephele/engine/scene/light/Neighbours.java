package nephele.engine.scene.light;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.ItemList;
import nephele.engine.math.SpatialIndex;

/**
 * Which boxes touch which. Their number is bounded: where thousands of boxes overlap each other, those with the most
 * neighbours are taken as standing alone.
 */
final class Neighbours {
    /** Limit for all boxes together: a second's work for those that ask for them. */
    private static final int MOST_PAIRS = 300_000;

    private final List<Aabb> boxes;
    private final SpatialIndex index;
    private final double reachMetres;
    private final int mostOfOne;
    private final ItemList found = new ItemList();

    private Neighbours(List<Aabb> boxes, SpatialIndex index, double reachMetres, int mostOfOne) {
        this.boxes = boxes;
        this.index = index;
        this.reachMetres = reachMetres;
        this.mostOfOne = mostOfOne;
    }

    /** @param reachMetres boxes with a wider gap between them are no neighbours */
    static Neighbours of(List<Aabb> boxes, double reachMetres) {
        SpatialIndex index = SpatialIndex.of(boxes);
        var all = new Neighbours(boxes, index, reachMetres, MOST_PAIRS);
        return all.areFew() ? all : new Neighbours(boxes, index, reachMetres, MOST_PAIRS / boxes.size());
    }

    private boolean areFew() {
        int pairs = 0;
        for (int box = 0; box < boxes.size() && pairs <= MOST_PAIRS; box++) {
            find(box, MOST_PAIRS);
            pairs += found.size() - 1;
        }
        return pairs <= MOST_PAIRS;
    }

    /** In ascending order; none for a box that has more than its share of a crowd. */
    List<Integer> of(int box) {
        find(box, mostOfOne);
        List<Integer> neighbours = new ArrayList<>();
        if (found.size() - 1 <= mostOfOne) {
            found.sort();
            for (int i = 0; i < found.size(); i++) {
                if (found.get(i) != box) {
                    neighbours.add(found.get(i));
                }
            }
        }
        return neighbours;
    }

    /** The box itself is among them; ends when there are more than {@code most} others. */
    private void find(int box, int most) {
        Aabb around = boxes.get(box).grown(reachMetres);
        found.clear();
        index.passing((bounds, at) -> found.size() <= most + 1 && around.overlaps(bounds, at), found);
    }
}
