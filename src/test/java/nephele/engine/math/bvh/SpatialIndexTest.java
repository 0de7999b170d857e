package nephele.engine.math.bvh;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.math.Aabb;
import nephele.engine.math.Frustum;
import nephele.engine.math.FrustumTest;
import nephele.engine.math.RangeList;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import org.joml.Matrix4d;
import org.junit.jupiter.api.Test;

class SpatialIndexTest {
    private static final double INF = Double.POSITIVE_INFINITY;

    private static List<Aabb> randomBoxes(SplittableRandom random, int count) {
        List<Aabb> boxes = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            boxes.add(FrustumTest.randomBox(random, Vec3.ZERO, 30));
        }
        boxes.set(3, Aabb.EMPTY);
        boxes.set(7, new Aabb(-INF, 2, -INF, INF, 2.5, INF));
        boxes.set(8, boxes.get(9));
        return boxes;
    }

    private static BitSet culled(SpatialIndex index, Frustum frustum) {
        BitSet items = new BitSet();
        index.cull(frustum, (first, end) -> {
            assertTrue(first < end, "an empty run");
            for (int slot = first; slot < end; slot++) {
                assertFalse(items.get(index.itemAt(slot)), "an item reported twice");
                items.set(index.itemAt(slot));
            }
        });
        return items;
    }

    @Test
    void cullingThroughTheTreeEqualsTestingEveryBox() {
        var random = new SplittableRandom(1);
        List<Aabb> boxes = randomBoxes(random, 1000);
        SpatialIndex[] indices = {SpatialIndex.of(boxes, 1), SpatialIndex.of(boxes), SpatialIndex.of(boxes, 16)};
        for (int view = 0; view < 200; view++) {

            Matrix4d clip = FrustumTest.randomView(random, 0.05, view % 2 == 0 ? INF : 40);
            Frustum frustum = Frustum.of(clip, new Vec3(random.nextDouble(-20, 20), 0, 3));
            BitSet expected = new BitSet();
            for (int i = 0; i < boxes.size(); i++) {
                expected.set(i, frustum.mayIntersect(boxes.get(i)));
            }
            assertEquals(expected, culled(indices[view % 3], frustum));
        }
    }

    @Test
    void aSubtreeInsideAllPlanesIsOneRun() {
        List<Aabb> boxes = new ArrayList<>();
        for (int i = 0; i < 512; i++) {
            boxes.add(Aabb.around(new Vec3(i % 8 - 4, i / 8 % 8 - 4, i / 64 - 40), new Vec3(0.5, 0.5, 0.5)));
        }
        RangeList runs = new RangeList();
        SpatialIndex.of(boxes).cull(Frustum.of(FrustumTest.projection(0.05, INF), Vec3.ZERO), runs);
        assertEquals(1, runs.size());
        assertEquals(512, runs.slots());
        assertEquals(0, runs.first(0));
        assertEquals(512, runs.end(0));
    }

    @Test
    void nearerSubtreesComeFirst() {
        List<Aabb> boxes = new ArrayList<>();
        for (int i = 0; i < 64; i++) {
            boxes.add(Aabb.around(new Vec3(0, 0, -2 - i), new Vec3(0.5, 0.5, 0.5)));
        }
        Collections.shuffle(boxes, new java.util.Random(2));
        SpatialIndex index = SpatialIndex.of(boxes, 1);
        // A plane that intersects every box prevents reports of whole subtrees.
        Frustum cutting = Frustum.reusable(1);
        cutting.restart(0, 0, 0);
        cutting.keep(1, 0, 0, 0);
        List<Double> depths = new ArrayList<>();
        index.cull(
                cutting,
                (first, end) -> depths.add(-boxes.get(index.itemAt(first)).maxZ()));
        List<Double> sorted = new ArrayList<>(depths);
        Collections.sort(sorted);
        assertEquals(64, depths.size());
        assertEquals(sorted, depths);
    }

    @Test
    void overlapQueriesEqualTestingEveryBox() {
        var random = new SplittableRandom(3);
        List<Aabb> boxes = randomBoxes(random, 800);
        SpatialIndex index = SpatialIndex.of(boxes);
        ItemList found = new ItemList();
        for (int query = 0; query < 500; query++) {
            Aabb box = FrustumTest.randomBox(random, Vec3.ZERO, 30);
            found.clear();
            index.overlapping(box, found);
            found.sort();
            assertArrayEquals(overlapping(boxes, box), items(found));
        }
    }

    @Test
    void whatPassesATestIsWhatPassesItBoxByBox() {
        var random = new SplittableRandom(11);
        List<Aabb> boxes = randomBoxes(random, 800);
        SpatialIndex index = SpatialIndex.of(boxes);
        ItemList found = new ItemList();
        for (int query = 0; query < 500; query++) {
            Aabb box = FrustumTest.randomBox(random, Vec3.ZERO, 30);
            found.clear();
            index.query((bounds, at) -> bounds[at] <= box.maxX() && box.minX() <= bounds[at + 3], found);
            found.sort();
            var slab = new Aabb(box.minX(), -INF, -INF, box.maxX(), INF, INF);
            assertArrayEquals(overlapping(boxes, slab), items(found));
        }
    }

    private static int[] overlapping(List<Aabb> boxes, Aabb box) {
        return java.util.stream.IntStream.range(0, boxes.size())
                .filter(i -> !boxes.get(i).isEmpty() && boxes.get(i).overlaps(box))
                .toArray();
    }

    private static int[] items(ItemList list) {
        int[] items = new int[list.size()];
        for (int i = 0; i < items.length; i++) {
            items[i] = list.get(i);
        }
        return items;
    }

    @Test
    void theNearestHitIsTheNearestOfAllAndTheLowestOfEquals() {
        var random = new SplittableRandom(4);
        List<Aabb> boxes = randomBoxes(random, 800);
        SpatialIndex index = SpatialIndex.of(boxes, 2);
        ItemRayTest test = (ray, item, limit) -> ray.boxEntry(boxes.get(item), limit);
        RayHit hit = new RayHit();
        int hits = 0;
        for (int query = 0; query < 1000; query++) {
            Vec3 origin = new Vec3(random.nextDouble(-40, 40), random.nextDouble(-40, 40), random.nextDouble(-40, 40));
            Vec3 direction = new Vec3(random.nextDouble(-1, 1), random.nextDouble(-1, 1), query % 5 == 0 ? 0 : 1);
            Ray ray = Ray.of(origin, direction);
            double limit = query % 2 == 0 ? INF : 20;
            int best = -1;
            double bestDistance = INF;
            for (int i = 0; i < boxes.size(); i++) {
                double distance = boxes.get(i).isEmpty() ? INF : ray.boxEntry(boxes.get(i), limit);
                if (distance < bestDistance) {
                    best = i;
                    bestDistance = distance;
                }
            }
            assertEquals(best >= 0, index.nearest(ray, limit, test, hit));
            assertEquals(best, hit.item());
            assertEquals(best >= 0, index.anyHit(ray, limit, test));
            hits += best >= 0 ? 1 : 0;
        }
        assertTrue(hits > 300 && hits < 1000, hits + " hits");
    }

    @Test
    void aSweptBoxFindsAllThatItsStepsTouch() {
        var random = new SplittableRandom(6);
        List<Aabb> boxes = randomBoxes(random, 800);
        SpatialIndex index = SpatialIndex.of(boxes);
        ItemList found = new ItemList();
        long reported = 0;
        long touched = 0;
        for (int query = 0; query < 100; query++) {
            Aabb start = FrustumTest.randomBox(random, Vec3.ZERO, 30);
            Vec3 motion = new Vec3(query % 3 == 0 ? 0 : random.nextDouble(-20, 20), -3, random.nextDouble(-20, 20));
            BitSet expected = new BitSet();
            for (int step = 0; step <= 200; step++) {
                double t = step / 200.0;
                Aabb at = new Aabb(
                        start.minX() + t * motion.x(),
                        start.minY() + t * motion.y(),
                        start.minZ() + t * motion.z(),
                        start.maxX() + t * motion.x(),
                        start.maxY() + t * motion.y(),
                        start.maxZ() + t * motion.z());
                for (int item : overlapping(boxes, at)) {
                    expected.set(item);
                }
            }
            found.clear();
            index.swept(start, motion, found);
            touched += expected.cardinality();
            reported += found.size();
            for (int item : items(found)) {
                expected.clear(item);
            }
            assertTrue(expected.isEmpty(), "missed " + expected);
        }
        assertTrue(reported < touched * 1.3, reported + " reported, " + touched + " touched");
    }

    @Test
    void equalInputGivesTheEqualTree() {
        List<Aabb> boxes = randomBoxes(new SplittableRandom(9), 500);
        SpatialIndex first = SpatialIndex.of(boxes);
        SpatialIndex second = SpatialIndex.of(boxes);
        for (int slot = 0; slot < boxes.size(); slot++) {
            assertEquals(first.itemAt(slot), second.itemAt(slot));
        }
    }

    @Test
    void degenerateCollectionsAreIndexed() {
        RangeList runs = new RangeList();
        Frustum frustum = Frustum.of(FrustumTest.projection(0.05, INF), Vec3.ZERO);
        SpatialIndex.of(List.of()).cull(frustum, runs);
        SpatialIndex.of(List.of(Aabb.EMPTY, Aabb.EMPTY)).cull(frustum, runs);
        assertEquals(0, runs.size());
        Aabb ahead = Aabb.around(new Vec3(0, 0, -5), new Vec3(1, 1, 1));
        SpatialIndex.of(Collections.nCopies(10_000, ahead)).cull(frustum, runs);
        assertEquals(10_000, runs.slots());
        Aabb huge = new Aabb(-1e308, -1e308, -1e308, 1e308, 1e308, 1e308);
        runs.clear();
        SpatialIndex.of(List.of(huge, ahead, huge, ahead, huge, ahead)).cull(frustum, runs);
        assertEquals(6, runs.slots());
    }

    @Test
    void queriesAllocateNothing() {
        List<Aabb> boxes = randomBoxes(new SplittableRandom(10), 2000);
        SpatialIndex index = SpatialIndex.of(boxes);
        Frustum frustum = Frustum.of(FrustumTest.projection(0.05, INF), Vec3.ZERO);
        RangeList runs = new RangeList();
        ItemList items = new ItemList();
        RayHit hit = new RayHit();
        Ray ray = new Ray(0, 0, 0, 1, 0.2, 0.3);
        ItemRayTest miss = (r, item, limit) -> INF;
        Aabb box = Aabb.around(Vec3.ZERO, new Vec3(40, 40, 40));
        var threads = (com.sun.management.ThreadMXBean) java.lang.management.ManagementFactory.getThreadMXBean();
        long self = Thread.currentThread().getId();
        long before = 0;
        for (int round = 0; round < 40; round++) {
            if (round == 20) {
                before = threads.getThreadAllocatedBytes(self);
            }
            runs.clear();
            items.clear();
            index.cull(frustum, runs);
            index.overlapping(box, items);
            index.nearest(ray, INF, miss, hit);
            index.anyHit(ray, INF, miss);
        }
        long bytes = threads.getThreadAllocatedBytes(self) - before;
        assertTrue(bytes <= 64 * 20, bytes + " bytes in 20 rounds of four queries");
    }
}
