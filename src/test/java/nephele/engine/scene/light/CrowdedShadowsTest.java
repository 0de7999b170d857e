package nephele.engine.scene.light;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** Finding the shadow casters of a crowd takes near-linear time. */
class CrowdedShadowsTest {
    private static final double MOST_CPU_SECONDS = 2;

    /** The boxes are displaced by 1 mm each, so that some box is below every face except the ground's. */
    @Test
    void tenThousandOverlappingBoxesAllCast() {
        List<Brush> crowd = new ArrayList<>();
        for (int i = 0; i < 10_000; i++) {
            crowd.add(ShadowTest.box(i % 100 * 1e-3, i / 100 * 1e-3, 0, 1, 1, 1));
        }
        List<Brush> all = new ArrayList<>(crowd);
        all.add(ShadowTest.box(0, -2, 0, 9, 1, 9));
        var threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long before = threads.getCurrentThreadCpuTime();
        assertEquals(crowd, ShadowCasters.of(all, new Vec3(1, 2, 1)));
        double seconds = (threads.getCurrentThreadCpuTime() - before) / 1e9;
        assertTrue(seconds < MOST_CPU_SECONDS, seconds + " CPU-s");
    }
}
