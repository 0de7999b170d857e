package nephele.engine.scene.light.bake;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import nephele.engine.level.Brush;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemRayTest;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.math.bvh.SpatialIndex;

/**
 * Intersects rays with the static geometry. Items are the level's solids, each at its index, then its convex models,
 * then the triangles of the others. Immutable and safe to share between threads.
 */
public final class Occluders {
    /** No item. */
    static final int NONE = -1;

    private final StaticShapes shapes;
    private final Occluder[] items;
    /** The item of each convex model, by its index in the level. */
    private final Map<Integer, Integer> itemOfModel = new TreeMap<>();
    /** The models by their first item, and the terrains after them by theirs. */
    private final TreeMap<Integer, StaticShape> shapeFrom = new TreeMap<>();

    private final SpatialIndex index;

    public Occluders(List<Brush> brushes) {
        this(StaticShapes.of(brushes));
    }

    public Occluders(StaticShapes shapes) {
        this.shapes = shapes;
        List<ConvexPolyhedron> convex = new ArrayList<>();
        List<StaticShape.TriangleMesh> sheets = new ArrayList<>();
        shapes.forEach(
                hull -> convex.add(hull.brush().shape()),
                mesh -> {
                    PlacedModel model = mesh.model();
                    if (model.solid() != null) {
                        itemOfModel.put(model.index(), convex.size());
                        shapeFrom.put(convex.size(), mesh);
                        convex.add(model.solid().shape());
                    } else {
                        sheets.add(mesh);
                    }
                },
                grid -> {});
        List<Occluder> all = new ArrayList<>();
        List<Aabb> boxes = new ArrayList<>();
        for (ConvexPolyhedron shape : convex) {
            all.add(new Occluder.Convex(shape.flatPlanes()));
            boxes.add(shape.bounds());
        }
        for (StaticShape.TriangleMesh sheet : sheets) {
            shapeFrom.put(all.size(), sheet);
            double[] corners = sheet.model().triangles().corners();
            for (int at = 0; at < corners.length; at += 9) {
                all.add(new Occluder.Triangle(corners, at));
                boxes.add(Aabb.of(List.of(corner(corners, at), corner(corners, at + 3), corner(corners, at + 6))));
            }
        }
        for (StaticShape.HeightGrid grid : shapes.ground()) {
            shapeFrom.put(all.size(), grid);
            all.add(new Occluder.Ground(grid.field()));
            boxes.add(grid.field().bounds());
        }
        items = all.toArray(Occluder[]::new);
        index = SpatialIndex.of(boxes);
    }

    private static Vec3 corner(double[] corners, int at) {
        return new Vec3(corners[at], corners[at + 1], corners[at + 2]);
    }

    /** Returns the item of a convex model of the level, {@link #NONE} for any other model. */
    public int itemOfModel(int model) {
        return itemOfModel.getOrDefault(model, NONE);
    }

    /** Returns true if a point is in or on a solid other than {@code except}; an open surface contains no point. */
    public boolean isInside(double[] p, int except) {
        boolean[] inside = new boolean[1];
        index.query(
                (boxes, at) -> !inside[0] && holds(boxes, at, p),
                item -> inside[0] |= item != except && items[item].contains(p));
        return inside[0];
    }

    private static boolean holds(double[] boxes, int at, double[] p) {
        return boxes[at] <= p[0]
                && p[0] <= boxes[at + 3]
                && boxes[at + 1] <= p[1]
                && p[1] <= boxes[at + 4]
                && boxes[at + 2] <= p[2]
                && p[2] <= boxes[at + 5];
    }

    /** Returns true if the ray from {@code o} along {@code d} intersects an item other than {@code except}. */
    public boolean isOccluded(double[] o, double[] d, int except) {
        return index.anyHit(
                new Ray(o[0], o[1], o[2], d[0], d[1], d[2]),
                Double.MAX_VALUE,
                (ray, item, limit) -> answer(item != except && meets(item, o, d, limit)));
    }

    int items() {
        return index.size();
    }

    /** Returns the number of boxes tested for the result of {@link #isOccluded}, which is stored in {@code hit}. */
    int boxTests(double[] o, double[] d, int except, boolean[] hit) {
        Ray ray = new Ray(o[0], o[1], o[2], d[0], d[1], d[2]);
        int[] tests = new int[1];
        index.query(
                (boxes, at) -> {
                    tests[0] += hit[0] ? 0 : 1;
                    return !hit[0] && ray.boxEntry(boxes, at, Double.MAX_VALUE) < Double.POSITIVE_INFINITY;
                },
                item -> hit[0] = hit[0] || item != except && meets(item, o, d, Double.MAX_VALUE));
        return tests[0];
    }

    /** Returns the shapes that it was made for. */
    public StaticShapes shapes() {
        return shapes;
    }

    /** Returns true for an item that is the solid with this index in the level. */
    public boolean isSolid(int item) {
        return item < shapes.solids().size();
    }

    /** Returns the model or terrain that an item belongs to, which is no solid. */
    public StaticShape shapeOf(int item) {
        return shapeFrom.floorEntry(item).getValue();
    }

    /** Returns the triangle of its model that an item is; −1 for one that is a whole shape. */
    public int triangleOf(int item) {
        return items[item] instanceof Occluder.Triangle triangle ? triangle.at() / 9 : -1;
    }

    /** Returns the face through which a ray enters a convex item that it hits; −1 from inside, and for other items. */
    public int faceOf(int item, double[] o, double[] d) {
        return items[item] instanceof Occluder.Convex convex ? convex.entryPlane(o, d) : -1;
    }

    /** Finds the first item that a ray hits; for callers that reuse their test and hit. */
    public boolean nearest(Ray ray, double limit, ItemRayTest test, RayHit hit) {
        return index.nearest(ray, limit, test, hit);
    }

    /** Returns true if the ray hits any item up to {@code limit}; for callers that reuse their test. */
    public boolean anyHit(Ray ray, double limit, ItemRayTest test) {
        return index.anyHit(ray, limit, test);
    }

    /** Returns the result of such a test for one item: the ray parameter at which it is hit. */
    public double hit(int item, double[] o, double[] d, double limit) {
        return items[item].entry(o, d, limit);
    }

    /** Returns true if a single item intersects every segment from {@code o} to {@code o + segments[i]}. */
    public boolean oneMeetsAllSegments(double[] o, double[][] segments) {
        double[] first = segments[0];
        return index.anyHit(
                new Ray(o[0], o[1], o[2], first[0], first[1], first[2]),
                1,
                (ray, item, limit) -> answer(meetsAll(item, o, segments)));
    }

    private static double answer(boolean hit) {
        return hit ? 0 : Double.POSITIVE_INFINITY;
    }

    private boolean meetsAll(int item, double[] o, double[][] segments) {
        for (double[] segment : segments) {
            if (!meets(item, o, segment, 1)) {
                return false;
            }
        }
        return true;
    }

    private boolean meets(int item, double[] o, double[] d, double length) {
        return items[item].entry(o, d, length) < Double.POSITIVE_INFINITY;
    }

    /** Tests if the ray from {@code o} along {@code d} intersects an item other than {@code except}. */
    interface Sight {
        boolean isOccluded(double[] o, double[] d, int except);
    }
}
