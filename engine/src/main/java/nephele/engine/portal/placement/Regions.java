package nephele.engine.portal.placement;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import java.util.function.Predicate;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemList;
import nephele.engine.math.bvh.SpatialIndex;
import org.joml.Vector3d;

/**
 * The regions of some surfaces: portalable patches that touch and share a plane. Each region grows from its largest
 * patch; then the plane is fitted to the grown patches and the growth is repeated, so that the result does not depend
 * on the division of the surface. What bars a region are faces of its plane that are not portalable, and shapes that
 * touch it.
 */
final class Regions {
    /** Marks a patch without region. */
    static final int NONE = -1;

    private static final int MOST_FITS = 8;

    /** Depth up to which a shape only touches a face. */
    private static final double TOUCHES = 1e-7;

    private final List<SurfacePolygon> patches;
    private final SpatialIndex portalable;
    private final SpatialIndex unportalable;
    private final List<Blocker> blockers;
    private final SpatialIndex blockerIndex;
    private final int[] regionOf;
    private final int[] visit;
    private final ItemList near = new ItemList();
    private final ItemList faces = new ItemList();
    private final List<Region> regions = new ArrayList<>();
    private int visits;

    /** Finds the regions of patches; {@code blockerIndex} is the index of the blockers. */
    Regions(List<SurfacePolygon> patches, List<Blocker> blockers, SpatialIndex blockerIndex) {
        this.patches = patches;
        this.blockers = blockers;
        this.blockerIndex = blockerIndex;
        portalable = index(SurfacePolygon::portalable);
        unportalable = index(patch -> !patch.portalable());
        regionOf = new int[patches.size()];
        visit = new int[patches.size()];
        Arrays.fill(regionOf, NONE);
        List<Integer> seeds = new ArrayList<>();
        for (int i = 0; i < patches.size(); i++) {
            if (patches.get(i).isFlat() && patches.get(i).portalable()) {
                seeds.add(i);
            }
        }
        seeds.sort(Comparator.comparingDouble(i -> -patches.get(i).areaSquareMetres()));
        for (int seed : seeds) {
            if (regionOf[seed] == NONE) {
                growFrom(seed);
            }
        }
    }

    private SpatialIndex index(Predicate<SurfacePolygon> isIn) {
        return SpatialIndex.of(patches.stream()
                .map(patch -> patch.isFlat() && isIn.test(patch) ? patch.bounds() : Aabb.EMPTY)
                .toList());
    }

    List<Region> regions() {
        return regions;
    }

    /** Returns the region of each patch, or {@link #NONE}. */
    int[] regionOf() {
        return regionOf;
    }

    private void growFrom(int seed) {
        List<Integer> members = List.of(seed);
        PlaneFrame frame = planeOf(members);
        for (int i = 0; i < MOST_FITS; i++) {
            List<Integer> grown = reached(seed, frame);
            boolean same = grown.equals(members);
            members = grown;
            frame = planeOf(members);
            if (same) {
                break;
            }
        }
        for (int member : members) {
            regionOf[member] = regions.size();
        }
        regions.add(region(frame, members));
    }

    private PlaneFrame planeOf(List<Integer> members) {
        return fitted(members.stream().map(patches::get).toList());
    }

    /**
     * Returns the frame of a least-squares plane: the mean normal gives a frame, and a fit over the heights of all
     * corners in it gives the plane. Each patch is weighted by its area.
     */
    private static PlaneFrame fitted(List<SurfacePolygon> patches) {
        Vector3d normal = new Vector3d();
        Vector3d middle = new Vector3d();
        double weight = 0;
        Vec3 first = patches.get(0).corners().get(0);
        for (SurfacePolygon patch : patches) {
            double area = patch.areaSquareMetres();
            normal.fma(area, patch.normal().toVector());
            for (Vec3 corner : patch.corners()) {
                middle.fma(area / patch.corners().size(), corner.minus(first).toVector());
            }
            weight += area;
        }
        middle.div(weight);
        Vec3 centre = new Vec3(first.x() + middle.x, first.y() + middle.y, first.z() + middle.z);
        return levelled(PlaneFrame.of(centre, new Vec3(normal.x, normal.y, normal.z)), patches);
    }

    /** Uses the mean of the corners as origin, so that height = slopeX · x + slopeY · y is the best fit. */
    private static PlaneFrame levelled(PlaneFrame frame, List<SurfacePolygon> patches) {
        double xx = 0;
        double xy = 0;
        double yy = 0;
        double xh = 0;
        double yh = 0;
        for (SurfacePolygon patch : patches) {
            double weight = patch.areaSquareMetres() / patch.corners().size();
            for (Vec3 corner : patch.corners()) {
                double x = frame.x(corner);
                double y = frame.y(corner);
                double height = frame.height(corner);
                xx += weight * x * x;
                xy += weight * x * y;
                yy += weight * y * y;
                xh += weight * x * height;
                yh += weight * y * height;
            }
        }
        double determinant = xx * yy - xy * xy;
        if (!(determinant > 1e-12 * xx * yy)) {
            return frame;
        }
        double slopeX = (yy * xh - xy * yh) / determinant;
        double slopeY = (xx * yh - xy * xh) / determinant;
        Vector3d normal = frame.normal()
                .toVector()
                .fma(-slopeX, frame.axes().right().toVector())
                .fma(-slopeY, frame.axes().up().toVector());
        return PlaneFrame.of(frame.origin(), new Vec3(normal.x, normal.y, normal.z));
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
            portalable.overlapping(patches.get(current).bounds().grown(Tolerance.COPLANAR + 2 * Tolerance.CRACK), near);
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

    private static boolean joins(ConvexPolygon shape, SurfacePolygon other, PlaneFrame frame) {
        return other.liesOn(frame)
                && ConvexPolygon.gap(shape, ConvexPolygon.of(frame, other.corners())) <= 2 * Tolerance.CRACK;
    }

    private Region region(PlaneFrame frame, List<Integer> members) {
        List<ConvexPolygon> shapes = new ArrayList<>();
        Aabb bounds = Aabb.EMPTY;
        for (int patch : members) {
            shapes.add(ConvexPolygon.of(frame, patches.get(patch).corners()));
            bounds = bounds.union(patches.get(patch).bounds());
        }
        PolygonIndex all = new PolygonIndex(shapes);
        List<ConvexPolygon> bars = new ArrayList<>();
        addFacesWithoutLeave(frame, all, bounds, bars);
        addFootprints(frame, all, bounds, bars);
        return new Region(
                frame, all, new PolygonIndex(Outline.of(all)), new PolygonIndex(bars));
    }

    private void addFacesWithoutLeave(PlaneFrame frame, PolygonIndex all, Aabb bounds, List<ConvexPolygon> bars) {
        near.clear();
        unportalable.overlapping(bounds.grown(2 * Tolerance.COPLANAR), near);
        near.sort();
        for (int i = 0; i < near.size(); i++) {
            SurfacePolygon patch = patches.get(near.get(i));
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
            ConvexPolygon footprint = ConvexPolygon.footprint(frame, blocker.loops(), low, Tolerance.STANDS_AGAINST);
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
