package nephele.editor.action;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayDeque;
import java.util.Deque;
import nephele.editor.proving.HeatText;
import nephele.editor.proving.Proving;
import nephele.editor.proving.ProvingThreads;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Proofs in the background: what an edit or a camera has made obsolete is never shown. */
@Execution(ExecutionMode.CONCURRENT)
class ProvingThreadsTest {
    private final Deque<Runnable> work = new ArrayDeque<>();
    private final Deque<Runnable> results = new ArrayDeque<>();
    private final ScriptedSession room =
            ScriptedSession.empty().run("brush room min=-4,0,-4 max=4,4,4 wall=0.5 id=wall", "add player at=0,0.5,0");

    private Proving proving() {
        room.session().proving().runOn(new ProvingThreads(work::add, results::add));
        return room.session().proving();
    }

    private static void runAll(Deque<Runnable> tasks) {
        while (!tasks.isEmpty()) {
            tasks.poll().run();
        }
    }

    @Test
    void anObsoleteHeatMapIsNotShown() {
        Proving proving = proving();
        proving.heat().show(true);
        work.poll().run();
        room.run("select solids/wall-floor", "set portalable to=false");
        runAll(results);
        assertTrue(proving.heat().counts().isEmpty(), "that of the level before the edit");
        runAll(work);
        runAll(results);
        assertTrue(proving.heat().counts().get(HeatText.NOT_PORTALABLE) > 0);
    }

    @Test
    void anEditInTheMiddleOfTheWorkCancelsIt() {
        Proving proving = proving();
        proving.heat().show(true);
        Runnable first = work.poll();
        room.run("select solids/wall-floor", "set portalable to=false");
        first.run();
        assertTrue(results.isEmpty(), "a cancelled map has no result");
    }

    @Test
    void theTracedPictureBeginsAgainWhenTheCameraMoves() {
        Proving proving = proving();
        room.run("path-trace show=true spp=1");
        Runnable first = work.poll();
        room.run("camera at=0,1,3 yaw=90");
        assertEquals(1, work.size());
        first.run();
        runAll(results);
        assertTrue(proving.corner().traced().isEmpty());
        runAll(work);
        runAll(results);
        assertEquals(1, proving.corner().traced().orElseThrow().samples());
        room.run("grid metres=1");
        assertTrue(work.isEmpty(), "the same picture is not traced again");
        assertFalse(proving.corner().traced().isEmpty());
    }
}
