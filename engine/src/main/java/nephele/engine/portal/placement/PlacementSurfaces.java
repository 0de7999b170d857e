package nephele.engine.portal.placement;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Ray;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.math.bvh.SpatialIndex;

/**
 * The fixed surfaces of a level, prepared for any number of placements: obstacles of shots, and the regions that take
 * portals. Immutable.
 */
public final class PlacementSurfaces {
    private final List<Blocker> blockers;
    private final SpatialIndex blockerIndex;
    private final int[] regionOfPatch;
    private final List<Region> regions;

    private PlacementSurfaces(List<Blocker> blockers, List<Patch> patches) {
        this.blockers = List.copyOf(blockers);
        blockerIndex = SpatialIndex.of(blockers.stream().map(Blocker::bounds).toList());
        List<Patch> portalable = new ArrayList<>();
        for (Patch patch : patches) {
            portalable.add(patch != null && patch.portalable() ? patch : null);
        }
        RegionGrowth growth = new RegionGrowth(portalable);
        regionOfPatch = growth.regionOf();
        regions = new RegionLimits(this.blockers, blockerIndex, patches).regions(growth.regions());
    }

    /** Prepares solids and models: convex models as solids, the others as sheets. */
    public static PlacementSurfaces of(StaticShapes statics) {
        List<Brush> solids = new ArrayList<>(statics.solids());
        solids.addAll(statics.models().solids());
        List<SurfacePolygon> sheets = new ArrayList<>();
        for (PlacedModel model : statics.models().sheets()) {
            for (int i = 0; i < model.triangles().count(); i++) {
                sheets.add(SurfacePolygon.of(model, i));
            }
        }
        return of(solids, sheets);
    }

    /**
     * Prepares surfaces.
     *
     * @param sheets flat pieces of meshes
     */
    public static PlacementSurfaces of(List<Brush> solids, List<SurfacePolygon> sheets) {
        List<Blocker> blockers = new ArrayList<>();
        List<Patch> patches = new ArrayList<>();
        for (Brush solid : solids) {
            blockers.add(new Blocker.Convex(solid, patches.size()));
            solid.faces().forEach(face -> patches.add(Patch.of(face.polygon(), face.portalable())));
        }
        for (SurfacePolygon sheet : sheets) {
            Patch patch = Patch.of(sheet.corners(), sheet.portalable());
            // The normal of a thinner piece may point in any direction; adjacent pieces extend across it.
            if (patch != null && patch.leastWidthMetres() > 2 * Tolerance.CRACK) {
                blockers.add(Blocker.Sheet.of(patch, patches.size()));
            }
            patches.add(patch);
        }
        return new PlacementSurfaces(blockers, patches);
    }

    /** Finds the first surface along a ray; returns false for none. */
    boolean first(Ray ray, RayHit hit) {
        return blockerIndex.nearest(
                ray,
                Double.POSITIVE_INFINITY,
                (r, item, limit) -> blockers.get(item).entry(r),
                hit);
    }

    /** Returns the region that a ray hits on a blocker; {@code null} if no portal is permitted there. */
    Region region(Ray ray, int blocker) {
        int patch = blockers.get(blocker).patch(ray);
        int region = patch < 0 ? RegionGrowth.NONE : regionOfPatch[patch];
        return region == RegionGrowth.NONE ? null : regions.get(region);
    }

    /**
     * Returns the region of a face; −1 if no portal is permitted there.
     *
     * @param face counted through all solids
     */
    int regionOfFace(int face) {
        return regionOfPatch[face];
    }

    Region region(int index) {
        return regions.get(index);
    }

    /** Returns the number of surfaces that take portals. */
    public int regions() {
        return regions.size();
    }
}
