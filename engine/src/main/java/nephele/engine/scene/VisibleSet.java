package nephele.engine.scene;

import java.util.List;
import nephele.engine.math.Frustum;
import nephele.engine.math.bvh.RangeVisitor;
import org.joml.Matrix4d;

/**
 * The index ranges of each batch that a view may see, nearest parts first. Conservative: omitted parts cover no pixel.
 * One object serves all frames without growing.
 */
public final class VisibleSet {
    private final SolidGeometry geometry;
    private final List<SolidBatch> batches;
    private final int[][] firsts;
    private final int[][] lengths;
    private final int[] sizes;
    private final Matrix4d clipFromRelative = new Matrix4d();
    private final Frustum frustum = Frustum.reusable(7);
    private final RangeVisitor add = this::add;

    public VisibleSet(SolidGeometry geometry) {
        this.geometry = geometry;
        this.batches = geometry.batches();
        firsts = new int[batches.size()][geometry.slotCount()];
        lengths = new int[batches.size()][geometry.slotCount()];
        sizes = new int[batches.size()];
    }

    /** Replaces the contents by what {@code view} may see. */
    public void find(View view) {
        find(frustum(view));
    }

    private Frustum frustum(View view) {
        frustum.restart(view.eyeX(), view.eyeY(), view.eyeZ());
        frustum.keepAll(view.clipFromRelative(clipFromRelative));
        if (view.clip() != null) {
            frustum.keepInFrontOf(view.clip());
        }
        return frustum;
    }

    /** Replaces the contents by what {@code frustum} may contain. */
    public void find(Frustum frustum) {
        clear();
        geometry.index().cull(frustum, add);
    }

    /** Same as {@link #find(View)} by a slower and looser test: one bounding sphere after the other. */
    public void findBySpheres(View view) {
        findBySpheres(frustum(view));
    }

    /** Same as {@link #find(Frustum)} by a slower and looser test: one bounding sphere after the other. */
    public void findBySpheres(Frustum frustum) {
        clear();
        geometry.index().cullSpheres(frustum, add);
    }

    /** Selects everything; the reference for tests of culling. */
    public void selectAll() {
        clear();
        add(0, geometry.slotCount());
    }

    private void clear() {
        for (int batch = 0; batch < sizes.length; batch++) {
            sizes[batch] = 0;
        }
    }

    private void add(int firstSlot, int endSlot) {
        for (int b = 0; b < sizes.length; b++) {
            SolidBatch batch = batches.get(b);
            int start = batch.start(firstSlot);
            int length = batch.start(endSlot) - start;
            int last = sizes[b] - 1;
            if (length == 0) {
                continue;
            }
            if (last >= 0 && firsts[b][last] + lengths[b][last] == start) {
                lengths[b][last] += length;
            } else {
                firsts[b][sizes[b]] = start;
                lengths[b][sizes[b]++] = length;
            }
        }
    }

    /** Returns the number of ranges of a batch; the arrays below are valid up to it. */
    public int size(int batch) {
        return sizes[batch];
    }

    public int[] firsts(int batch) {
        return firsts[batch];
    }

    public int[] lengths(int batch) {
        return lengths[batch];
    }
}
