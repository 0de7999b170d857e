package nephele.engine.portal.placement;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.bvh.ItemList;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.math.bvh.SpatialIndex;
import nephele.engine.math.heightfield.HeightField;

/**
 * The fixed surfaces of a level, prepared for any number of placements: obstacles of shots, and the regions that take
 * portals. Immutable.
 */
public final class PlacementSurfaces {
    private final List<Blocker> blockers;
    private final SpatialIndex blockerIndex;
    private final int[] regionOfPatch;
    private final List<Region> regions;
    private final List<StaticShape.HeightGrid> grounds;

    private PlacementSurfaces(
            List<Blocker> blockers, List<SurfacePolygon> patches, List<StaticShape.HeightGrid> grounds) {
        this.grounds = List.copyOf(grounds);
        this.blockers = List.copyOf(blockers);
        blockerIndex = SpatialIndex.of(blockers.stream().map(Blocker::bounds).toList());
        Regions found = new Regions(patches, this.blockers, blockerIndex);
        regionOfPatch = found.regionOf();
        regions = found.regions();
    }

    /**
     * Prepares solids and models: convex models as solids, the others as sheets. Terrains stop shots, and {@link
     * GroundPlacement} looks for flat parts where one hits.
     */
    public static PlacementSurfaces of(StaticShapes statics) {
        List<Brush> solids = new ArrayList<>(statics.solids());
        solids.addAll(statics.models().solids());
        List<SurfacePolygon> sheets = new ArrayList<>();
        for (PlacedModel model : statics.models().sheets()) {
            for (int i = 0; i < model.triangles().count(); i++) {
                sheets.add(SurfacePolygon.of(model, i));
            }
        }
        return of(solids, sheets, statics.ground());
    }

    /**
     * Prepares surfaces.
     *
     * @param sheets flat pieces of meshes
     */
    public static PlacementSurfaces of(List<Brush> solids, List<SurfacePolygon> sheets) {
        return of(solids, sheets, List.of());
    }

    private static PlacementSurfaces of(
            List<Brush> solids, List<SurfacePolygon> sheets, List<StaticShape.HeightGrid> grounds) {
        List<Blocker> blockers = new ArrayList<>();
        List<SurfacePolygon> patches = new ArrayList<>();
        for (Brush solid : solids) {
            blockers.add(new Blocker.Convex(solid, patches.size()));
            solid.faces().forEach(face -> patches.add(SurfacePolygon.of(face.polygon(), face.portalable())));
        }
        for (SurfacePolygon sheet : sheets) {
            // The normal of a thinner piece may point in any direction; adjacent pieces extend across it.
            if (sheet.isFlat() && sheet.leastWidthMetres() > 2 * Tolerance.CRACK) {
                blockers.add(Blocker.Sheet.of(sheet, patches.size()));
            }
            patches.add(sheet);
        }
        return new PlacementSurfaces(blockers, patches, grounds);
    }

    /** Finds the first surface along a ray, of a terrain its triangle; returns false for none. */
    boolean first(Ray ray, RayHit hit) {
        boolean isHit = firstBlocker(ray, hit);
        double nearest = isHit ? hit.distance() : Double.POSITIVE_INFINITY;
        RayHit onGround = new RayHit();
        int first = blockers.size();
        for (StaticShape.HeightGrid ground : grounds) {
            HeightField field = ground.field();
            if (field.nearest(ray, nearest, (r, triangle, limit) -> field.entry(r, triangle), onGround)
                    && onGround.distance() < nearest) {
                nearest = onGround.distance();
                hit.reset(Double.POSITIVE_INFINITY);
                hit.offer(first + onGround.item(), nearest);
                isHit = true;
            }
            first += field.triangles();
        }
        return isHit;
    }

    /** Returns the terrain that a hit is on; {@code null} if it is on another surface. */
    StaticShape.HeightGrid ground(int item) {
        int first = blockers.size();
        for (StaticShape.HeightGrid ground : grounds) {
            if (item >= first && item < first + ground.field().triangles()) {
                return ground;
            }
            first += ground.field().triangles();
        }
        return null;
    }

    /** Returns the upward component of the unit normal of what a ray hits, on the ray's side. */
    double upwards(Ray ray, int item) {
        if (item < blockers.size()) {
            return blockers.get(item).upwards(ray);
        }
        int triangle = item - blockers.size();
        for (StaticShape.HeightGrid ground : grounds) {
            if (triangle < ground.field().triangles()) {
                return ground.field().normal(triangle).y();
            }
            triangle -= ground.field().triangles();
        }
        throw new IllegalArgumentException("nothing has the number " + item);
    }

    /** Returns the number in its terrain of a triangle that was hit. */
    int triangle(int item) {
        int triangle = item - blockers.size();
        for (StaticShape.HeightGrid ground : grounds) {
            if (triangle < ground.field().triangles()) {
                return triangle;
            }
            triangle -= ground.field().triangles();
        }
        throw new IllegalArgumentException("nothing has the number " + item);
    }

    /** Returns the surfaces other than terrains with boxes that overlap a box. */
    List<Blocker> near(Aabb box) {
        ItemList found = new ItemList();
        blockerIndex.overlapping(box, found);
        found.sort();
        List<Blocker> near = new ArrayList<>(found.size());
        for (int i = 0; i < found.size(); i++) {
            near.add(blockers.get(found.get(i)));
        }
        return near;
    }

    private boolean firstBlocker(Ray ray, RayHit hit) {
        return blockerIndex.nearest(
                ray,
                Double.POSITIVE_INFINITY,
                (r, item, limit) -> blockers.get(item).entry(r),
                hit);
    }

    /** Returns the region that a ray hits on a blocker; {@code null} if no portal is permitted there. */
    Region region(Ray ray, int blocker) {
        int patch = blockers.get(blocker).patch(ray);
        int region = patch < 0 ? Regions.NONE : regionOfPatch[patch];
        return region == Regions.NONE ? null : regions.get(region);
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
