package nephele.engine.collision.rigid.contact;

import java.util.List;
import nephele.engine.collision.Collider;
import nephele.engine.collision.ContactHull;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.collision.rigid.body.Poses;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Vec3;

/** Finds the contact points of two shapes of any kind. Reused. */
public final class NarrowPhase {
    private final Poses poses;
    private final FaceClip clip = new FaceClip();
    private final BoxBoxContact boxes = new BoxBoxContact(clip);
    private final BoxHullContact hulls = new BoxHullContact(clip);
    private final RoundedContact rounds = new RoundedContact();
    private final RoundedHull[] upright;
    private final RoundedHull[] turned;
    private final Collider[] boxSolids;
    private final int bodies;

    public NarrowPhase(BodyTable table, Poses poses) {
        this.poses = poses;
        bodies = table.size();
        upright = new RoundedHull[bodies];
        turned = new RoundedHull[bodies];
        boxSolids = new Collider[bodies];
        for (int i = 0; i < bodies; i++) {
            upright[i] = table.uprightHull(i);
            turned[i] = upright[i].copy();
            if (table.kind(i) == BodyTable.BOX) {
                Vec3 size = new Vec3(2 * table.half(i, 0), 2 * table.half(i, 1), 2 * table.half(i, 2));
                boxSolids[i] = new Collider(table.body(i).id(), ConvexPolyhedron.box(Aabb.around(Vec3.ZERO, size)));
            }
        }
    }

    /** Returns a body's shape in its present orientation; changed by the next call for the same body. */
    public RoundedHull turnedHull(int body) {
        turned[body].turn(upright[body], poses.axes, Poses.AXES * body);
        return turned[body];
    }

    /** Returns a body's shape in the given orientation; changed by the next call for the same body. */
    public RoundedHull turnedBy(int body, double[] axes) {
        turned[body].turn(upright[body], axes, 0);
        return turned[body];
    }

    /** Returns a body's box, axis-aligned around the origin. */
    public Collider boxSolid(int body) {
        return boxSolids[body];
    }

    /** Finds the contact of two moving shapes; the first has the lower index. */
    public void touch(int a, int b, double reach, List<BodyInfluences.Character> characters, Manifold out) {
        boolean boxA = poses.kind[a] == BodyTable.BOX;
        boolean boxB = poses.kind[b] == BodyTable.BOX;
        if (boxA && boxB) {
            boxes.touch(poses, a, b, reach, out);
        } else if (!boxA && !boxB) {
            rounds.touch(poses, a, b, reach, out);
        } else if (boxB) {
            roundAndBox(a, b, reach, characters, out);
        } else {
            roundAndBox(b, a, reach, characters, out);
            int i = 3 * b;
            int j = 3 * a;
            double[] c = poses.centre;
            out.swap(c[i] - c[j], c[i + 1] - c[j + 1], c[i + 2] - c[j + 2]);
        }
    }

    private void roundAndBox(
            int round, int box, double reach, List<BodyInfluences.Character> characters, Manifold out) {
        int owner = poses.owner[round];
        boolean isBody = owner < bodies;
        RoundedHull shape = isBody ? upright[owner] : characters.get(owner - bodies).upright;
        RoundedHull scratch = isBody ? turned[owner] : characters.get(owner - bodies).scratch;
        rounds.touchBox(poses, round, box, scratch, shape, boxSolids[poses.owner[box]], reach, out);
    }

    /**
     * Finds the contact of a body and a static solid; {@code scratch} is a shape of the poses that may be overwritten.
     */
    public void touch(int body, Collider solid, double reach, int scratch, Manifold out) {
        if (poses.kind[body] != BodyTable.BOX) {
            rounds.touch(poses, body, turnedHull(body), solid, reach, out);
            return;
        }
        ContactHull hull = solid.contactHull();
        if (!hull.uprightBox()) {
            hulls.touch(poses, body, hull, solid.centre(), reach, out);
            return;
        }
        Vec3 c = solid.centre();
        poses.place(scratch, c.x(), c.y(), c.z());
        poses.halves(scratch, hull.halfSize(0), hull.halfSize(1), hull.halfSize(2));
        boxes.touch(poses, body, scratch, reach, out);
    }
}
