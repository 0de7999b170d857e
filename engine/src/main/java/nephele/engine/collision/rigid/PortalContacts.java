package nephele.engine.collision.rigid;

import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.collision.rigid.body.BodyPortalState;
import nephele.engine.collision.rigid.body.Poses;
import nephele.engine.collision.rigid.contact.Manifold;
import nephele.engine.collision.rigid.contact.NarrowPhase;
import nephele.engine.collision.rigid.solver.SolverState;
import nephele.engine.math.Vec3;
import nephele.engine.portal.PortalTransform;
import nephele.engine.portal.Portals;
import org.joml.Vector3d;

/**
 * The portals on which each shape is active in a tick, and the images with which others collide: the active shape
 * mapped through the portal into the space in front of the partner. It concerns contacts between bodies only; for
 * contacts with walls the solids themselves are cut, {@link PortalWorld#openedFor}. Reused.
 */
final class PortalContacts {
    private final Poses poses;
    private final NarrowPhase narrow;
    private final Vector3d place = new Vector3d();
    private final Vector3d path = new Vector3d();
    private Portals portals = Portals.NONE;
    private long[] characterMasks = new long[0];
    private TickBodies bodies;
    private final Vector3d centre = new Vector3d();

    PortalContacts(Poses poses, NarrowPhase narrow) {
        this.poses = poses;
        this.narrow = narrow;
    }

    /** Finds the masks of all bodies; wakes bodies that are or were active when the portals have changed. */
    void find(TickBodies now, BodyPortalState last, PortalWorld surroundings, Vec3 gravity, double seconds) {
        bodies = now;
        portals = surroundings.portals();
        if (portals.size() == 0 && last.portals().size() == 0) {
            return;
        }
        bodies.active = new long[bodies.count];
        boolean changed = !last.hasEqualPortals(portals);
        for (int body = 0; body < bodies.count; body++) {
            if (!bodies.isAwake(body) && !changed) {
                bodies.active[body] = last.active(body);
                continue;
            }
            int at = Bodies.STRIDE * body;
            int v = at + Bodies.VELOCITY;
            double[] m = bodies.motion;
            place.set(m[at], m[at + 1], m[at + 2]);
            path.set(m[v], m[v + 1], m[v + 2])
                    .add(gravity.x() * seconds / 2, gravity.y() * seconds / 2, gravity.z() * seconds / 2)
                    .mul(bodies.isAwake(body) ? seconds : 0);
            bodies.active[body] = surroundings.active(narrow.turnedHull(body), place, path);
            if (changed && (bodies.active[body] | last.active(body)) != 0) {
                bodies.wake(body);
            }
        }
    }

    /** Adds an image to the poses for every portal on which a body or a character is active. */
    void addImages(PortalWorld surroundings, BodyInfluences influences, SolverState motions, double seconds) {
        if (portals.size() == 0) {
            return;
        }
        for (int body = 0; body < bodies.count; body++) {
            addImages(body, bodies.active[body], motions, seconds);
        }
        if (characterMasks.length < influences.characters()) {
            characterMasks = new long[influences.characters()];
        }
        for (int i = 0; i < influences.characters(); i++) {
            BodyInfluences.Character c = influences.characterList().get(i);
            c.velocity.mul(seconds, path);
            characterMasks[i] = surroundings.active(c.upright, c.centre, path);
            addImages(bodies.count + i, characterMasks[i], motions, seconds);
        }
    }

    private void addImages(int owner, long mask, SolverState motions, double seconds) {
        for (long left = mask; left != 0; left &= left - 1) {
            int portal = Long.numberOfTrailingZeros(left);
            PortalTransform transform = portals.transform(portal);
            if (transform == null) {
                continue;
            }
            int image = poses.add(poses.kind[owner], owner, portal);
            transform.point(poses.centre(owner, place));
            poses.place(image, place.x, place.y, place.z);
            System.arraycopy(poses.half, 3 * owner, poses.half, 3 * image, 3);
            for (int axis = 0; axis < 9; axis += 3) {
                int from = Poses.AXES * owner + axis;
                path.set(poses.axes[from], poses.axes[from + 1], poses.axes[from + 2]);
                transform.direction(path);
                poses.axes[Poses.AXES * image + axis] = path.x;
                poses.axes[Poses.AXES * image + axis + 1] = path.y;
                poses.axes[Poses.AXES * image + axis + 2] = path.z;
            }
            double[] m = motions.velocity;
            int v = SolverState.STRIDE * owner;
            int w = v + SolverState.ANGULAR;
            double turned = path.set(m[w], m[w + 1], m[w + 2]).length() * seconds * poses.radius(owner);
            path.set(m[v], m[v + 1], m[v + 2]);
            transform.direction(path).mul(seconds);
            poses.bound(image, path.x, path.y, path.z, turned, 2 * ContactSearch.REACH_METRES);
        }
    }

    long mask(int owner) {
        if (portals.size() == 0) {
            return 0;
        }
        return owner < bodies.count ? bodies.active[owner] : characterMasks[owner - bodies.count];
    }

    /**
     * Returns true if two shapes are to be tested: an image is tested against real shapes only, and of two images that
     * give the same contact only one is used.
     */
    boolean isPair(int a, int b) {
        int real = poses.through[a] < 0 ? a : b;
        int image = real == a ? b : a;
        if (poses.through[real] >= 0) {
            return false;
        }
        if (poses.through[image] < 0) {
            return true;
        }
        int portal = poses.through[image];
        int partner = portals.partner(portal);
        int owner = poses.owner[image];
        int met = poses.owner[real];
        boolean twice = (mask(met) & 1L << partner) != 0;
        if (owner == met) {
            return owner < bodies.count && (!twice || portal < partner);
        }
        return !twice || owner < met;
    }

    /** Writes the rotation from the space of the real shape to that of the image's owner: nine numbers, by rows. */
    void turn(int portal, double[] out) {
        portals.transform(portal).rotation().get(out);
    }

    /**
     * Drops the points at which only one of the two shapes is present; points are relative to the first, which is real.
     */
    void keepValid(Manifold manifold, int a, int b) {
        int portal = poses.through[b];
        long maskA = mask(poses.owner[a]);
        long maskB = mask(poses.owner[b]);
        if ((maskA | maskB) == 0) {
            return;
        }
        for (int i = manifold.count - 1; i >= 0; i--) {
            place.set(
                    poses.centre[3 * a] + manifold.point[3 * i],
                    poses.centre[3 * a + 1] + manifold.point[3 * i + 1],
                    poses.centre[3 * a + 2] + manifold.point[3 * i + 2]);
            long throughA = through(maskA, a);
            boolean valid;
            if (portal < 0) {
                valid = throughA == through(maskB, b);
            } else {
                int partner = portals.partner(portal);
                portals.transform(partner).point(place);
                long throughB = through(maskB, poses.owner[b]);
                valid = (throughA == 0 && throughB == 1L << portal) || (throughA == 1L << partner && throughB == 0);
            }
            if (!valid) {
                manifold.remove(i);
            }
        }
    }

    private long through(long mask, int shape) {
        return portals.behind(mask, poses.centre(shape, centre), place);
    }
}
