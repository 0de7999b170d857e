package nephele.engine.scene.light;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.level.Brush;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.level.placed.WorldTriangles;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.SpatialIndex;
import nephele.engine.math.Vec3;

/**
 * Which solids can throw a shadow on another, or on a model: a ground that lies behind everything need not be in the depth
 * map. Models can always: even one alone shades itself.
 */
public final class ShadowCasters {
    private static final double TOUCH_METRES = 1e-6;

    private final List<Brush> brushes;
    private final List<PlacedModel> models;
    private final SpatialIndex index;

    private ShadowCasters(StaticShapes statics) {
        brushes = statics.solids();
        models = statics.models().all();
        List<Aabb> boxes = new ArrayList<>();
        brushes.forEach(brush -> boxes.add(brush.shape().bounds()));
        models.forEach(model -> boxes.add(model.bounds()));
        index = SpatialIndex.of(boxes);
    }

    /** The corners of all that can throw a shadow. */
    public static List<Vec3> corners(StaticShapes statics, Vec3 towardsSun) {
        List<Vec3> corners = new ArrayList<>();
        of(statics, towardsSun).forEach(brush -> corners.addAll(brush.shape().vertices()));
        for (PlacedModel model : statics.models().all()) {
            WorldTriangles mesh = model.triangles();
            for (int i = 0; i < 3 * mesh.count(); i++) {
                corners.add(mesh.corner(i / 3, i % 3));
            }
        }
        return corners;
    }

    /** Whether {@link #of} holds any: stops at the first. */
    public static boolean any(List<Brush> brushes, Vec3 towardsSun) {
        ShadowCasters search = new ShadowCasters(StaticShapes.of(brushes));
        return IntStream.range(0, brushes.size()).anyMatch(i -> !search.isBehindAllOthers(i, towardsSun));
    }

    /** Solids without those that have all others before one of their sunny faces. A convex solid never shades itself. */
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

    private boolean isAnyOtherBelow(int brush, Plane plane) {
        boolean[] found = {false};
        index.passing(
                (boxes, at) -> !found[0] && mayReachBelow(boxes, at, plane),
                other -> found[0] |= other != brush && reachesBelow(other, plane));
        return found[0];
    }

    /** Whether the box that stands in {@code boxes} from {@code at} on has a corner under the plane. */
    private static boolean mayReachBelow(double[] boxes, int at, Plane plane) {
        double x = boxes[plane.nx() > 0 ? at : at + 3];
        double y = boxes[plane.ny() > 0 ? at + 1 : at + 4];
        double z = boxes[plane.nz() > 0 ? at + 2 : at + 5];
        return plane.nx() * x + plane.ny() * y + plane.nz() * z < plane.distance();
    }

    private boolean reachesBelow(int other, Plane plane) {
        if (other >= brushes.size()) {
            return reachesBelow(models.get(other - brushes.size()).triangles(), plane);
        }
        for (Vec3 p : brushes.get(other).shape().vertices()) {
            if (plane.signedDistance(p) < -TOUCH_METRES) {
                return true;
            }
        }
        return false;
    }

    private static boolean reachesBelow(WorldTriangles mesh, Plane plane) {
        for (int i = 0; i < 3 * mesh.count(); i++) {
            if (plane.signedDistance(mesh.corner(i / 3, i % 3)) < -TOUCH_METRES) {
                return true;
            }
        }
        return false;
    }
}
