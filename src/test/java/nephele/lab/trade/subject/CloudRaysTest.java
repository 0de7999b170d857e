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
        View view = Viewpoints.standard(opened.level(), opened.file(), 4).apply(0);
        try (var rays = new CloudRays(placed, view)) {
            rays.march(0.5);
            double evaluations = rays.evaluations();
            double error = rays.transmittanceError();
            rays.march(8);
            assertTrue(evaluations > 8 * rays.evaluations(), evaluations + ", " + rays.evaluations());
            assertTrue(error < 0.02, Double.toString(error));
            assertTrue(rays.transmittanceError() > 2 * error, error + ", " + rays.transmittanceError());
        }
    }
}
