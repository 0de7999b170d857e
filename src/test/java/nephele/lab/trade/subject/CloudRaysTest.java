package nephele.lab.trade.subject;

import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.scene.View;
import nephele.host.named.LevelName;
import nephele.host.named.OpenedLevel;
import nephele.host.named.Viewpoints;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class CloudRaysTest {
    @Test
    void longerStepsEvaluateLessAndMissMore() {
        OpenedLevel opened = new LevelName("levels/samples/clouds-grid.json").open();
        PlacedLevel placed = opened.placed();
        View view = Viewpoints.standard(opened.level(), opened.file(), 4).view(0);
        try (var rays = new CloudRays(placed, view)) {
            CloudRays.Marched fine = rays.marched(0.5);
            CloudRays.Marched coarse = rays.marched(8);
            assertTrue(fine.evaluations() > 8 * coarse.evaluations(), fine + ", " + coarse);
            assertTrue(fine.transmittanceError() < 0.02, fine.toString());
            assertTrue(coarse.transmittanceError() > 2 * fine.transmittanceError(), fine + ", " + coarse);
        }
    }
}
