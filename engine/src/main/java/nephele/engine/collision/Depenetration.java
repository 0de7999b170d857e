package nephele.engine.collision;

import java.util.Arrays;
import nephele.engine.math.Aabb;
import nephele.engine.math.bvh.ItemList;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Depenetration: finds a short displacement that frees a shape which starts inside solids. It first pushes out of the
 * nearest surfaces. If that fails or the displacement is long, it tries each face of each overlapped solid, or the axis
 * directions when there are too many. Reused for every query.
 */
public final class Depenetration {
    private static final int MAX_PUSHES = 12;

    /** Number of solids near a shape above which the faces are not tried one by one: that would take seconds. */
    private static final int CROWD = 128;

    /** Budget of distance queries for one search by the faces: some hundredths of a second. */
    private static final int MOST_MEASURES = 20_000;
    /** Overlap of boxes to the sides that counts as touching only. */
    private static final double TOUCH_METRES = 1e-6;

    private CollisionWorld world;
    private final Separation separation = new Separation();
    private final ItemList near = new ItemList();
    private final ItemList overlapped = new ItemList();
    private final Vector3d place = new Vector3d();
    private final Vector3d push = new Vector3d();
    private final Vector3d still = new Vector3d();
    private final Vector3d sweep = new Vector3d();
    /** For each solid along an axis, the interval of distances in which the shape's box overlaps its box. */
    private double[][] spans = new double[0][];

    private int measures;
    private double shortest;

    /** Returns true if the shape overlaps no solid; touching is allowed. */
    public boolean isFree(CollisionWorld in, RoundedHull shape, Vector3dc at) {
        world = in;
        return deepest(shape, at) >= 0;
    }

    /** Returns the shape's depth in metres in the solid that it is deepest in; 0 for none. */
    public double depth(CollisionWorld in, RoundedHull shape, Vector3dc at) {
        world = in;
        return -deepest(shape, at);
    }

    /**
     * Finds the displacement to a free place, {@link Sweep#SKIN_METRES} from the overlapped solids.
     *
     * @param out receives it; zero when the shape is free already
     * @return false when no free place was found: {@code out} is then the best push
     */
    public boolean find(CollisionWorld in, RoundedHull shape, Vector3dc at, Vector3d out) {
        out.zero();
        if (isFree(in, shape, at)) {
            return true;
        }
        boolean crowded = near.size() > CROWD;
        place.set(at);
        boolean found = relax(shape, place);
        place.sub(at, out);
        shortest = found ? out.length() : Double.POSITIVE_INFINITY;
        if (shortest <= shape.radiusMetres()) {
            return true;
        }
        if (!crowded && !leaveByFaces(shape, at, out)) {
            crowded = true;
        }
        double axial = crowded ? alongAxes(world, shape, at, push) : Double.POSITIVE_INFINITY;
        if (axial < shortest) {
            shortest = axial;
            out.set(push);
        }
        return shortest < Double.POSITIVE_INFINITY;
    }

    /** Tries each face of each overlapped solid; returns false when the budget did not suffice for all. */
    private boolean leaveByFaces(RoundedHull shape, Vector3dc at, Vector3d out) {
        measures = 0;
        listOverlapped(shape, at);
        for (int i = 0; i < overlapped.size(); i++) {
            Collider solid = world.collider(overlapped.get(i));
            for (int face = 0; face < solid.faces(); face++) {
                if (measures > MOST_MEASURES) {
                    return false;
                }
                leaveBy(solid, face, shape, at);
                if (relax(shape, place) && place.distance(at) < shortest) {
                    shortest = place.distance(at);
                    place.sub(at, out);
                }
            }
        }
        return true;
    }

    private void listOverlapped(RoundedHull shape, Vector3dc at) {
        lookAround(shape, at);
        overlapped.clear();
        for (int i = 0; i < near.size(); i++) {
            separation.measure(shape, at.x(), at.y(), at.z(), world.collider(near.get(i)));
            if (separation.metres() < 0) {
                overlapped.accept(near.get(i));
            }
        }
    }

    /** Sets {@code place} to the position at which the shape is just in front of a face. */
    private void leaveBy(Collider solid, int face, RoundedHull shape, Vector3dc at) {
        double nX = solid.plane(face, 0);
        double nY = solid.plane(face, 1);
        double nZ = solid.plane(face, 2);
        int hindmost = shape.least(nX, nY, nZ);
        double front = solid.inFrontOf(
                face,
                at.x() - solid.centre().x() + shape.core(hindmost, 0),
                at.y() - solid.centre().y() + shape.core(hindmost, 1),
                at.z() - solid.centre().z() + shape.core(hindmost, 2));
        double path = shape.radiusMetres() + Sweep.SKIN_METRES - front;
        place.set(at).add(nX * path, nY * path, nZ * path);
    }

    /** Pushes the shape out of its deepest overlap repeatedly; returns true if that ends in a free place. */
    private boolean relax(RoundedHull shape, Vector3d from) {
        for (int i = 0; i < MAX_PUSHES; i++) {
            double depth = deepest(shape, from);
            if (depth >= 0) {
                return true;
            }
            from.add(push);
        }
        return deepest(shape, from) >= 0;
    }

    /** Returns the least separation from any solid, at most 0; {@code push} leads out of the solid that has it. */
    private double deepest(RoundedHull shape, Vector3dc at) {
        lookAround(shape, at);
        boolean crowded = near.size() > CROWD;
        double least = 0;
        for (int i = 0; i < near.size(); i++) {
            Collider solid = world.collider(near.get(i));
            if (crowded && -boxDepth(shape, at, solid.bounds()) > least) {
                continue;
            }
            measures++;
            separation.measure(shape, at.x(), at.y(), at.z(), solid);
            if (separation.metres() < least) {
                least = separation.metres();
                double path = Sweep.SKIN_METRES - least;
                push.set(separation.normal()).mul(path);
            }
        }
        return least;
    }

    private void lookAround(RoundedHull shape, Vector3dc at) {
        world.near(shape, at, still, Sweep.SKIN_METRES, near);
    }

    /**
     * Finds the shortest displacement along one of the six axis directions that frees a shape from all solids. It
     * replaces the solids by their bounding boxes, so the displacement may be longer than necessary but never too short;
     * it always terminates, in the time of a sort.
     *
     * @param displacement receives it; it ends {@link Sweep#SKIN_METRES} from the last solid
     * @return its length
     */
    double alongAxes(CollisionWorld in, RoundedHull shape, Vector3dc at, Vector3d displacement) {
        double metres = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            for (int sign = -1; sign <= 1; sign += 2) {
                double gap = firstGap(in, shape, at, axis, sign);
                if (gap < metres) {
                    metres = gap;
                    displacement.zero().setComponent(axis, sign * gap);
                }
            }
        }
        return metres;
    }

    /** Returns the distance along the direction at which the shape's box is first clear of all other boxes. */
    private double firstGap(CollisionWorld world, RoundedHull shape, Vector3dc at, int axis, int sign) {
        Aabb all = world.extent();
        double end = sign > 0
                ? greatest(all, axis) - at.get(axis) - shape.least(axis)
                : at.get(axis) + shape.greatest(axis) - least(all, axis);
        sweep.zero().setComponent(axis, sign * Math.max(0, end));
        world.near(shape, at, sweep, -TOUCH_METRES, near);
        if (spans.length < near.size()) {
            spans = new double[2 * near.size()][2];
        }
        for (int i = 0; i < near.size(); i++) {
            span(world.collider(near.get(i)).bounds(), shape, at.get(axis), axis, sign, spans[i]);
        }
        Arrays.sort(spans, 0, near.size(), (a, b) -> Double.compare(a[0], b[0]));
        double gap = 0;
        for (int i = 0; i < near.size() && spans[i][0] <= gap; i++) {
            gap = Math.max(gap, spans[i][1]);
        }
        return gap;
    }

    /** Writes the interval of distances along the direction in which the shape overlaps a box or its skin. */
    private static void span(Aabb box, RoundedHull shape, double at, int axis, int sign, double[] span) {
        double begin =
                sign > 0 ? least(box, axis) - at - shape.greatest(axis) : at + shape.least(axis) - greatest(box, axis);
        double end =
                sign > 0 ? greatest(box, axis) - at - shape.least(axis) : at + shape.greatest(axis) - least(box, axis);
        span[0] = begin - Sweep.SKIN_METRES;
        span[1] = end + Sweep.SKIN_METRES;
    }

    /** Returns the least distance along an axis that clears the shape's box of another box; 0 when it is clear. */
    private static double boxDepth(RoundedHull shape, Vector3dc at, Aabb box) {
        double least = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            least = Math.min(least, greatest(box, axis) - at.get(axis) - shape.least(axis));
            least = Math.min(least, at.get(axis) + shape.greatest(axis) - least(box, axis));
        }
        return Math.max(0, least);
    }

    private static double least(Aabb box, int axis) {
        return axis == 0 ? box.minX() : axis == 1 ? box.minY() : box.minZ();
    }

    private static double greatest(Aabb box, int axis) {
        return axis == 0 ? box.maxX() : axis == 1 ? box.maxY() : box.maxZ();
    }
}
