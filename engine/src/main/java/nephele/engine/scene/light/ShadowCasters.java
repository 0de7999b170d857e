package nephele.engine.scene.light;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import nephele.engine.level.Brush;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.level.placed.WorldTriangles;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.SpatialIndex;
import nephele.engine.math.heightfield.HeightField;

/**
 * The solids that can cast a shadow on another shape; a ground that is behind everything need not be in the depth map.
 * Models and terrains always can, because even a single one shades itself.
 */
public final class ShadowCasters {
    private static final double TOUCH_METRES = 1e-6;

    /** Parts of a terrain along a side whose boxes bound its shadows. */
    private static final int GROUND_BLOCKS = 32;

    private final List<Brush> brushes;
    private final List<StaticShape> shapes;
    /** The two outermost shapes in each direction of an axis: one of them is below most planes. */
    private final int[] outermost;
    /** Made when none of those is below a plane. */
    private SpatialIndex index;

    private ShadowCasters(StaticShapes statics) {
        brushes = statics.solids();
        shapes = statics.all();
        outermost = outermost();
    }

    private int[] outermost() {
        double[] farthest = new double[12];
        int[] found = new int[12];
        Arrays.fill(farthest, Double.NEGATIVE_INFINITY);
        for (int shape = 0; shape < shapes.size(); shape++) {
            Aabb box = shapes.get(shape).bounds();
            double[] reach = {-box.minY(), box.maxY(), -box.minX(), box.maxX(), -box.minZ(), box.maxZ()};
            for (int side = 0; side < 6; side++) {
                int at = 2 * side;
                if (reach[side] > farthest[at]) {
                    farthest[at + 1] = farthest[at];
                    found[at + 1] = found[at];
                }
                int place = reach[side] > farthest[at] ? at : at + 1;
                if (reach[side] > farthest[place]) {
                    farthest[place] = reach[side];
                    found[place] = shape;
                }
            }
        }
        return found;
    }

    /** Returns the corners of everything that can cast a shadow. */
    public static List<Vec3> corners(StaticShapes statics, Vec3 towardsSun) {
        List<Vec3> corners = new ArrayList<>();
        of(statics, towardsSun).forEach(brush -> corners.addAll(brush.shape().vertices()));
        for (PlacedModel model : statics.models().all()) {
            WorldTriangles mesh = model.triangles();
            for (int i = 0; i < 3 * mesh.count(); i++) {
                corners.add(mesh.corner(i / 3, i % 3));
            }
        }
        for (StaticShape.HeightGrid grid : statics.ground()) {
            addBlocks(grid.field(), corners);
        }
        return corners;
    }

    /** Adds the corners of boxes around parts of a terrain. */
    private static void addBlocks(HeightField field, List<Vec3> corners) {
        int level = field.blockLevel(Math.max(field.cellColumns(), field.cellRows()) / GROUND_BLOCKS);
        double[] box = new double[6];
        for (int row = 0; row < field.blockRows(level); row++) {
            for (int column = 0; column < field.blockColumns(level); column++) {
                field.writeBlock(level, column, row, box);
                for (int corner = 0; corner < 8; corner++) {
                    corners.add(new Vec3(
                            box[(corner & 1) * 3], box[1 + (corner >> 1 & 1) * 3], box[2 + (corner >> 2) * 3]));
                }
            }
        }
    }

    /** Returns true if {@link #of} is not empty; stops at the first caster. */
    public static boolean any(List<Brush> brushes, Vec3 towardsSun) {
        ShadowCasters search = new ShadowCasters(StaticShapes.of(brushes));
        return IntStream.range(0, brushes.size()).anyMatch(i -> !search.isBehindAllOthers(i, towardsSun));
    }

    /** Returns all solids except those with all others in front of one of their sunlit faces. */
    public static List<Brush> of(List<Brush> brushes, Vec3 towardsSun) {
        return of(StaticShapes.of(brushes), towardsSun);
    }

    private static List<Brush> of(StaticShapes statics, Vec3 towardsSun) {
        List<Brush> casters = new ArrayList<>();
        ShadowCasters search = new ShadowCasters(statics);
        for (int i = 0; i < statics.solids().size(); i++) {
            if (!search.isBehindAllOthers(i, towardsSun)) {
                casters.add(statics.solids().get(i));
            }
        }
        return casters;
    }

    private boolean isBehindAllOthers(int brush, Vec3 towardsSun) {
        for (ConvexPolyhedron.Face face : brushes.get(brush).shape().faces()) {
            Plane plane = face.plane();
            boolean isSunny =
                    plane.nx() * towardsSun.x() + plane.ny() * towardsSun.y() + plane.nz() * towardsSun.z() > 0;
            if (isSunny && !isAnyOtherBelow(brush, plane)) {
                return true;
            }
        }
        return false;
    }

    private boolean isAnyOtherBelow(int solid, Plane plane) {
        for (int item : outermost) {
            if (isOtherBelow(item, solid, plane)) {
                return true;
            }
        }
        if (index == null) {
            index = SpatialIndex.of(shapes.stream().map(StaticShape::bounds).toList());
        }
        boolean[] isFound = new boolean[1];
        index.query(
                (boxes, at) -> !isFound[0] && mayReachBelow(boxes, at, plane),
                other -> isFound[0] = isFound[0] || isOtherBelow(other, solid, plane));
        return isFound[0];
    }

    /** Returns true if a shape other than a solid has a point below a plane. */
    private boolean isOtherBelow(int shape, int solid, Plane plane) {
        boolean[] isFound = new boolean[1];
        Predicate<Vec3> isBelow = p -> plane.signedDistance(p) < -TOUCH_METRES;
        shapes.get(shape)
                .select(
                        hull -> isFound[0] = hull.index() != solid
                                && hull.brush().shape().vertices().stream().anyMatch(isBelow),
                        mesh -> {
                            WorldTriangles triangles = mesh.model().triangles();
                            isFound[0] = IntStream.range(0, 3 * triangles.count())
                                    .mapToObj(i -> triangles.corner(i / 3, i % 3))
                                    .anyMatch(isBelow);
                        },
                        grid -> isFound[0] = IntStream.range(0, 8)
                                .mapToObj(grid.bounds()::corner)
                                .anyMatch(isBelow));
        return isFound[0];
    }

    /** Returns true if the box at {@code at} in {@code boxes} has a corner below the plane. */
    private static boolean mayReachBelow(double[] boxes, int at, Plane plane) {
        double x = boxes[plane.nx() > 0 ? at : at + 3];
        double y = boxes[plane.ny() > 0 ? at + 1 : at + 4];
        double z = boxes[plane.nz() > 0 ? at + 2 : at + 5];
        return plane.nx() * x + plane.ny() * y + plane.nz() * z < plane.distance();
    }
}
