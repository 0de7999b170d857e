package nephele.engine.portal.placement;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.bvh.ItemList;
import nephele.engine.math.bvh.SpatialIndex;

/**
 * Finds the limits of the regions: outlines, faces of the same plane that are not portalable, and shapes that touch
 * them.
 */
final class RegionLimits {
    /** Depth up to which a shape only touches a face. */
    private static final double TOUCHES = 1e-7;

    private final List<Blocker> blockers;
    private final SpatialIndex blockerIndex;
    private final List<Patch> patches;
    private final SpatialIndex barredIndex;
    private final ItemList near = new ItemList();
    private final ItemList faces = new ItemList();

    RegionLimits(List<Blocker> blockers, SpatialIndex blockerIndex, List<Patch> patches) {
        this.blockers = blockers;
        this.blockerIndex = blockerIndex;
        this.patches = patches;
        barredIndex = SpatialIndex.of(patches.stream()
                .map(patch -> patch == null || patch.portalable() ? Aabb.EMPTY : patch.bounds())
                .toList());
    }

    List<Region> regions(List<RegionGrowth.Grown> grown) {
        List<Region> regions = new ArrayList<>(grown.size());
        for (RegionGrowth.Grown of : grown) {
            regions.add(region(of));
        }
        return regions;
    }

    private Region region(RegionGrowth.Grown grown) {
        PlaneFrame frame = grown.frame();
        List<ConvexPolygon> shapes = new ArrayList<>();
        Aabb bounds = Aabb.EMPTY;
        for (int patch : grown.patches()) {
            shapes.add(ConvexPolygon.of(frame, patches.get(patch).corners()));
            bounds = bounds.union(patches.get(patch).bounds());
        }
        PolygonIndex all = new PolygonIndex(shapes);
        List<ConvexPolygon> bars = new ArrayList<>();
        addFacesWithoutLeave(frame, all, bounds, bars);
        addFootprints(frame, all, bounds, bars);
        return new Region(
                frame, all, new PolygonIndex(OutlineSimplification.of(Outline.of(all))), new PolygonIndex(bars));
    }

    private void addFacesWithoutLeave(PlaneFrame frame, PolygonIndex all, Aabb bounds, List<ConvexPolygon> bars) {
        near.clear();
        barredIndex.overlapping(bounds.grown(2 * Tolerance.COPLANAR), near);
        near.sort();
        for (int i = 0; i < near.size(); i++) {
            Patch patch = patches.get(near.get(i));
            if (patch.liesOn(frame)) {
                addWhereItLiesIn(all, ConvexPolygon.of(frame, patch.corners()), bars);
            }
        }
    }

    private void addFootprints(PlaneFrame frame, PolygonIndex all, Aabb bounds, List<ConvexPolygon> bars) {
        near.clear();
        blockerIndex.overlapping(bounds.grown(Tolerance.STANDS_AGAINST), near);
        near.sort();
        double low = Tolerance.coplanar(greatest(bounds));
        for (int i = 0; i < near.size(); i++) {
            Blocker blocker = blockers.get(near.get(i));
            ConvexPolygon footprint = Footprints.of(frame, blocker.loops(), low, Tolerance.STANDS_AGAINST);
            if (footprint != null) {
                addWhereItLiesIn(all, footprint, bars);
            }
        }
    }

    private static double greatest(Aabb box) {
        double most = Math.max(Math.abs(box.minX()), Math.abs(box.maxX()));
        most = Math.max(most, Math.max(Math.abs(box.minY()), Math.abs(box.maxY())));
        return Math.max(most, Math.max(Math.abs(box.minZ()), Math.abs(box.maxZ())));
    }

    private void addWhereItLiesIn(PolygonIndex all, ConvexPolygon bar, List<ConvexPolygon> bars) {
        faces.clear();
        all.overlapping(bar.bounds(), faces);
        for (int i = 0; i < faces.size(); i++) {
            if (ConvexPolygon.gap(bar, all.shape(faces.get(i))) < -TOUCHES) {
                bars.add(bar);
                return;
            }
        }
    }
}
