package nephele.engine.scene.dynamic;

import java.util.Arrays;
import nephele.engine.math.Frustum;
import nephele.engine.math.Vec3;
import nephele.engine.scene.View;
import nephele.engine.scene.dynamic.DynamicMesh.Range;
import org.joml.Vector3d;

/**
 * The instances that a view may see and their levels of detail, as runs of instances that one call draws. Conservative:
 * omitted instances cover no pixel. One object serves all views.
 */
public final class VisibleInstances {
    /** The greatest error of a level of detail in pixels, too small to be visible. */
    private static final double FLATNESS_PIXELS = 0.3;

    private final DynamicObjects dynamicObjects;
    private final DynamicInstances copies;
    private final Frustum whole = Frustum.reusable(4);
    private final Vector3d normal = new Vector3d();
    private final Vector3d eye = new Vector3d();
    private int[] groups = new int[64];
    private int[] firsts = new int[64];
    private int[] counts = new int[64];
    private Range[] meshes = new Range[64];
    private int runs;

    public VisibleInstances(DynamicObjects dynamicObjects, DynamicInstances copies) {
        this.dynamicObjects = dynamicObjects;
        this.copies = copies;
    }

    /** Finds the instances in a view's whole picture, without the held body; {@code pictureHeight} is in pixels. */
    public void find(View view, int pictureHeight, HeldBodyVisibility held) {
        double right = view.projection().tanHalfWidth();
        double up = view.projection().tanHalfHeight();
        whole.restart(view.eyeX(), view.eyeY(), view.eyeZ());
        keep(view.direction(1, 0, -right, normal));
        keep(view.direction(-1, 0, -right, normal));
        keep(view.direction(0, 1, -up, normal));
        keep(view.direction(0, -1, -up, normal));
        find(view, whole, pictureHeight, held);
    }

    private void keep(Vector3d inwards) {
        whole.keep(inwards.x, inwards.y, inwards.z, 0);
    }

    /**
     * Finds the instances in a frustum.
     *
     * @param pictureHeight pixels
     */
    public void find(View view, Frustum frustum, int pictureHeight, HeldBodyVisibility held) {
        eye.set(view.eyeX(), view.eyeY(), view.eyeZ());
        find(frustum, pictureHeight / (2 * view.projection().tanHalfHeight()), held);
    }

    /**
     * Finds the instances in a frustum from any position.
     *
     * @param pixelsPerTangent size in pixels of a metre at a distance of 1 m
     */
    public void find(Frustum frustum, Vec3 from, double pixelsPerTangent) {
        eye.set(from.x(), from.y(), from.z());
        find(frustum, pixelsPerTangent, null);
    }

    private void find(Frustum frustum, double pixelsPerTangent, HeldBodyVisibility held) {
        runs = 0;
        for (int group = 0; group < dynamicObjects.groups().size(); group++) {
            DynamicGroup shape = dynamicObjects.groups().get(group);
            for (int i = copies.start(group); i < copies.start(group + 1); i += shape.parts()) {
                if ((held == null || !held.contains(i)) && maySee(frustum, i, shape.parts())) {
                    double pixels = copies.ball(i, 3) * pixelsPerTangent / distance(i);
                    add(group, i, mesh(shape, pixels, i, held));
                }
            }
        }
    }

    private boolean maySee(Frustum frustum, int first, int parts) {
        for (int i = first; i < first + parts; i++) {
            if (frustum.mayIntersect(copies.ball(i, 0), copies.ball(i, 1), copies.ball(i, 2), copies.ball(i, 3))) {
                return true;
            }
        }
        return false;
    }

    /** Selects the held body only, with its finest mesh. */
    public void selectHeld(HeldBodyVisibility held) {
        runs = 0;
        for (int i = 0; i < held.size(); i++) {
            int group = 0;
            while (copies.start(group + 1) <= held.instance(i)) {
                group++;
            }
            add(group, held.instance(i), dynamicObjects.groups().get(group).steps()[0]);
        }
    }

    private double distance(int instance) {
        double x = copies.ball(instance, 0) - eye.x;
        double y = copies.ball(instance, 1) - eye.y;
        double z = copies.ball(instance, 2) - eye.z;
        double nearest = Math.sqrt(x * x + y * y + z * z) - copies.ball(instance, 3);
        return Math.max(nearest, 1e-3);
    }

    private Range mesh(DynamicGroup shape, double radiusPixels, int instance, HeldBodyVisibility held) {
        int step = shape.steps().length - 1;
        while (step > 0 && shape.flatness()[step] * radiusPixels > FLATNESS_PIXELS) {
            step--;
        }
        boolean isHeadless = shape.headless() != null && copies.headContains(instance, shape.parts(), eye);
        if (!isHeadless) {
            return shape.steps()[step];
        }
        return held != null && held.isGunBeforeEye() ? shape.gunHolding()[step] : shape.headless()[step];
    }

    private void add(int group, int instance, Range mesh) {
        int last = runs - 1;
        if (last >= 0 && groups[last] == group && meshes[last] == mesh && firsts[last] + counts[last] == instance) {
            counts[last] += dynamicObjects.groups().get(group).parts();
            return;
        }
        if (runs == groups.length) {
            groups = Arrays.copyOf(groups, 2 * runs);
            firsts = Arrays.copyOf(firsts, 2 * runs);
            counts = Arrays.copyOf(counts, 2 * runs);
            meshes = Arrays.copyOf(meshes, 2 * runs);
        }
        groups[runs] = group;
        firsts[runs] = instance;
        counts[runs] = dynamicObjects.groups().get(group).parts();
        meshes[runs++] = mesh;
    }

    public int runs() {
        return runs;
    }

    public int group(int run) {
        return groups[run];
    }

    /** Returns the first instance of a run. */
    public int first(int run) {
        return firsts[run];
    }

    public int count(int run) {
        return counts[run];
    }

    public Range mesh(int run) {
        return meshes[run];
    }
}
