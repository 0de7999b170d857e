package nephele.engine.collision;

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

    private CollisionWorld world;
    private final Separation separation = new Separation();
    private final ItemList near = new ItemList();
    private final ItemList overlapped = new ItemList();
    private final AxisDepenetration axes = new AxisDepenetration();
    private final Vector3d place = new Vector3d();
    private final Vector3d push = new Vector3d();
    private final Vector3d still = new Vector3d();
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
        if (crowded && axes.find(world, shape, at) < shortest) {
            shortest = axes.metres();
            out.set(axes.displacement());
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
                overlapped.item(near.get(i));
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
        double way = shape.radiusMetres() + Sweep.SKIN_METRES - front;
        place.set(at).add(nX * way, nY * way, nZ * way);
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
            if (crowded && -AxisDepenetration.depth(shape, at, solid.bounds()) > least) {
                continue;
            }
            measures++;
            separation.measure(shape, at.x(), at.y(), at.z(), solid);
            if (separation.metres() < least) {
                least = separation.metres();
                double way = Sweep.SKIN_METRES - least;
                push.set(separation.normalX(), separation.normalY(), separation.normalZ())
                        .mul(way);
            }
        }
        return least;
    }

    private void lookAround(RoundedHull shape, Vector3dc at) {
        world.near(shape, at, still, Sweep.SKIN_METRES, near);
    }
}
