package nephele.engine.sim.state;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.Depenetration;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.json.LevelFile;
import nephele.engine.math.Vec3;
import nephele.engine.sim.state.PlayerDimensions.Stance;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class FreeStartTest {
    private static final CollisionWorld WORLD = CollisionWorld.of(
            LevelFile.load(Path.of("levels", "samples", "walking.json")).level());

    private static final SimLevel LEVEL = SimLevel.of(WORLD, null);

    private static boolean isFree(PlayerStart start) {
        var centre = start.feet().toVector().add(0, Stance.STANDING.centreAboveFeet(), 0, new Vector3d());
        return new Depenetration().isFree(WORLD, Stance.STANDING.shape(), centre);
    }

    @Test
    void theFeetAreBelowTheEyeAndTheViewIsTheCameras() {
        var start = SimLevel.startBelow(new Vec3(1, 5, 2), 30, -95);
        assertEquals(5 - Stance.STANDING.eyeMetres(), start.feet().y());
        assertEquals(30, start.yawDegrees());
        assertEquals(-90, start.pitchDegrees());
    }

    @Test
    void aFreeStartStays() {
        var start = new PlayerStart(new Vec3(0, 50, 0), 30, -20);
        assertEquals(start, LEVEL.freeStart(start));
    }

    @Test
    void aCameraNearTheFloorBecomesAPlayerOnTheFloor() {
        var low = SimLevel.startBelow(new Vec3(0, 0.3, 0), 0, 0);
        assertTrue(!isFree(low));
        var free = LEVEL.freeStart(low);
        assertTrue(isFree(free), free.toString());
        assertTrue(free.feet().minus(low.feet()).length() < 2, free.toString());
    }

    @Test
    void withoutSolidsNothingMoves() {
        var start = SimLevel.startBelow(Vec3.ZERO, 0, 0);
        assertEquals(start, SimLevel.of(new CollisionWorld(List.of()), null).freeStart(start));
    }
}
