package nephele.engine.collision.rigid.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.collision.Collider;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.collision.rigid.body.Poses;
import nephele.engine.level.Body;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Contacts of capsules over an edge of a box, and across each other. */
class RoundedContactTest {
    private static final double RADIUS = 0.1;
    private static final double HALF_AXIS = 0.5;
    /** A block from x = −4 to 0, so that its edge is the z axis; its top is at y = 0. */
    private static final Collider BLOCK =
            new Collider("block", ConvexPolyhedron.box(Aabb.around(new Vec3(-2, -0.5, 0), new Vec3(4, 1, 4))));

    private final Poses poses = new Poses();
    private final Manifold manifold = new Manifold();

    private static Body capsule(String id) {
        return new Body.Capsule(id, Vec3.ZERO, RADIUS, 2 * (HALF_AXIS + RADIUS), 1, null, 0.6, 0);
    }

    private void add(Vector3d centre, Vector3d axis) {
        int shape = poses.add(BodyTable.CAPSULE, poses.count, -1);
        poses.place(shape, centre.x, centre.y, centre.z);
        poses.halves(shape, 0, HALF_AXIS, RADIUS);
        Vector3d side = new Vector3d(0, 0, 1).cross(axis).normalize();
        Vector3d third = new Vector3d(side).cross(axis);
        double[] rows = {side.x, side.y, side.z, axis.x, axis.y, axis.z, third.x, third.y, third.z};
        System.arraycopy(rows, 0, poses.axes, 9 * shape, 9);
    }

    /** An axis that descends beyond the edge touches the edge: the normal is perpendicular to both. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 0.01, 0.03, 0.049})
    void capsuleAcrossAnEdgeIsPushedOffTheEdge(double slope) {
        Vector3d axis = new Vector3d(1, -slope, 0.3).normalize();
        Vector3d normal = new Vector3d(axis).cross(0, 0, -1).normalize();
        add(new Vector3d(normal).mul(RADIUS - 1e-4), axis);
        NarrowPhase narrow = new NarrowPhase(new BodyTable(List.of(capsule("capsule"))), poses);
        narrow.touch(0, BLOCK, 0.05, 0, manifold);
        assertTrue(normal.y > 0.9);
        assertEquals(normal.x, manifold.nX, 1e-6);
        assertEquals(normal.y, manifold.nY, 1e-6);
        assertEquals(normal.z, manifold.nZ, 1e-6);
        assertEquals(-1e-4, Math.min(manifold.separation[0], manifold.separation[1]), 1e-7);
        assertEquals(2, manifold.count, "the end over the face is held too");
    }

    /** A capsule flat on the face has the face's normal, and both ends of its part over the face as points. */
    @Test
    void capsuleThatLiesFlatHasTwoEnds() {
        add(new Vector3d(0, RADIUS, 0), new Vector3d(1, 0, 0));
        NarrowPhase narrow = new NarrowPhase(new BodyTable(List.of(capsule("capsule"))), poses);
        narrow.touch(0, BLOCK, 0.05, 0, manifold);
        assertEquals(2, manifold.count);
        assertEquals(1, manifold.nY, 1e-12);
        assertEquals(-HALF_AXIS, Math.min(manifold.point[0], manifold.point[3]), 1e-9);
        assertEquals(0, Math.max(manifold.point[0], manifold.point[3]), 1e-9);
    }

    /** Capsules across each other touch at the crossing, even at a small angle; parallel ones along the length. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.04})
    void capsulesTouchWhereTheyAreNearest(double angle) {
        add(new Vector3d(0, 2 * RADIUS, 0), new Vector3d(1, 0, 0));
        add(new Vector3d(), new Vector3d(Math.cos(angle), 0, Math.sin(angle)));
        new RoundedContact().touch(poses, 0, 1, 0.05, manifold);
        assertEquals(angle == 0 ? 2 : 1, manifold.count);
        assertEquals(1, manifold.nY, 1e-9);
        assertEquals(0, manifold.separation[0], 1e-9);
    }
}
