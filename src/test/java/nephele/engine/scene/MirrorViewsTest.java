package nephele.engine.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.measure.Stopwatch;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** Views in mirrors have the right eyes and orientations, also at extreme positions of the eye. */
class MirrorViewsTest {
    private static final Vec3 UP = new Vec3(0, 1, 0);
    private static final Vec3 SILVER = new Vec3(0.9, 0.8, 0.5);

    private static FrameState nothing() {
        return FrameState.atStart(new TestLevel().level());
    }

    /** Returns a mirror of 2 m by 2 m in a plane of constant z, facing +z or −z. */
    private static Opening mirror(int id, Vec3 centre, double facing) {
        double x = centre.x();
        double y = centre.y();
        double z = centre.z();
        List<Vec3> polygon = List.of(
                new Vec3(x - facing, y - 1, z),
                new Vec3(x + facing, y - 1, z),
                new Vec3(x + facing, y + 1, z),
                new Vec3(x - facing, y + 1, z));
        return Opening.ofMirror(id, polygon, new Vec3(0, 0, facing), SILVER);
    }

    private static ViewTree grown(Vec3 eye, Vec3 target, int budget, Opening... mirrors) {
        ViewTree tree = new ViewTree(List.of(mirrors));
        View view = View.lookAt(eye, target, UP, new Projection(1, 16 / 9.0, 0.05, 1000));
        tree.build(view, nothing(), 1280, 720, budget);
        return tree;
    }

    /** The eye of a view in a mirror is the eye's image, and each mirror on the path flips the view's orientation. */
    @Test
    void aMirrorInAMirrorIsTheRightWayRound() {
        Opening near = mirror(0, new Vec3(0, 0, -2), 1);
        Opening behind = mirror(1, new Vec3(0, 0, 3), -1);
        ViewTree tree = grown(new Vec3(0.25, 0.1, 0), new Vec3(0.2, 0.1, -2), 6, near, behind);
        assertEquals(7, tree.views().size());
        assertFalse(tree.root().view().isMirrored());
        double[] images = {0, -4, 10, -14, 20, -24, 30};
        for (ViewNode node : tree.views()) {
            View view = node.view();
            assertEquals(node.depth() % 2 == 1, view.isMirrored(), "depth " + node.depth());
            assertEquals(0.25, view.eyeX(), 1e-12);
            assertEquals(images[node.depth()], view.eyeZ(), 1e-12);
            assertEquals(Math.pow(0.8, node.depth()), view.tint().y(), 1e-12);
            Vector3d right = view.right().toVector();
            double handed = right.cross(view.up().toVector()).dot(view.back().toVector());
            assertEquals(view.isMirrored() ? -1 : 1, handed, 1e-12);
        }
    }

    /** A point in front of the mirror is at the same place in the reflected view as its image in the main view. */
    @Test
    void theReflectedViewSeesAPointWhereItsImageIs() {
        ViewTree tree = grown(new Vec3(0.3, 0.2, 1), new Vec3(0, 0, -2), 1, mirror(0, new Vec3(0, 0, -2), 1));
        View root = tree.root().view();
        View seen = tree.views().get(1).view();
        Vector3d p = new Vector3d(-0.7, 0.4, 0.6);
        Vector3d image = new Vector3d(-0.7, 0.4, -4.6);
        Vector3d fromImage = p.sub(seen.eye().toVector(), new Vector3d());
        Vector3d fromEye = image.sub(root.eye().toVector(), new Vector3d());
        assertEquals(root.alongRight(fromEye.x, fromEye.y, fromEye.z), along(seen.right(), fromImage), 1e-12);
        assertEquals(root.alongUp(fromEye.x, fromEye.y, fromEye.z), along(seen.up(), fromImage), 1e-12);
        assertEquals(root.alongBack(fromEye.x, fromEye.y, fromEye.z), along(seen.back(), fromImage), 1e-12);
    }

    private static double along(Vec3 axis, Vector3d v) {
        return v.dot(axis.toVector());
    }

    /** Nothing is reflected in the mirror's plane and behind it; 1 µm in front of it half of all directions are. */
    @Test
    void theEyeAtThePlane() {
        Opening mirror = mirror(0, Vec3.ZERO, 1);
        for (double z : new double[] {0, -1e-9, -1e-6, -0.3}) {
            ViewTree tree = grown(new Vec3(0, 0, z), new Vec3(0, 0, z - 1), 9, mirror);
            assertEquals(1, tree.views().size() + tree.terminals().size(), "z " + z);
        }
        ViewTree near = grown(new Vec3(0, 0, 1e-6), new Vec3(0, 0, -1), 9, mirror);
        assertEquals(2, near.views().size());
        assertEquals(-1e-6, near.views().get(1).view().eyeZ(), 1e-21);
        assertEquals(1280 * 720, near.views().get(1).area(), 1);
        ViewTree along = grown(new Vec3(-0.9, 0, 1e-6), new Vec3(0.5, 0, 1e-6), 9, mirror);
        assertEquals(2, along.views().size());
        assertEquals(640 * 720, along.views().get(1).area(), 1);
    }

    /** A view parallel to the mirror from 1 m away sees it with the projected width. */
    @Test
    void aViewParallelToTheMirror() {
        ViewTree tree = grown(new Vec3(-3, 0, 1), new Vec3(0, 0, 1), 9, mirror(0, Vec3.ZERO, 1));
        assertEquals(2, tree.views().size());
        PicturePolygon seen = tree.views().get(1).outline();
        double tan = Math.tan(0.5) * 16 / 9;
        // Corners 2 m and 4 m ahead, 1 m to the left of the view direction.
        for (int i = 0; i < seen.size(); i++) {
            double x = seen.x(i) / seen.w(i);
            assertTrue(Math.abs(Math.abs(x) - 0.5 / tan) < 1e-12 || Math.abs(Math.abs(x) - 0.25 / tan) < 1e-12);
        }
    }

    /** A million metres from the origin the picture's polygon is the same. */
    @Test
    void farFromTheOrigin() {
        double far = 1 << 20;
        Opening here = mirror(0, Vec3.ZERO, 1);
        Opening there = mirror(0, new Vec3(far, -far, far), 1);
        ViewTree near = grown(new Vec3(0.5, 0.25, 2), new Vec3(0, 0, -1), 1, here);
        ViewTree away = grown(new Vec3(far + 0.5, -far + 0.25, far + 2), new Vec3(far, -far, far - 1), 1, there);
        PicturePolygon a = near.views().get(1).outline();
        PicturePolygon b = away.views().get(1).outline();
        assertEquals(a.size(), b.size());
        for (int i = 0; i < a.size(); i++) {
            assertEquals(a.x(i) / a.w(i), b.x(i) / b.w(i), 1e-9);
            assertEquals(a.y(i) / a.w(i), b.y(i) / b.w(i), 1e-9);
        }
        assertEquals(far - 2, away.views().get(1).view().eyeZ(), 1e-9);
    }

    /** Views in mirrors, including tints and history lookups, cause no allocation per frame. */
    @Test
    void viewsInMirrorsMakeNoGarbage() {
        Opening[] mirrors = {mirror(0, new Vec3(0, 0, -2), 1), mirror(1, new Vec3(0, 0, 3), -1)};
        List<ViewTree> trees = List.of(new ViewTree(List.of(mirrors)), new ViewTree(List.of(mirrors)));
        View view = View.lookAt(
                new Vec3(0.25, 0.1, 0), new Vec3(0.2, 0.1, -2), UP, new Projection(1, 16 / 9.0, 0.05, 1000));
        FrameState frameState = nothing();
        ViewHistory history = new ViewHistory();
        Stopwatch stopwatch = new Stopwatch();
        long before = 0;
        for (int frame = 0; frame < 2000; frame++) {
            if (frame == 1000) {
                before = stopwatch.allocatedBytes();
            }
            ViewTree tree = trees.get(frame % 2);
            tree.build(view, frameState, 1280, 720, 6);
            history.match(tree);
            history.remember(tree);
        }
        long bytes = (stopwatch.allocatedBytes() - before) / 1000;
        assertTrue(bytes <= 64, bytes + " bytes a frame");
    }
}
