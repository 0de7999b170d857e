package nephele.engine.portal.placement;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.bvh.ItemList;
import nephele.engine.math.bvh.SpatialIndex;

/**
 * Groups portalable patches that touch and share a plane. Each region grows from its largest patch; then the plane is
 * fitted to the grown patches and the growth is repeated, so that the result does not depend on the division of the
 * surface.
 */
final class RegionGrowth {
    /** Marks a patch without region. */
    static final int NONE = -1;

    private static final int MOST_FITS = 8;

    /** Patches in one plane that touch. */
    record Grown(PlaneFrame frame, List<Integer> patches) {}

    private final List<Patch> patches;
    private final SpatialIndex index;
    private final int[] regionOf;
    private final int[] visit;
    private final ItemList near = new ItemList();
    private final List<Grown> regions = new ArrayList<>();
    private int visits;

    /** @param patches {@code null} for entries without patch */
    RegionGrowth(List<Patch> patches) {
        this.patches = patches;
        index = SpatialIndex.of(patches.stream()
                .map(patch -> patch == null ? Aabb.EMPTY : patch.bounds())
                .toList());
        regionOf = new int[patches.size()];
        visit = new int[patches.size()];
        Arrays.fill(regionOf, NONE);
        List<Integer> seeds = new ArrayList<>();
        for (int i = 0; i < patches.size(); i++) {
            if (patches.get(i) != null) {
                seeds.add(i);
            }
        }
        seeds.sort(Comparator.comparingDouble(i -> -patches.get(i).areaSquareMetres()));
        seeds.forEach(this::growFrom);
    }

    List<Grown> regions() {
        return regions;
    }

    /** Returns the region of each patch, or {@link #NONE}. */
    int[] regionOf() {
        return regionOf;
    }

    private void growFrom(int seed) {
        if (regionOf[seed] != NONE) {
            return;
        }
        List<Integer> members = List.of(seed);
        PlaneFrame frame = fitted(members);
        for (int i = 0; i < MOST_FITS; i++) {
            List<Integer> grown = reached(seed, frame);
            boolean same = grown.equals(members);
            members = grown;
            frame = fitted(members);
            if (same) {
                break;
            }
        }
        for (int member : members) {
            regionOf[member] = regions.size();
        }
        regions.add(new Grown(frame, members));
    }

    private PlaneFrame fitted(List<Integer> members) {
        return FittedPlane.of(members.stream().map(patches::get).toList());
    }

    /** Returns the patches reached, in ascending order; always includes the seed. */
    private List<Integer> reached(int seed, PlaneFrame frame) {
        visits++;
        visit[seed] = visits;
        List<Integer> found = new ArrayList<>(List.of(seed));
        Deque<Integer> open = new ArrayDeque<>(found);
        while (!open.isEmpty()) {
            int current = open.remove();
            ConvexPolygon shape = ConvexPolygon.of(frame, patches.get(current).corners());
            near.clear();
            index.overlapping(patches.get(current).bounds().grown(Tolerance.COPLANAR + 2 * Tolerance.CRACK), near);
            for (int i = 0; i < near.size(); i++) {
                int other = near.get(i);
                if (regionOf[other] == NONE && visit[other] != visits && joins(shape, patches.get(other), frame)) {
                    visit[other] = visits;
                    found.add(other);
                    open.add(other);
                }
            }
        }
        found.sort(null);
        return found;
    }

    private static boolean joins(ConvexPolygon shape, Patch other, PlaneFrame frame) {
        return other.liesOn(frame)
                && ConvexPolygon.gap(shape, ConvexPolygon.of(frame, other.corners())) <= 2 * Tolerance.CRACK;
    }
}
